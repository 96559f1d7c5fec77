// The G-buffer: what is written is what is read, nearest surface first, masks cut, nothing drawn that cannot be seen.
#include "engine/effects/geometry/geometry.h"
#include "engine/effects/surface_push.h"
#include "shaders/camera.h"
#include "tests/engine/effects/drawn.hpp"
#include "tests/engine/upload/solids.hpp"

namespace afterglow
{
TEST(GBufferTexel, ComesBackAsItWas)
{
    GBufferTexel t;
    t.normal = normalize(vec3(0.3f, -0.9f, 0.2f));
    t.baseColor = vec3(0.8f, 0.05f, 0.0f);
    t.roughness = 0.37f;
    t.metallic = 1.0f;
    t.lightmapUv = vec2(0.25f, 0.999f);
    t.material = 32767u;
    t.mirrored = 1u;
    t.page = 3u;
    const GBufferTexel back = decodeGBuffer(encodeGBuffer(t));
    EXPECT_LT(length(back.normal - t.normal), 1e-4f); // 16 bits each way
    // The root is off by half of 1/255 at most: c = r^2 is off by 2 r / 510 + 1 / 510^2
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.baseColor[c], t.baseColor[c], 2.0f * std::sqrt(t.baseColor[c]) / 510.0f + 4e-6f);
    EXPECT_NEAR(back.roughness, t.roughness, 0.5f / 255.0f + 1e-6f);
    EXPECT_EQ(back.metallic, 1.0f);
    EXPECT_NEAR(back.lightmapUv.y, t.lightmapUv.y, 1e-5f);
    EXPECT_EQ(back.material, 32767u);
    EXPECT_EQ(back.mirrored, 1u);
    EXPECT_EQ(back.page, 3u);
}

// H21: scale 1 : 1000. A surface's normal stays at right angles to what lies in it.
TEST(Cofactors, KeepNormalsAtRightAnglesUnderUnevenScale)
{
    const mat3 m(vec3(1, 0, 0), vec3(0, 1000, 0), vec3(0, 0, 1));
    const vec3 tangent = normalize(vec3(1, 1, 0)), normal = normalize(vec3(1, -1, 0));
    EXPECT_LT(std::abs(dot(normalize(m * tangent), normalize(cofactors(m) * normal))), 1e-5f);
}

using Geometry = Drawn;

TEST_F(Geometry, DepthIsNearOverDistanceAndZeroInTheSky)
{
    // A wall 4 m away fills the right half of the view.
    addQuad(scene, vec3(0, -9, -4), vec3(9, 0, 0), vec3(0, 18, 0), addMaterial(scene, matte(vec3(0.5f))));
    const GpuLevel level(gpu, uploadScene(gpu, scene, instances(scene), {}), GpuBaked{});
    Camera camera = lookAt(vec3(0), vec3(0, 0, -1));
    camera.nearPlane = 0.25f;
    Graph graph;
    const GBuffer surfaces = geometry(graph, makeView(camera, size), level.scene, {});
    graph.output(surfaces.depth);
    executor.run(graph, level.set);
    const Image depth = executor.download(surfaces.depth);
    EXPECT_EQ(depth.at(2, 8)[0], 0.0f);
    EXPECT_NEAR(depth.at(13, 8)[0], 0.25f / 4.0f, 1e-6f);
}

TEST_F(Geometry, TheNearestSurfaceWinsInEitherOrder)
{
    scene.sky.radiance = vec3(1.0f);
    const uint white = addMaterial(scene, matte(vec3(1.0f))), black = addMaterial(scene, matte(vec3(0.0f)));
    for (const bool nearFirst : {true, false}) {
        scene.objects.clear();
        scene.meshes.clear();
        for (const bool isNear : {nearFirst, !nearFirst})
            addQuad(scene, vec3(-9, -9, isNear ? -2 : -3), vec3(18, 0, 0), vec3(0, 18, 0), isNear ? white : black);
        expectNear(middle(radiance(lookAt(vec3(0), vec3(0, 0, -1)))), vec3(1.0f), 1e-2f);
    }
}

TEST_F(Geometry, WhatLiesOutsideTheViewIsNotDrawn)
{
    const uint grey = addMaterial(scene, matte(vec3(0.5f)));
    addQuad(scene, vec3(-1, -1, 5), vec3(2, 0, 0), vec3(0, 2, 0), grey);  // behind
    addQuad(scene, vec3(-1, 90, -5), vec3(2, 0, 0), vec3(0, 2, 0), grey); // above
    radiance(lookAt(vec3(0), vec3(0, 0, -1)));
    EXPECT_EQ(stats.passes[0].draws, 0u);
}

