// Screen-space reflection against what mirrors and lobes show by paper: pixel by pixel where the picture knows it, and nothing at all where
// it does not.
#include "shaders/surface.h"
#include "tests/engine/effects/mirrors.hpp"

namespace afterglow
{
class ScreenReflection : public Mirrors
{
};

// The floor's image of the wall, pixel by pixel: by the mirrored ray a pixel of the floor at distance d sees the wall at the height above
// the floor of e (D - d) / d, the law of `ssr.wall_row`. Pixels within a pixel of a band's border, or near the picture's, are not judged.
TEST_F(ScreenReflection, AMirrorFloorShowsEachBandOfTheWallWhereTheMirroredRayMeetsIt)
{
    floorTo(-10, metal(0.0f));
    bands(4);
    const Image picture = mirrored(camera), plain = radiance(camera);
    int judged = 0;
    for (int y = 0; y < int(size.y); ++y)
        for (int x = 16; x < int(size.x) - 16; ++x) {
            const auto height = [&](int row) {
                const vec3 p = onFloor(eyeRay(camera, x, row));
                return (10.0f + p.z) / -p.z; // e = 1
            };
            if (!(eyeRay(camera, x, y).direction.y < 0.0f) || !(height(y) > 0.0f) || y + 1 == int(size.y)) continue;
            const float h = height(y), apart = 1.0f * std::abs(height(y + 1) - h);
            if (std::floor(h - apart) != std::floor(h + apart) || h - apart < 0.0f) continue;
            if (h > 2.2f) continue; // above it the picture ends, and the image fades
            expectNear(at(picture, x, y), bandColor(int(h)), 4e-3f);
            EXPECT_EQ(at(plain, x, y), vec3(0.0f));
            ++judged;
        }
    EXPECT_GT(judged, 500);
}

// A parallel eye sees the same laws without a vanishing point: along -z and downwards by 30 degrees.
TEST_F(ScreenReflection, AnOrthographicEyeSeesTheMirroredWallToo)
{
    floorTo(-10, metal(0.0f));
    bands(4);
    Camera parallel = lookAt(vec3(0, 4, 0), vec3(0, 4 - 5.7735f, -10));
    parallel.fovY = 0.0f;
    parallel.orthoHeight = 8.0f;
    const Image picture = mirrored(parallel);
    int judged = 0;
    for (int y = 8; y < int(size.y) - 8; ++y)
        for (int x = 16; x < int(size.x) - 16; ++x) {
            const ViewRay ray = eyeRay(parallel, x, y);
            const vec3 p = onFloor(ray);
            const float h = (p.z + 10.0f) * ray.direction.y / ray.direction.z, pixel = 8.0f / float(size.y);
            if (!(h > 0.15f) || h > 3.0f || std::abs(h - std::round(h)) < 1.5f * pixel) continue;
            expectNear(at(picture, x, y), bandColor(int(h)), 4e-3f);
            ++judged;
        }
    EXPECT_GT(judged, 200);
}

// Rays are those of every second pixel: where a mirror's image ends, the rows and columns between end it where they themselves would.
TEST_F(ScreenReflection, AnImageEndsWhereItIsOnEveryRow)
{
    floorTo(-20, metal(0.0f));
    addQuad(scene, vec3(-1.5f, -1, -6), vec3(2.7f, 0, 0), vec3(0.3f, 1.6f, 0), lamp(vec3(1.0f)));
    const Image picture = mirrored(camera);
    int judged = 0;
    for (int y = 0; y < int(size.y); ++y) {
        // Across a row the mirrored rays meet the panel's plane along a line
        const auto met = [&](int x) {
            const ViewRay ray = eyeRay(camera, x, y);
            const vec3 p = onFloor(ray), d = ray.direction * vec3(1, -1, 1);
            return p + d * ((-6.0f - p.z) / d.z);
        };
        const vec3 first = met(0), last = met(int(size.x) - 1);
        if (!(eyeRay(camera, 0, y).direction.y < 0.0f) || first.y < -0.9f || first.y > 0.5f) continue;
        const double wanted = double(2.7f / (last.x - first.x) * float(size.x - 1)); // px
        double width = 0.0;
        for (int x = 0; x < int(size.x); ++x) width += double(at(picture, x, y).x);
        EXPECT_NEAR(width, wanted, 1.0) << y; // pixels are one place each
        ++judged;
    }
    EXPECT_GT(judged, 10);
}

// H70, H65, roughness 1: where the screen can know nothing, every bit is what lighting made it.
TEST_F(ScreenReflection, WhereTheScreenKnowsNothingEveryBitStays)
{
    scene.sky.radiance = vec3(3.0f, 2.0f, 1.0f);
    floorTo(-1000, metal(0.1f));
    EXPECT_EQ(mirrored(camera).pixels, radiance(camera).pixels) << "a floor under the sky: no halo at the horizon";

    addQuad(scene, vec3(-60, -1, -10), vec3(120, 0, 0), vec3(0, 9, 0), lamp(vec3(5.0f)));
    scene.materials[0] = metal(1.0f);
    EXPECT_EQ(mirrored(camera).pixels, radiance(camera).pixels) << "roughness 1";
    scene.materials[0] = metal(kScreenRoughness);
    EXPECT_EQ(mirrored(camera).pixels, radiance(camera).pixels) << "the limit itself";
    scene.materials[0] = matte(vec3(0.5f));
    EXPECT_EQ(mirrored(camera).pixels, radiance(camera).pixels) << "nothing glossy";
    scene.materials[0] = metal(0.1f);
    EXPECT_NE(mirrored(camera).pixels, radiance(camera).pixels) << "and this test can fail";
}

// H70: a mirror across the view sends every ray back past the eye; a lamp between them shows the eye its front, the mirror its back.
TEST_F(ScreenReflection, AMirrorAcrossTheViewDoesNotShowTheFrontsOfWhatStandsBeforeIt)
{
    for (const float tilt : {0.0f, 0.3f, -0.7f, 1.5f}) {
        scene = Scene{};
        addQuad(scene, vec3(-9, -9, -5), vec3(18, 0, 0), vec3(0, 18, 18 * tilt), addMaterial(scene, metal(0.0f)));
        addQuad(scene, vec3(-0.5f, -0.5f, -3), vec3(1, 0, 0), vec3(0, 1, 0), lamp(vec3(5.0f)));
        const Camera straight = lookAt(vec3(0), vec3(0, 0, -1), 1.2f);
        EXPECT_EQ(mirrored(straight).pixels, radiance(straight).pixels) << tilt;
    }
}

// A panel hangs before the wall. Rays that the floor sends to the wall pass far behind it: its colour has no place in their pixels.
TEST_F(ScreenReflection, WhatHangsBeforeTheRayIsNotMetByIt)
{
    floorTo(-10, metal(0.0f));
    addQuad(scene, vec3(-60, -1, -10), vec3(120, 0, 0), vec3(0, 4, 0), lamp(vec3(1, 0, 0)));
    addQuad(scene, vec3(-0.4f, -0.1f, -2), vec3(0.8f, 0, 0), vec3(0, 0.25f, 0), lamp(vec3(0, 9, 0)));
    const Image picture = mirrored(camera);
    int judged = 0;
    for (int y = 0; y < int(size.y); ++y)
        for (int x = 0; x < int(size.x); ++x) {
            const ViewRay ray = eyeRay(camera, x, y);
            if (!(ray.direction.y < 0.0f)) continue;
            const vec3 p = onFloor(ray);
            if (p.z > -2.5f || p.z < -10.0f) continue; // the panel hangs at z = -2: nothing beyond it mirrors it
            const vec3 seen = ray.origin + ray.direction * (-2.0f / ray.direction.z);
            if (std::abs(seen.x) < 0.45f && seen.y > -0.15f && seen.y < 0.2f) continue; // the panel itself
            if (std::abs(std::abs(seen.x) - 0.4f) < 0.035f) continue; // its border's column, a pixel wide: colours are filtered
            EXPECT_LT(at(picture, x, y).y, 0.02f) << x << ' ' << y;
            ++judged;
        }
    EXPECT_GT(judged, 500);
}

// A glossy floor sees the wall through its lobe: the truth is an integral over facets, the screen's answer a few wide taps around one ray.
// Above the wall and beside it is nothing, and lighting's own answer is black: what the screen misses is no error here.
TEST_F(ScreenReflection, AGlossyFloorShowsTheMeanOfItsLobe)
{
    size = {192, 128};
    floorTo(-10, metal(0.0f));
    bands(2);
    const auto wall = [](vec3 p, vec3 d) {
        if (!(d.z < 0.0f)) return vec3(0.0f);
        const float y = p.y + d.y * (10.0f + p.z) / -d.z;
        return y > -1.0f && y < 1.0f ? bandColor(int(y + 1.0f)) : vec3(0.0f);
    };
    for (const float roughness : {0.05f, 0.1f, 0.15f, 0.2f, 0.26f}) {
        scene.materials[0].roughness = roughness;
        const Image picture = mirrored(camera);
        double squares = 0.0, sum = 0.0, got = 0.0;
        int judged = 0;
        for (int y = 66; y < 124; ++y)
            for (const int x : {60, 97, 130}) {
                const ViewRay ray = eyeRay(camera, x, y);
                const vec3 p = onFloor(ray);
                if (!(ray.direction.y < 0.0f) || p.z < -9.8f) continue;
                if (std::abs((10.0f + p.z) / -p.z - 2.0f) < 0.1f) continue; // the wall's upper edge, half a pixel of which is sky
                const Frame frame = makeFrame(vec3(0, 1, 0));
                const vec3 o = toLocal(frame, -ray.direction);
                const vec2 alpha(std::max(roughness * roughness, kMirrorAlpha));
                vec3 truth(0.0f);
                const int samples = 512;
                for (int k = 0; k < samples; ++k) {
                    const vec2 u(fract(0.5f + float(k) * 0.7548777f), fract(0.5f + float(k) * 0.5698403f));
                    const vec3 i = mirrorDirection(o, sampleGgxVisible(o, alpha, u));
                    if (i.z > 0.0f) truth += wall(p, toWorld(frame, i)) * (ggxG2(o, i, alpha) / ggxG1(o, alpha) / float(samples));
                }
                const vec3 apart = at(picture, x, y) - truth;
                squares += double(dot(apart, apart)) / 3.0;
                sum += double(truth.x + truth.y + truth.z) / 3.0;
                got += double(at(picture, x, y).x + at(picture, x, y).y + at(picture, x, y).z) / 3.0;
                ++judged;
            }
        const double error = std::sqrt(squares / judged) / (sum / judged), bias = got / sum - 1.0;
        std::printf("roughness %.2f: relative RMSE %.3f, bias %+.3f over %d pixels\n", double(roughness), error, bias, judged);
        // One distance for the whole lobe, and its width in steps of two: a quarter. A mirror has no such excuse
        EXPECT_LT(error, roughness < 0.1f ? 0.1 : 0.3) << roughness;
        EXPECT_LT(std::abs(bias), 0.1) << roughness;
    }
}

// The wall goes on above the picture: from row to row its image gives way to what lighting had, here black, with no step.
TEST_F(ScreenReflection, FadesTowardTheBorderOfThePictureWithoutAStep)
{
    size = {96, 128};
    floorTo(-10, metal(0.0f));
    addQuad(scene, vec3(-60, -1, -10), vec3(120, 0, 0), vec3(0, 60, 0), lamp(vec3(1.0f)));
    const Image picture = mirrored(camera);
    const float lowest = at(picture, 48, 127).x;
    EXPECT_EQ(lowest, 0.0f) << "what the last row mirrors lies above the picture";
    float largest = 0.0f, brightest = 0.0f;
    for (int y = 66; y < 128; ++y) {
        if (!(onFloor(eyeRay(camera, 48, y - 1)).z > -9.9f)) continue;
        largest = std::max(largest, std::abs(at(picture, 48, y).x - at(picture, 48, y - 1).x));
        brightest = std::max(brightest, at(picture, 48, y).x);
    }
    EXPECT_GT(brightest, 0.99f);
    EXPECT_LT(largest, 0.2f) << "the fade takes 0.06 of 128 rows: 7.7";
}

// Everything has radiance 1, cubemaps too. What is taken from the probes is what the screen gives: neither lost nor doubled.
TEST_F(ScreenReflection, ReplacesExactlyWhatLightingTookFromTheProbes)
{
    for (const float roughness : {0.0f, 0.15f, 0.25f}) {
        scene = Scene{};
        Material floor = metal(roughness);
        floor.metallic = 0.5f;
        floor.baseColor = vec4(0.3f, 0.6f, 0.9f, 1.0f);
        floorTo(-10, floor);
        addQuad(scene, vec3(-60, -1, -10), vec3(120, 0, 0), vec3(0, 60, 0), lamp(vec3(1.0f)));
        baked = bakedEvenly(scene, vec3(1.0f));
        baked.reflections.push_back(evenReflection(vec3(-60, -2, -12), vec3(60, 60, 12), vec3(1.0f)));
        const Image plain = radiance(camera), picture = mirrored(camera);
        for (std::size_t i = 0; i < plain.pixels.size(); ++i)
            ASSERT_NEAR(picture.pixels[i], plain.pixels[i], 2e-3f) << roughness << ' ' << i;
    }
}

// A pane hangs before the mirror floor: what is mirrored is seen through it, and the pane is not mirrored twice.
TEST_F(ScreenReflection, ClearSurfacesAreDrawnOverIt)
{
    floorTo(-10, metal(0.0f));
    bands(4);
    const Image open = mirrored(camera);
    Material pane = matte(vec3(1, 0, 0));
    pane.flags |= kMaterialUnlit | kMaterialAlphaBlend;
    pane.baseColor.w = 0.25f;
    addQuad(scene, vec3(-9, -9, -0.5f), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, pane));
    const Image behind = mirrored(camera);
    for (const int y : {40, 46, 52}) expectNear(at(behind, 48, y), 0.75f * at(open, 48, y) + vec3(0.25f, 0, 0), 4e-3f);
}
}
