// Occlusion: each method against closed forms and rays, and above all where nothing may be hidden.
#include "tests/engine/effects/occluded.hpp"

namespace afterglow
{
// The arc is the integral of the cosine to the normal times the slices' sine, and all open slices together are the hemisphere.
TEST(HorizonArc, IsItsIntegral)
{
    for (const float n : {-1.4f, -0.5f, 0.0f, 0.3f, 1.2f})
        for (const float h : {0.05f, 0.6f, n + kHalfPi}) {
            if (h < 0.0f) continue;
            double sum = 0;
            for (int i = 0; i < 2000; ++i) {
                const double angle = double(h) * (i + 0.5) / 2000;
                sum += std::sin(angle) * std::cos(angle - double(n)) * double(h) / 2000;
            }
            EXPECT_NEAR(horizonArc(h, n), sum, 1e-5) << n << ' ' << h;
            EXPECT_NEAR(horizonArc(-h, -n), sum, 1e-5) << "the other side";
        }
    for (const float tilt : {0.0f, 0.7f, 1.5f}) { // of the normal from the line of sight
        double whole = 0;
        for (int i = 0; i < 512; ++i) {
            const float turn = (float(i) + 0.5f) * kPi / 512.0f, across = std::sin(tilt) * std::cos(turn), along = std::cos(tilt);
            const float n = std::atan2(across, along);
            whole += double(std::sqrt(across * across + along * along) * openArc(n)) / 512;
            EXPECT_NEAR(horizonArc(n + kHalfPi, n) + horizonArc(n - kHalfPi, n), openArc(n), 1e-5f);
        }
        EXPECT_NEAR(whole, 1.0, 1e-3) << tilt;
    }
}

// H73, H74: a floor hides nothing of itself, seen from above or along it, in a picture of any size, by an orthographic eye, too.
TEST_F(Occlusion, AFloorIsOpen)
{
    floor();
    for (const Method& m : methods())
        for (const uvec2 picture : {uvec2(61, 47), uvec2(64, 48), uvec2(1, 1), uvec2(7, 1)}) {
            size = picture;
            for (const float height : {0.05f, 1.7f, 20.0f})
                EXPECT_GE(least(visibility(lookAt(vec3(0, height, 4), vec3(0.3f, 0, 0)), m.method, within(1.0f))), 0.99f)
                    << m.name << " from " << height << " m, " << picture.x << " x " << picture.y;
            Camera flat = lookAt(vec3(0, 3, 4), vec3(0));
            flat.fovY = 0.0f;
            flat.orthoHeight = 5.0f;
            EXPECT_GE(least(visibility(flat, m.method, within(1.0f))), 0.99f) << m.name << ", orthographic";
        }
}

// A floor that lies across the voxels, in every direction.
TEST_F(Occlusion, ASlantedFloorIsOpenToVoxels)
{
    size = {48, 48};
    for (const vec3 normal : {vec3(1, 1, 0), vec3(1, 1, 1), vec3(0.2f, 1, 0.1f), vec3(1, 3, 2)}) {
        scene.objects.clear(), scene.meshes.clear(), scene.vertices.clear(), scene.indices.clear();
        const Frame f = makeFrame(normalize(normal));
        addQuad(scene, -4.0f * (f.tangent + f.bitangent), 8.0f * f.tangent, 8.0f * f.bitangent, grey());
        const Camera above = lookAt(3.0f * f.normal, vec3(0));
        EXPECT_GE(least(visibility(above, OcclusionMethod::voxel, within(1.0f))), 0.99f) << normal.x << ' ' << normal.y << ' ' << normal.z;
    }
}

// Closed forms (projected solid angle): the wedge's (1 - cos theta) / 2 at its edge, the wall's (1 + cos atan(h / d)) / 2, the wall within
// a range 1 - (acos t - t sqrt(1 - t^2)) / pi. They are what the rays of this test find.
TEST_F(Occlusion, TheRaysOfThisTestMeetTheClosedForms)
{
    for (const auto& [degrees, value] : {std::pair(60.0f, 0.25f), {90.0f, 0.5f}, {135.0f, 0.85355339f}}) {
        scene = Scene();
        slope(degrees);
        EXPECT_NEAR(open(vec3(-1e-3f, 0, 0), vec3(0, 1, 0), 9.0f), value, 5e-3f) << degrees;
    }
    scene = Scene();
    wall(0, 1);
    EXPECT_NEAR(open(vec3(-0.1f, 0, 0), vec3(0, 1, 0), 99.0f), 0.54975186f, 5e-3f);
    scene = Scene();
    wall(0, 9);
    for (const auto& [t, value] : {std::pair(0.5f, 0.80449889f), {0.3f, 0.68808117f}, {0.1f, 0.56355571f}})
        EXPECT_NEAR(open(vec3(-t, 0, 0), vec3(0, 1, 0), 1.0f), value, 5e-3f) << t;
    scene = Scene();
    pit(1);
    EXPECT_NEAR(open(vec3(0), vec3(0, 1, 0), 99.0f), 0.55412642f, 5e-3f);
    scene = Scene();
    pit(3);
    EXPECT_NEAR(open(vec3(0), vec3(0, 1, 0), 99.0f), 0.12331759f, 5e-3f);
}

// Two planes at 60, 90 and 135 degrees, both seen by the eye.
TEST_F(Occlusion, OfAWedgeIsNearTheTruth)
{
    size = {96, 96};
    for (const float degrees : {60.0f, 90.0f, 135.0f}) {
        scene = Scene();
        floor();
        slope(degrees);
        const float middle = (180.0f - 0.5f * degrees) * kPi / 180.0f; // half way between the planes
        const Camera camera = lookAt(5.0f * vec3(std::cos(middle), std::sin(middle), 0), vec3(-0.5f, 0, 0), 0.7f);
        for (const Method& m : methods()) {
            const float error = floorError(camera, m.method, within(1.0f));
            EXPECT_LE(error, m.bound) << m.name << ' ' << degrees;
            std::printf("wedge of %3.0f degrees, %s: mean absolute error %.4f\n", double(degrees), m.name, double(error));
        }
    }
}

TEST_F(Occlusion, OfAWallIsNearTheTruth)
{
    size = {96, 96};
    floor();
    wall(0, 1);
    const Camera camera = lookAt(vec3(-4, 3, 0), vec3(-0.5f, 0, 0), 0.7f);
    for (const float range : {0.5f, 1.0f, 2.0f})
        for (const Method& m : methods()) {
            const float error = floorError(camera, m.method, within(range));
            EXPECT_LE(error, m.bound) << m.name << ' ' << range;
            std::printf("wall of 1 m within %.1f m, %s: mean absolute error %.4f\n", double(range), m.name, double(error));
        }
}

// The middle of a pit 2 m wide, looked into from above; the rim hides the sky from 1.4 m of it on.
TEST_F(Occlusion, OfAPitIsNearTheTruth)
{
    size = {97, 97};
    for (const float depth : {1.0f, 3.0f}) {
        scene = Scene();
        pit(depth);
        const Camera camera = lookAt(vec3(0, depth + 3.0f, 0), vec3(0), 0.8f);
        const float truth = open(vec3(0, 1e-4f, 0), vec3(0, 1, 0), 1.5f);
        OcclusionParameters p = within(1.5f);
        p.steps = 32; // the walls are nine pixels wide in the picture, and the range 45
        const auto found = [&](OcclusionMethod method) { return at(visibility(camera, method, p), 48, 48); };
        EXPECT_NEAR(found(OcclusionMethod::hbao), truth, 0.05f) << depth;
        p.steps = defaultOcclusionParameters().steps;
        const float coarse = found(OcclusionMethod::hbao);
        EXPECT_NEAR(coarse, truth, 0.1f) << depth << ", by few steps";
        std::printf("pit of %.0f m, hbao by %u steps: %+.3f\n", double(depth), p.steps, double(coarse - truth));
        EXPECT_NEAR(found(OcclusionMethod::voxel), truth, 0.08f) << depth;
        EXPECT_GT(found(OcclusionMethod::ssao), truth - 0.02f) << "few points lie in the walls: too bright, says the study";
    }
}

// What lies farther than the range hides nothing.
TEST_F(Occlusion, EndsWithTheRange)
{
    floor();
    wall(0, 3);
    size = {64, 64};
    const Camera camera = lookAt(vec3(-1.5f, 2, 0), vec3(-1.5f, 0, 0), 0.4f); // the floor from 1 m before the wall on
    for (const Method& m : methods()) EXPECT_GE(least(visibility(camera, m.method, within(0.9f))), 0.99f) << m.name;
}

// H65: the sky is no wall, neither for the sky itself nor for what stands before it.
TEST_F(Occlusion, TheSkyHidesNothing)
{
    addQuad(scene, vec3(-0.5f, -0.5f, -3), vec3(1, 0, 0), vec3(0, 1, 0), grey());
    size = {33, 33};
    for (const Method& m : methods())
        EXPECT_GE(least(visibility(lookAt(vec3(0), vec3(0, 0, -1)), m.method, within(1.0f))), 0.99f) << m.name;
    scene = Scene();
    for (const Method& m : methods()) EXPECT_EQ(least(visibility(lookAt(vec3(0), vec3(0, 0, -1)), m.method, within(1.0f))), 1.0f) << m.name;
}

// H73: at the border of the picture the samples that it has say what is hidden: no bright frame, no dark one.
TEST_F(Occlusion, AtTheBorderOfThePictureTheSamplesThereAreCount)
{
    floor();
    wall(0, 1);
    // Along a row of the picture the wall is everywhere as near
    size = {64, 64};
    const Camera camera = lookAt(vec3(-2, 2, 0), vec3(-0.2f, 0, 0), 0.8f);
    for (const Method& m : methods()) {
        const Image image = visibility(camera, m.method, within(1.0f));
        for (int y = 0; y < 64; ++y)
            for (const int x : {0, 1, 2, 61, 62, 63})
                EXPECT_NEAR(at(image, x, y), at(image, 32, y), 0.2f) << m.name << ' ' << x << ' ' << y;
        EXPECT_LT(at(image, 0, 31), 0.8f) << m.name << " at the foot of the wall";
    }
}

// H73: an object of one pixel leaves no dark fringe on what lies far behind it.
TEST_F(Occlusion, AnObjectOfOnePixelLeavesNoFringe)
{
    floor();
    addQuad(scene, vec3(-0.015f, 2.0f, -0.015f), vec3(0, 0, 0.03f), vec3(0.03f, 0, 0), grey());
    for (const uvec2 picture : {uvec2(64, 64), uvec2(65, 63)}) {
        size = picture;
        for (const Method& m : methods())
            EXPECT_GE(least(visibility(lookAt(vec3(0, 4, 0), vec3(0), 0.9f), m.method, within(1.0f))), 0.98f) << m.name;
    }
}

// A roof half a metre above the floor, out of sight: voxels know of it.
TEST_F(Occlusion, ByVoxelsKnowsWhatTheScreenDoesNotSee)
{
    floor();
    addQuad(scene, vec3(-5, 0.5f, -5), vec3(10, 0, 0), vec3(0, 0, 10), grey());
    size = {48, 48};
    const Camera under = lookAt(vec3(0, 0.25f, 0), vec3(1, 0, 0), 0.3f);
    const float truth = open(vec3(0, 1e-4f, 0), vec3(0, 1, 0), 1.0f); // 1 - cos^2 60 = 0.25 of an endless one
    EXPECT_NEAR(truth, 0.25f, 5e-3f);
    EXPECT_NEAR(middle(visibility(under, OcclusionMethod::voxel, within(1.0f))).x, truth, 0.08f);
    for (const OcclusionMethod screen : {OcclusionMethod::ssao, OcclusionMethod::hbao})
        EXPECT_GT(middle(visibility(under, screen, within(1.0f))).x, 0.9f) << "the study says that the screen does not know";
}

// H74: a room smaller than a voxel, and one of nothing but a surface that is flat.
TEST_F(Occlusion, OfARoomSmallerThanAVoxelIsFinite)
{
    addRoom(scene, vec3(-0.01f), vec3(0.01f), grey());
    addQuad(scene, vec3(-500, -1, -500), vec3(0, 0, 1000), vec3(1000, 0, 0), grey());
    size = {16, 16};
    const Image image = visibility(lookAt(vec3(0), vec3(0, 0, -1)), OcclusionMethod::voxel, within(1.0f));
    for (int i = 0; i < 16 * 16; ++i) {
        EXPECT_GE(image.pixels[std::size_t(i) * image.channels], 0.0f);
        EXPECT_LE(image.pixels[std::size_t(i) * image.channels], 1.0f);
    }
}
}