// H51: alpha = cutoff keeps; all transparent is absent.
TEST_F(Geometry, MasksKeepAtTheCutoff)
{
    scene.sky.radiance = vec3(1.0f);
    Material mask = matte(vec3(0.0f));
    mask.flags |= kMaterialAlphaMask;
    for (const float alpha : {0.5f, 0.49f}) {
        scene.objects.clear();
        scene.meshes.clear();
        mask.baseColor.w = alpha;
        addQuad(scene, vec3(-9, -9, -2), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, mask));
        expectNear(middle(radiance(lookAt(vec3(0), vec3(0, 0, -1)))), vec3(alpha == 0.5f ? 0.0f : 1.0f), 1e-3f);
    }
}

// Two objects of one mesh are told apart, the primitives of one are not, and a masked surface takes part; with emission or without.
TEST_F(Geometry, EveryPixelKnowsItsObject)
{
    Material mask = matte(vec3(0.5f));
    mask.flags |= kMaterialAlphaMask;
    const uint grey = addMaterial(scene, matte(vec3(0.5f))), masked = addMaterial(scene, mask);
    addQuad(scene, vec3(-4, -4, -4), vec3(2, 0, 0), vec3(0, 8, 0), grey); // columns 0..3 of 16: 8 m wide at 4 m
    scene.objects.push_back(scene.objects[0]);
    scene.objects.back().toWorld[3].x = 2.0;                               // columns 4..7
    addQuad(scene, vec3(0, -4, -4), vec3(2, 0, 0), vec3(0, 8, 0), masked); // columns 8..11
    const GpuLevel level(gpu, uploadScene(gpu, scene, instances(scene), {}), GpuBaked{});
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1), 2.0f * std::atan(1.0f));
    for (const bool emission : {false, true}) {
        Graph graph;
        const GBuffer surfaces =
            geometry(graph, makeView(camera, size), level.scene, {.masked = true, .emission = emission, .objects = true});
        graph.output(surfaces.objects);
        executor.run(graph, level.set);
        const Image objects = executor.download(surfaces.objects);
        for (int x = 0; x < 16; ++x) EXPECT_EQ(objects.at(x, 8)[0], float(x < 12 ? 1 + x / 4 : 0)) << "column " << x;
    }
}

// A ball of eight pixels and a sun: by the law of mirrors it sends irradiance times radius^2 / 4 into every direction, whatever part of its
// highlight the middle of a pixel meets. The normal turns the faster the nearer it is to the rim, so the lobe is wider where it fades: that is
// 17 % too much. What the widened lobe loses between facets is not the metal's to give back, whether its roughness is a number or a texture.
TEST_F(Geometry, AHighlightFinerThanAPixelIsNeitherMissedNorCountedTwice)
{
    Material metal = matte(vec3(1.0f));
    metal.flags = 0u;
    metal.metallic = 1.0f;
    SceneTexture tenth;
    tenth.image = {1, 1, 4, {255, 26, 255, 255}};
    for (const bool textured : {false, true}) {
        scene = Scene{};
        scene.textures.push_back(tenth);
        metal.roughness = textured ? 1.0f : 0.1f;
        metal.metallicRoughnessTexture.texture = textured ? 0 : -1;
        addSphere(scene, addMaterial(scene, metal), 96);
        addLight(scene, sunLight(vec3(-1, 0.3f, -1.5f), vec3(4.0f)));
        double all = 0.0;
        for (int sample = 0; sample < 9; ++sample) {
            const vec3 shift(0.25f / 3.0f * float(sample % 3), 0.25f / 3.0f * float(sample / 3), 0.0f); // thirds of a pixel
            Camera camera = lookAt(vec3(0, 0, 5) + shift, shift);
            camera.fovY = 0.0f;
            camera.orthoHeight = 4.0f; // a pixel is 1/16 m^2
            const Image image = radiance(camera);
            double sent = 0.0;
            for (std::size_t i = 0; i < image.pixels.size(); i += 4) sent += double(image.pixels[i]) / 16.0;
            EXPECT_NEAR(sent, 1.0, 0.35) << "sample " << sample;
            all += sent / 9.0;
        }
        EXPECT_NEAR(all, 1.0, 0.2);
        std::printf("a highlight finer than a pixel: %.3f of its light\n", all);
    }
}

TEST_F(Geometry, AnEmptyLevelShowsItsSky)
{
    scene.sky.radiance = vec3(0.25f, 0.5f, 1.0f);
    expectNear(middle(radiance(lookAt(vec3(0), vec3(0, 0, -1)))), scene.sky.radiance, 1e-3f);
}
}
