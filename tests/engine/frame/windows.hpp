// The fixture of the tests of mirrors and portals in whole frames.
#pragma once
#include "engine/frame/windows.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <algorithm>
#include <cmath>
#include <utility>

namespace afterglow
{
// Radiance is kept as half floats, 2^-11, twice.
inline constexpr float kHalves = 2e-3f;

class WindowsTest : public Validated
{
protected:
    Scene scene;
    Baked baked;
    bool isBaked = false;
    Settings settings;
    FrameStats stats;
    Image sum; // of the picture's layers, when they are asked for
    Executor executor{gpu};

    WindowsTest() { settings.size = {64, 48}; }

    Image draw(const Scene& level, const Camera& camera)
    {
        baked.scene = level;
        Stage stage = makeStage(gpu, level, isBaked ? &baked : nullptr, settings);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, settings.size), settings);
        const Layers& l = pictures.layers;
        graph.output(pictures.radiance);
        for (const Texture& layer : {l.direct, l.indirect, l.reflection, l.emission})
            if (layer) graph.output(layer);
        stats = executor.run(graph, stage.level->set);
        Image picture = executor.download(pictures.radiance);
        sum = Image(picture.width, picture.height, 4);
        for (const Texture& layer : {l.direct, l.indirect, l.reflection, l.emission}) {
            if (!layer) continue;
            const Image part = executor.download(layer);
            for (std::size_t i = 0; i < sum.pixels.size(); ++i) sum.pixels[i] += part.pixels[i];
        }
        return picture;
    }
    std::size_t ran(const std::string& pass) const
    {
        return std::size_t(std::count_if(stats.passes.begin(), stats.passes.end(), [&](const PassStats& p) { return p.name == pass; }));
    }

    // An ideal mirror: a metal of roughness 0 that reflects everything, at every angle.
    static Material mirror(float roughness = 0.0f)
    {
        Material m = matte(vec3(1.0f));
        m.flags = kMaterialMirror;
        m.metallic = 1.0f;
        m.roughness = roughness;
        return m;
    }
    static Material lamp(vec3 emission)
    {
        Material m = matte(vec3(0.0f));
        m.emission = emission;
        m.flags |= kMaterialDoubleSided;
        return m;
    }
    uint lampOf(vec3 emission) { return addMaterial(scene, lamp(emission)); }

    // Where the surfaces of that material are seen: the picture with everything black but them.
    std::vector<bool> seen(uint material, const Camera& camera)
    {
        Scene level = scene;
        for (Object& object : level.objects) object.portal.clear(), object.mirror = false;
        for (uint i = 0; i < level.materials.size(); ++i) level.materials[i] = lamp(vec3(i == material ? 1.0f : 0.0f));
        level.sky = {};
        const bool wasBaked = std::exchange(isBaked, false);
        const Image mask = draw(level, camera);
        isBaked = wasBaked;
        std::vector<bool> pixels;
        for (int i = 0; i < mask.width * mask.height; ++i) pixels.push_back(mask.pixels[std::size_t(i) * 4] > 0.5f);
        return pixels;
    }

    // Of the pixels of `mask`, how many differ.
    static int differing(const Image& a, const Image& b, const std::vector<bool>& mask)
    {
        int count = 0;
        for (std::size_t i = 0; i < mask.size(); ++i) {
            bool same = true;
            for (std::size_t c = 0; c < 3; ++c) {
                const float x = a.pixels[i * 4 + c], y = b.pixels[i * 4 + c];
                same &= std::abs(x - y) <= kHalves * std::max(std::abs(y), 1e-2f);
            }
            count += mask[i] && !same;
        }
        return count;
    }
    static vec3 at(const Image& image, ivec2 pixel)
    {
        const float* p = image.at(pixel.x, pixel.y);
        return vec3(p[0], p[1], p[2]);
    }
    ivec2 pixelOf(const Camera& camera, vec3 world) const
    {
        const vec4 clip = makeView(camera, settings.size).worldToClip * vec4(world, 1.0f);
        return ivec2((vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(settings.size));
    }

    // A floor at y = 0, and above it lamps and a lit wall, none of them alike.
    uint furnish(const Material& floor)
    {
        const uint water = addMaterial(scene, floor);
        addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), water).mirror = true;
        addQuad(scene, vec3(-2, 0.31f, -4), vec3(1, 0.1f, 0), vec3(0, 1.1f, 0.2f), lampOf(vec3(3, 1, 0.5f)));
        addQuad(scene, vec3(0.4f, 0.13f, -5), vec3(1.3f, 0, -1), vec3(0.2f, 2, 0), lampOf(vec3(0.2f, 2, 1)));
        addQuad(scene, vec3(-3, 0.5f, -6), vec3(6, 0, 0), vec3(0, 4, 0), addMaterial(scene, matte(vec3(0.64f, 0.3f, 0.2f))));
        addLight(scene, pointLight(vec3(0.3f, 2.5f, -3), vec3(40.0f)));
        scene.sky.radiance = vec3(0.25f, 0.5f, 1.0f);
        return water;
    }
    // The same world under the floor, and no floor.
    Scene upsideDown() const
    {
        Scene level = scene;
        level.objects.erase(level.objects.begin());
        for (Vertex& v : level.vertices) v.position.y = -v.position.y, v.normal.y = -v.normal.y;
        for (std::size_t i = 0; i + 2 < level.indices.size(); i += 3) std::swap(level.indices[i + 1], level.indices[i + 2]);
        for (Light& light : level.lights) light.position.y = -light.position.y;
        return level;
    }
};
}
