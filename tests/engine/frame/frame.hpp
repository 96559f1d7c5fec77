// The fixture of the tests of whole frames.
#pragma once
#include "engine/core/error.hpp"
#include "engine/frame/frame.hpp"
#include "engine/gpu/readback.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/solids.hpp"
#include <cmath>

namespace afterglow
{
class FrameTest : public Validated
{
protected:
    // A white room lit by an emissive ceiling panel, seen from a corner; baked or not.
    FrameTest()
    {
        addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, matte(vec3(0.6f, 0.5f, 0.4f))));
        Material lamp = matte(vec3(0.0f));
        lamp.emission = vec3(5.0f);
        addQuad(scene, vec3(-0.5f, 1.9f, -0.5f), vec3(1, 0, 0), vec3(0, 0, 1), addMaterial(scene, lamp));
        camera = lookAt(vec3(-1.5f, 0, 1.5f), vec3(1, -0.5f, -1));
    }

    Image8 draw(const Scene& level, const Baked* baked, const std::string& effects, uvec2 size = {64, 48})
    {
        Settings settings;
        settings.size = size;
        settings.effects = parseOverrides(effects);
        settings.occlusionMethod = occlusionMethod;
        settings.reflectionMethod = reflectionMethod;
        Stage stage = makeStage(gpu, level, baked, settings);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, size), settings);
        graph.output(pictures.displayed);
        Executor executor(gpu);
        stats = executor.run(graph, stage.level->set);
        return readback8(gpu.memory, executor.image(pictures.displayed));
    }

    bool ran(const std::string& pass) const
    {
        for (const PassStats& p : stats.passes)
            if (p.name.rfind(pass, 0) == 0) return true;
        return false;
    }

    Scene scene;
    Camera camera;
    FrameStats stats;
    OcclusionMethod occlusionMethod = OcclusionMethod::automatic;
    ReflectionMethod reflectionMethod = ReflectionMethod::screen;
};
}
