// Which light occlusion dims, and of which surfaces.
#include "tests/engine/effects/occluded.hpp"

namespace afterglow
{
// A lightmap holds the contact of its front alone, and only while it is drawn: backs are dimmed, and fronts when no page is there to read.
TEST_F(Occlusion, DimsWhatNoLightmapLights)
{
    floor();
    addQuad(scene, vec3(0, -1, 5), vec3(0, 0, -10), vec3(0, 2, 0), grey()); // a wall through the floor
    scene.sky.radiance = vec3(1);
    size = {33, 33};
    const auto kept = [&](const Camera& camera) {
        DrawnParts parts;
        const float without = middle(radiance(camera, parts)).x;
        parts.occlusion = true;
        return middle(radiance(camera, parts)).x / without;
    };
    const Camera above = lookAt(vec3(-3, 2, 0), vec3(-0.2f, 0, 0)), below = lookAt(vec3(-3, -2, 0), vec3(-0.2f, 0, 0));
    const Baked even = bakedEvenly(scene, vec3(1));
    baked = even;
    EXPECT_EQ(kept(above), 1.0f);
    EXPECT_LT(kept(below), 0.95f);
    baked.lightmaps.clear();
    EXPECT_LT(kept(above), 0.95f);
}

// It dims the light from everywhere, with the tint of several bounces, and neither direct light nor emission.
TEST_F(Occlusion, DimsTheLightFromEverywhereAlone)
{
    floor();
    wall(0, 1);
    size = {32, 32};
    const Camera camera = lookAt(vec3(-3, 2, 0), vec3(-0.4f, 0, 0), 0.4f);
    const DrawnParts hidden{.occlusion = true, .occlusionMethod = OcclusionMethod::hbao};
    addLight(scene, sunLight(vec3(0.3f, -1, 0), vec3(2.0f)));
    scene.materials[0].emission = vec3(0.25f);
    EXPECT_EQ(radiance(camera).pixels, radiance(camera, hidden).pixels);

    scene.lights.clear();
    scene.materials[0].emission = vec3(0.0f);
    scene.sky.radiance = vec3(1.0f);
    const Image open = visibility(camera, OcclusionMethod::hbao, within(1.0f)), lit = radiance(camera, hidden);
    EXPECT_LT(least(open), 0.7f);
    for (int i = 0; i < 32 * 32; ++i)
        EXPECT_NEAR(lit.pixels[std::size_t(i) * lit.channels],
                    0.64f * bouncedVisibility(open.pixels[std::size_t(i) * open.channels], vec3(0.64f)).x, 4e-3f);
}

// Nobody asks for it where a lightmap holds it: such pixels say 1, and the others what they would beside them.
TEST_F(Occlusion, CanBeHadOfSurfacesWithoutLightmapsAlone)
{
    floor();
    wall(0, 1);
    scene.objects.back().isStatic = false;
    baked = bakedEvenly(scene, vec3(1.0f));
    size = {32, 32};
    const Camera camera = lookAt(vec3(-3, 2, 0), vec3(-0.4f, 0, 0), 0.4f);
    OcclusionParameters p = within(1.0f);
    p.divisor = 1, p.smooth_ = 0;
    for (const OcclusionMethod method : {OcclusionMethod::ssao, OcclusionMethod::hbao, OcclusionMethod::voxel}) {
        const Image all = visibility(camera, method, p), some = visibility(camera, method, p, kMostVoxels, /* mapped= */ false);
        int open = 0, same = 0;
        for (std::size_t i = 0; i < all.pixels.size(); ++i) {
            open += some.pixels[i] == 1.0f;
            same += some.pixels[i] == all.pixels[i];
            EXPECT_TRUE(some.pixels[i] == 1.0f || some.pixels[i] == all.pixels[i]);
        }
        EXPECT_GT(open, 200) << "the floor";
        EXPECT_GT(int(all.pixels.size()) - open, 100) << "the wall";
        EXPECT_LT(same, int(all.pixels.size())) << "the floor beside the wall";
    }
}

// Half the resolution looks at every second pixel, and leaves are thinner than two: each is looked at all the same.
TEST_F(Occlusion, LeavesOfAPixelAreLookedAtAmongLightmaps)
{
    floor();
    for (int k = -3; k <= 3; ++k) {
        addQuad(scene, vec3(0, 0, 0.19f * float(k)), vec3(0, 0, -0.05f), vec3(0, 0.5f, 0), grey());
        scene.objects.back().isStatic = false;
    }
    baked = bakedEvenly(scene, vec3(1.0f));
    size = {32, 32};
    const Camera camera = lookAt(vec3(-3, 2, 0), vec3(-0.2f, 0.2f, 0), 0.4f); // a pixel is 45 mm there
    OcclusionParameters whole = within(1.0f);
    whole.divisor = 1, whole.smooth_ = 0;
    const Image floorHides = visibility(camera, OcclusionMethod::voxel, whole, kMostVoxels, /* mapped= */ false);
    for (const OcclusionMethod method : {OcclusionMethod::hbao, OcclusionMethod::voxel}) {
        const Image each = visibility(camera, method, whole, kMostVoxels, /* mapped= */ false);
        const Image half = visibility(camera, method, within(1.0f), kMostVoxels, /* mapped= */ false);
        int leaves = 0, open = 0;
        double own = 0.0, found = 0.0;
        for (std::size_t i = 0; i < each.pixels.size(); ++i) {
            if (floorHides.pixels[i] == 1.0f) {
                EXPECT_EQ(half.pixels[i], 1.0f) << "the floor's lightmap knows";
                continue;
            }
            ++leaves, open += half.pixels[i] == 1.0f;
            own += double(each.pixels[i]), found += double(half.pixels[i]);
        }
        EXPECT_GT(leaves, 60);
        EXPECT_EQ(open, 0) << "of " << leaves;
        EXPECT_NEAR(found / leaves, own / leaves, 0.1);
    }
}

// A lightmap holds what hides the light: it is not taken twice.
TEST_F(Occlusion, LeavesWhatHasALightmapAsItIs)
{
    floor();
    wall(0, 1);
    baked = bakedEvenly(scene, vec3(0.7f));
    size = {32, 32};
    const Camera camera = lookAt(vec3(-3, 2, 0), vec3(-0.4f, 0, 0), 0.4f);
    EXPECT_EQ(radiance(camera).pixels, radiance(camera, {.occlusion = true}).pixels);
    baked.places[0].page = -1; // the floor moves, say
    baked.probes = evenProbes(vec3(-5), vec3(5), vec3(0.7f));
    const Image without = radiance(camera), with = radiance(camera, {.occlusion = true});
    EXPECT_NE(without.pixels, with.pixels);
}
}
