// Levels whose occlusion is known, and what the methods find of it.
#pragma once
#include "shaders/sampling.h"
#include "shaders/visibility.h"
#include "tests/engine/effects/drawn.hpp"
#include <span>

namespace afterglow
{
// Mean absolute errors that the methods may have, of pictures whose occluders the screen shows.
struct Method {
    OcclusionMethod method;
    const char* name;
    float bound;
};
const Method kMethods[] = {{OcclusionMethod::ssao, "ssao", 0.10f},
                           {OcclusionMethod::hbao, "hbao", 0.05f},
                           {OcclusionMethod::voxel, "voxel", 0.08f},
                           {OcclusionMethod::ray, "ray", 0.02f}};

class Occlusion : public Drawn
{
protected:
    // Those that the device can.
    std::span<const Method> methods() const { return std::span(kMethods).first(gpu.device.rayQuery ? 4 : 3); }
    uint grey() { return scene.materials.empty() ? addMaterial(scene, matte(vec3(0.64f))) : 0u; }
    void floor(float half = 5.0f) { addQuad(scene, vec3(-half, 0, -half), vec3(0, 0, 2 * half), vec3(2 * half, 0, 0), grey()); }
    // Across the view at x = `at`, its front towards -x, and `height` m high.
    void wall(float at, float height) { addQuad(scene, vec3(at, 0, 5), vec3(0, 0, -10), vec3(0, height, 0), grey()); }
    // A plane that meets the floor along z at x = 0, at an angle in degrees.
    void slope(float degrees)
    {
        const float angle = degrees * kPi / 180.0f;
        addQuad(scene, vec3(0, 0, 5), vec3(0, 0, -10), 5.0f * vec3(-std::cos(angle), std::sin(angle), 0), grey());
    }
    // A square well: half its width 1 m, its floor at y = 0.
    void pit(float depth)
    {
        addQuad(scene, vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
        for (const vec3 side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
            const vec3 along = cross(vec3(0, 1, 0), side);
            addQuad(scene, side - along, 2.0f * along, vec3(0, depth, 0), grey());
        }
    }

    // Whether a ray meets a quad of the scene nearer than `range`.
    bool meets(vec3 from, vec3 way, float range) const
    {
        for (std::size_t q = 0; q + 3 < scene.vertices.size(); q += 4) {
            const vec3 corner = scene.vertices[q].position, u = scene.vertices[q + 1].position - corner,
                       v = scene.vertices[q + 3].position - corner;
            const vec3 normal = cross(u, v);
            const float along = dot(way, normal);
            if (std::abs(along) < 1e-9f) continue;
            const float t = dot(corner - from, normal) / along;
            if (!(t > 1e-4f && t < range)) continue;
            const vec3 at = from + way * t - corner;
            const float a = dot(at, u) / dot(u, u), b = dot(at, v) / dot(v, v); // u and v are at right angles
            if (a >= 0 && a <= 1 && b >= 0 && b <= 1) return true;
        }
        return false;
    }
    // By rays: right to a few in a thousand.
    float open(vec3 from, vec3 normal, float range, int rays = 4096) const
    {
        int hit = 0;
        const Frame frame = makeFrame(normal);
        for (int i = 0; i < rays; ++i) // Roberts' R2 sequence
            hit += meets(
                from, toWorld(frame, sampleCosineHemisphere(vec2(fract(0.5 + double(i) * dvec2(0.7548776662466927, 0.5698402909980532))))),
                range);
        return 1.0f - float(hit) / float(rays);
    }

    static float least(const Image& image)
    {
        float result = 1.0f;
        for (int i = 0; i < image.width * image.height; ++i) result = std::min(result, image.pixels[std::size_t(i) * image.channels]);
        return result;
    }
    static float at(const Image& image, int x, int y) { return image.at(x, y)[0]; }
    static OcclusionParameters within(float range)
    {
        OcclusionParameters p = defaultOcclusionParameters();
        p.range = range;
        return p;
    }
    // Where a pixel's ray meets the floor.
    vec3 onFloor(const Camera& camera, int x, int y) const
    {
        const View view = makeView(camera, size);
        const vec4 far_ = view.clipToWorld * vec4((vec2(x, y) + 0.5f) / vec2(size) * 2.0f - 1.0f, 0.5f, 1.0f);
        const vec3 eye(camera.toWorld[3]), way = vec3(far_) / far_.w - eye;
        return eye - way * (eye.y / way.y);
    }
    // Mean absolute error over the pixels of the floor with -2 < x < -0.02 and |z| < 1.
    float floorError(const Camera& camera, OcclusionMethod method, const OcclusionParameters& p, std::size_t most = kMostVoxels)
    {
        const Image image = visibility(camera, method, p, most);
        double sum = 0;
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const vec3 place = onFloor(camera, x, y);
                if (!(place.x > -2.0f && place.x < -0.02f && std::abs(place.z) < 1.0f)) continue;
                sum += double(std::abs(at(image, x, y) - open(place + vec3(0, 1e-4f, 0), vec3(0, 1, 0), p.range, 1024)));
                ++count;
            }
        EXPECT_GT(count, 50);
        return float(sum / count);
    }
};
}
