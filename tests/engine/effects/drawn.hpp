// A toy level drawn by the effects alone, in the order of the frame; pictures come back as floats.
#pragma once
#include "engine/effects/display/display.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/lighting/lighting.hpp"
#include "engine/effects/reflection/reflection.hpp"
#include "engine/effects/shadow/shadow.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
struct DrawnParts {
    bool shadow = false, reflection = false, fog = false;
    SunMaps sun = SunMaps::level;
    ReflectionParameters reflectionParameters = defaultReflectionParameters();
    FogParameters fogParameters = defaultFogParameters();
};

class Drawn : public Validated
{
protected:
    // What the test says of the level; baked.scene is not used, `scene` is.
    Scene scene;
    Baked baked;
    uvec2 size{16, 16};
    Executor executor{gpu};
    FrameStats stats;

    std::vector<Instance> placed()
    {
        Baked all = baked;
        all.scene = scene;
        return placedInstances(all);
    }

    // Scene-linear radiance as the camera sees it.
    Image radiance(const Camera& camera, const DrawnParts& parts = {})
    {
        const GpuLevel level(gpu, uploadScene(gpu, scene, placed(), scene.lights), uploadBaked(gpu, baked, {}));
        const View view = makeView(camera, size);
        GeometryParts geometryParts;
        LightingParts lightingParts{.lightmaps = !baked.lightmaps.empty(),
                                    .probes = !baked.probes.empty(),
                                    .reflections = !baked.reflections.empty(),
                                    .fog = parts.fog,
                                    .mirrored = parts.reflection};
        bool clear = false;
        for (const DrawItem& item : level.scene.draws) {
            geometryParts.masked |= item.kind == DrawKind::masked;
            geometryParts.emission |= item.emits;
            clear |= item.kind == DrawKind::clear;
        }
        const Surroundings surroundings{meanSky(scene.sky), scene.sky.radiance, scene.sky.rotation};
        const ShadowParameters shadowParameters = defaultShadowParameters();
        ShadowMaps maps;
        if (parts.shadow) maps = makeShadowMaps(gpu, level.scene, shadowParameters, parts.sun);

        Graph graph;
        const GBuffer surfaces = geometry(graph, view, level.scene, geometryParts);
        const Shadows shadows = parts.shadow ? shadow(graph, maps, level.scene, view) : Shadows{};
        Lit lit = lighting(graph, view, surfaces, shadows, level, surroundings, lightingParts);
        if (parts.reflection) lit = reflection(graph, view, surfaces, lit, lightingParts.reflections, parts.reflectionParameters);
        if (clear) clearSurfaces(graph, view, surfaces, shadows, level, lit, lightingParts);
        Texture image = lit.radiance;
        if (parts.fog) image = fog(graph, view, surfaces, shadows, level, surroundings.ambient, image, parts.fogParameters);
        graph.output(image);
        stats = executor.run(graph, level.set);
        return executor.download(image);
    }

    // The middle of the picture.
    vec3 middle(const Image& image) const
    {
        const float* p = image.at(image.width / 2, image.height / 2);
        return vec3(p[0], p[1], p[2]);
    }
};

inline void expectNear(const vec3& got, const vec3& wanted, float relative)
{
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(got[c], wanted[c], relative * std::max(std::abs(wanted[c]), 1e-3f)) << "channel " << c;
}
}
