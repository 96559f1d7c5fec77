// A toy level drawn by the effects alone, in the order of the frame; pictures come back as floats.
#pragma once
#include "engine/effects/display/display.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/lighting/lighting.hpp"
#include "engine/effects/occlusion/occlusion.hpp"
#include "engine/effects/outline/outline.hpp"
#include "engine/effects/reflection/reflection.hpp"
#include "engine/effects/shadow/shadow.hpp"
#include "engine/effects/toon/toon.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <array>

namespace afterglow
{
struct DrawnParts {
    bool shadow = false, reflection = false, fog = false, occlusion = false, toon = false;
    SunMaps sun = SunMaps::level;
    ShadowMethod shadowMethod = ShadowMethod::map;
    ShadowParameters shadowParameters = defaultShadowParameters();
    ReflectionMethod reflectionMethod = ReflectionMethod::screen;
    ReflectionParameters reflectionParameters = defaultReflectionParameters();
    FogParameters fogParameters = defaultFogParameters();
    OcclusionMethod occlusionMethod = OcclusionMethod::automatic;
    OcclusionParameters occlusionParameters = defaultOcclusionParameters();
    bool fogRemembers = false; // the pictures drawn before
    ToonParameters toonParameters = defaultToonParameters();
    OutlineParameters outline = defaultOutlineParameters(); // width 0: none
};

class Drawn : public Validated
{
protected:
    // What the test says of the level; baked.scene is not used, `scene` is.
    Scene scene;
    Baked baked;
    uvec2 size{16, 16};
    Executor executor{gpu};
    FogMemory fogMemory;
    FrameStats stats;
    std::vector<MeshLods> lods; // of each mesh, or none
    float mayStray = 0.0f;      // px
    uint frame = 0;             // seeds what is drawn by lot
    vec2 cornersOff{0.0f};      // px: how far beside its place the rasteriser shall put every triangle, as those do that snap corners

    std::vector<Instance> placed()
    {
        Baked all = baked;
        all.scene = scene;
        return placedInstances(all);
    }

    // As the rasteriser shall see the level; all other passes know nothing of it.
    View rastered(View view) const
    {
        mat4 aside(1.0f);
        aside[3] = vec4(2.0f * cornersOff / vec2(size), 0.0f, 1.0f);
        view.worldToClip = aside * view.worldToClip;
        return view;
    }

    // The furthest that corners on 256ths of a pixel may lie from their places.
    static std::array<vec2, 4> furthestOff()
    {
        const float half = 1.0f / 512.0f; // px
        return {vec2(half, half), vec2(half, -half), vec2(-half, half), vec2(-half, -half)};
    }

    // Scene-linear radiance as the camera sees it.
    Image radiance(const Camera& camera, const DrawnParts& parts = {})
    {
        const bool traced = parts.shadow && parts.shadowMethod == ShadowMethod::ray;
        const bool tracedContact = parts.occlusion && parts.occlusionMethod == OcclusionMethod::ray;
        GpuScene uploaded = uploadScene(gpu, scene, placed(), scene.lights, lods);
        const bool tracedMirrors = parts.reflection && parts.reflectionMethod == ReflectionMethod::ray;
        if (traced || tracedContact || tracedMirrors) uploaded.rays = buildRays(gpu, scene, placed());
        const GpuLevel level(gpu, std::move(uploaded), uploadBaked(gpu, baked, {}));
        FrameSample sample;
        sample.mayStray = mayStray;
        sample.frame = frame;
        const View view = makeView(camera, size, sample);
        GeometryParts geometryParts{.objects = parts.outline.width > 0.0f};
        LightingParts lightingParts{.lightmaps = !baked.lightmaps.empty(),
                                    .directional = !level.baked.directions.empty(),
                                    .probes = !baked.probes.empty(),
                                    .reflections = !baked.reflections.empty(),
                                    .fog = parts.fog,
                                    .mirrored = parts.reflection};
        bool clear = false;
        for (const DrawItem& item : level.scene.draws) {
            geometryParts.masked |= item.kind == DrawKind::masked;
            geometryParts.emission |= item.emits;
            geometryParts.facets |= item.roughMetal;
            clear |= item.kind == DrawKind::clear;
        }
        const Surroundings surroundings{meanSky(scene.sky), scene.sky.radiance, scene.sky.rotation};
        ShadowMaps maps;
        if (parts.shadow && !traced) maps = makeShadowMaps(gpu, level.scene, parts.shadowParameters, parts.sun);
        const GpuEdges edges =
            parts.outline.width > 0.0f ? uploadEdges(gpu, scene, level.scene.draws, parts.outline.creaseAngle) : GpuEdges{};

        if (!parts.fogRemembers) fogMemory = {};
        Graph graph;
        const GBuffer surfaces = geometry(graph, rastered(view), level.scene, geometryParts);
        Shadows shadows = parts.shadow ? shadow(graph, maps, level.scene, view) : Shadows{};
        if (traced) shadows.traced = tracedShadows(graph, view, surfaces, level.scene, parts.shadowParameters);
        Texture visibility;
        GpuVoxels voxels;
        if (parts.occlusion && parts.occlusionMethod == OcclusionMethod::voxel) voxels = uploadVoxels(gpu, voxelize(scene, false));
        const Occluders occluders{voxels, level.scene.rays};
        if (parts.occlusion) visibility = occlusion(graph, view, surfaces, occluders, parts.occlusionMethod, parts.occlusionParameters);
        Lit lit = lighting(graph, view, surfaces, shadows, visibility, level, surroundings, lightingParts);
        if (parts.toon) toon(graph, surfaces, shadows, level, lit, lightingParts, toonRamps(scene, parts.toonParameters));
        if (parts.reflection)
            lit = reflection(graph, view, surfaces, shadows, level, lit, lightingParts, parts.reflectionMethod, parts.reflectionParameters);
        if (clear) clearSurfaces(graph, view, surfaces, shadows, level, lit, lightingParts);
        Texture image = lit.radiance;
        if (parts.fog) image = fog(graph, &fogMemory, view, surfaces, shadows, level, surroundings.ambient, image, parts.fogParameters);
        if (parts.outline.width > 0.0f) outline(graph, view, surfaces, level, edges, image, parts.outline);
        graph.output(image);
        stats = executor.run(graph, level.set);
        return executor.download(image);
    }

    // Of the light from everywhere, as the occlusion's methods find it: 1 = open.
    Image visibility(const Camera& camera, OcclusionMethod method, const OcclusionParameters& parameters, std::size_t most = kMostVoxels,
                     bool mapped = true)
    {
        GpuScene uploaded = uploadScene(gpu, scene, placed(), {});
        if (method == OcclusionMethod::ray) uploaded.rays = buildRays(gpu, scene, placed());
        const GpuLevel level(gpu, std::move(uploaded), {});
        const View view = makeView(camera, size);
        GpuVoxels voxels;
        if (method == OcclusionMethod::voxel) voxels = uploadVoxels(gpu, voxelize(scene, false, most));
        Graph graph;
        const Texture open = occlusion(graph, view, geometry(graph, rastered(view), level.scene, {}), {voxels, level.scene.rays}, method,
                                       parameters, mapped);
        graph.output(open);
        stats = executor.run(graph, level.set);
        return executor.download(open);
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
