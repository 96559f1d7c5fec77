// Surfaces that no lightmap lights: what the irradiance probes say, by the law of the CPU.
#include "engine/baked/probe_read.hpp"
#include "shaders/probe.h"
#include "tests/engine/effects/before_wall.hpp"
#include "tests/engine/upload/solids.hpp"
#include <random>

namespace afterglow
{
class ProbeLighting : public BeforeWall
{
};

TEST_F(ProbeLighting, WhatMovesIsLitByItsProbes)
{
    wall(matte(vec3(0.64f))).isStatic = false;
    baked = bakedEvenly(scene, vec3(9.0f));
    baked.probes = evenProbes(vec3(-3), vec3(3), vec3(0.5f, 1.0f, 2.0f));
    expectNear(middle(radiance(camera)), 0.64f * vec3(0.5f, 1.0f, 2.0f), kHalfError);
}

// H83: outside of the probes' box the border's value holds; the sky does not break in.
TEST_F(ProbeLighting, OutsideOfTheProbesTheirBorderHolds)
{
    scene.sky.radiance = vec3(1000.0f);
    wall(matte(vec3(0.64f))).isStatic = false;
    baked = bakedEvenly(scene, vec3(9.0f));
    baked.probes = evenProbes(vec3(-1), vec3(1), vec3(1.0f)); // ends 1 m before the wall
    expectNear(middle(radiance(camera)), vec3(0.64f), kHalfError);
}

// Between the probes of a cell their light goes over evenly; beyond a wall's plane it is the other cell's, however near.
TEST_F(ProbeLighting, AWallBetweenTwoCellsKeepsTheirLightApart)
{
    wall(matte(vec3(0.64f))).isStatic = false;
    baked = bakedEvenly(scene, vec3(9.0f));
    baked.probes = evenProbes(vec3(-3), vec3(3), vec3(0.5f));
    append(baked.probes, evenProbes(vec3(-3), vec3(3), vec3(4.0f)));
    for (const float side : {-1.0f, 1.0f}) { // the wall of the picture stands at z = -2
        baked.probes.nodes = {{vec3(0, 0, 1), -2.0f + side * 0.01f, ~0, ~1}};
        expectNear(middle(radiance(camera)), 0.64f * vec3(side < 0.0f ? 4.0f : 0.5f), kHalfError);
    }
}

// Along the silhouettes of cards that hang before a wall, what the neighbours of a pixel show says nothing of the wall's side; nor does a steep
// normal map say it anywhere.
TEST_F(ProbeLighting, NoPixelAsksBeyondItsWall)
{
    for (const bool bent : {false, true}) {
        scene = Scene{};
        Material plaster = matte(vec3(0.64f));
        if (bent) {
            plaster.normalTexture.texture = 0;
            plaster.normalScale = 1.0f;
            SceneTexture map;
            map.image = {1, 1, 4, {250, 100, 135, 255}}; // 87 degrees
            scene.textures.push_back(map);
        }
        wall(plaster).isStatic = false;
        const uint card = addMaterial(scene, matte(vec3(0.64f)));
        for (int i = 0; i < 12; i++) {
            const vec3 across(0.1f, 0.2f * float(i % 3), 0.05f * float(i % 2)), up(0.05f * float(i % 4), 0.3f, 0);
            addQuad(scene, vec3(0.5f * float(i) - 4.0f, -1.0f + 0.2f * float(i % 5), -1.9f), across, up, card).isStatic = false;
        }
        baked = bakedEvenly(scene, vec3(9.0f));
        baked.probes = evenProbes(vec3(-9), vec3(9), vec3(0.5f));
        append(baked.probes, evenProbes(vec3(-9), vec3(9), vec3(7.0f)));
        baked.probes.nodes = {{vec3(0, 0, 1), -2.0f, ~1, ~0}};
        size = {128, 72};
        const Image picture = radiance(lookAt(vec3(-6, 0, -1), vec3(0, 0, -2)));
        int lit = 0;
        for (std::size_t i = 0; i < picture.pixels.size(); i += 4) {
            ASSERT_LE(picture.pixels[i], 0.64f * 0.5f + kHalfError) << "pixel " << i / 4 << (bent ? ", bent" : "");
            lit += picture.pixels[i] > 0.64f * 0.5f - kHalfError ? 1 : 0;
        }
        EXPECT_GT(lit, 3000) << "of 9216 pixels, the sky's are black";
    }
}

// Eight cells of probes that differ in every number, walls between them that cross: each pixel is what the law on the CPU says.
TEST_F(ProbeLighting, EveryPixelAsksTheProbesByTheLawOfTheCpu)
{
    std::mt19937 engine{3u};
    const auto number = [&] { return float(engine() >> 8u) / 16777216.0f; };
    wall(matte(vec3(1.0f))).isStatic = false;
    baked = bakedEvenly(scene, vec3(9.0f));
    for (uint cell = 0; cell < 8; cell++) {
        const vec3 lower(cell & 1u ? 0.0f : -1.0f, cell & 2u ? 0.0f : -1.0f, -2.5f);
        append(baked.probes, evenProbes(lower, lower + 1.0f, vec3(4.0f)));
    }
    for (Probe& probe : baked.probes.probes) {
        for (vec3& c : probe.irradiance.c) c += vec3(number(), number(), number());
        probe.lobe = vec3(number(), number(), number());
        probe.toward = normalize(vec3(number(), number(), number()) - 0.5f);
    }
    baked.probes.nodes = {{normalize(vec3(1, 0.23f, 0)), 0.01f, 1, 2},
                          {vec3(0, 1, 0), 0.0f, 3, 4},
                          {vec3(0, 1, 0), 0.1f, 5, 6},
                          {vec3(0, 0, 1), -1.9f, ~0, ~4},
                          {vec3(0, 0, 1), -2.1f, ~2, ~6},
                          {vec3(0, 0, 1), -2.2f, ~1, ~5},
                          {vec3(1, 0, 0), 0.5f, ~3, ~7}};
    const ProbeSet law{&baked.probes};
    const View view = makeView(camera, size);
    const Image picture = radiance(camera);
    for (uint y = 0; y < size.y; y++)
        for (uint x = 0; x < size.x; x++) {
            const ViewRay ray = viewRay((vec2(x, y) + 0.5f) / vec2(size), 0.0f, view.clipToWorld, view.eye);
            const vec3 at = ray.origin + ray.direction * (-2.0f / ray.direction.z), lit = probeLookup(law, at, vec3(0, 0, 1));
            const float* pixel = picture.at(int(x), int(y));
            expectNear({pixel[0], pixel[1], pixel[2]}, lit, kHalfError);
        }
}

// A leaf under a lamp: its front has a lightmap, its back is lit by what the probes know.
TEST_F(ProbeLighting, TheBackOfASurfaceIsLitByTheProbes)
{
    for (const bool clear : {false, true}) {
        scene = Scene{};
        Material leaf = matte(vec3(0.64f));
        leaf.flags |= kMaterialDoubleSided | (clear ? kMaterialAlphaBlend : 0u);
        wall(leaf);
        baked = bakedEvenly(scene, vec3(2.0f));
        baked.probes = evenProbes(vec3(-9), vec3(9), vec3(0.5f));
        append(baked.probes, evenProbes(vec3(-9), vec3(9), vec3(7.0f)));
        baked.probes.nodes = {{vec3(0, 0, 1), -2.0f, ~0, ~1}}; // in the leaf's own plane: its back is before it
        expectNear(middle(radiance(camera)), vec3(0.64f * 2.0f), 5e-3f);
        expectNear(middle(radiance(lookAt(vec3(0, 0, -4), vec3(0, 0, -2)))), vec3(0.64f * 0.5f), 5e-3f);
    }
}
}
