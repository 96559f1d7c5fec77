// Shadows by ray query, to their edges: none is missing, none is there that nothing casts, and no surface shadows itself.
#include "engine/effects/view_ray.h"
#include "shaders/ray.h"
#include "tests/engine/effects/shadow_rays.hpp"
#include <cstdio>

namespace afterglow
{
// A plate of 2 m hangs 1 m above the floor under a sun at 45 degrees from -x: its shadow covers x 0..2, z -1..1, to the millimetre.
TEST_F(ShadowsByRay, EndWhereTheSunsRaysPassThePlatesEdge)
{
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {512, 16};
    for (const float edge : {0.0f, 2.0f}) {
        const Camera camera = lookAt(vec3(edge, 0.5f, 1.2f), vec3(edge, 0, 0), 0.01f); // a pixel is 0.8 mm wide
        const Image lit = litShare(camera);
        const float inside = edge == 0.0f ? 1.0f : -1.0f;
        for (const float away : {0.0015f, 0.01f, 0.1f}) {
            EXPECT_NEAR(litAt(lit, camera, vec3(edge + inside * away, 0, 0)), 0.0f, 1e-3f) << away << " m inside of " << edge;
            EXPECT_NEAR(litAt(lit, camera, vec3(edge - inside * away, 0, 0)), 1.0f, 1e-3f) << away << " m outside of " << edge;
        }
    }
}

// A wall on the floor: the shadow begins at its foot.
TEST_F(ShadowsByRay, TouchWhatCastsThem)
{
    floor();
    addQuad(scene, vec3(0, 0, -1), vec3(0, 0, 2), vec3(0, 0.5f, 0), grey());
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {512, 16};
    const Camera camera = lookAt(vec3(0.2f, 0.5f, 1.2f), vec3(0.02f, 0, 0), 0.003f);
    const Image lit = litShare(camera);
    for (const float x : {0.001f, 0.01f, 0.03f}) EXPECT_NEAR(litAt(lit, camera, vec3(x, 0, 0)), 0.0f, 1e-3f) << x;
}

// H67: from the zenith to a hundredth of a degree above the horizon, before the eye and a thousand metres away.
TEST_F(ShadowsByRay, APlaneNeverShadowsItself)
{
    size = {64, 64};
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    for (const float half : {0.01f, 5.0f, 2000.0f}) {
        scene.vertices.clear(), scene.indices.clear(), scene.meshes.clear(), scene.objects.clear();
        floor(half);
        for (const float degrees : {0.0f, 45.0f, 89.0f, 89.99f}) {
            const float slope = std::tan(degrees * kPi / 180.0f);
            scene.lights[0].direction = normalize(vec3(0.8f * slope, -1, 0.6f * slope));
            Camera low = lookAt(vec3(-0.4f * half, 0.01f * half, 0.3f * half), vec3(half, 0, 0), 1.0f);
            low.nearPlane = 0.001f * half;
            EXPECT_GT(least(litShare(low)), 0.999f) << degrees << " degrees, " << half << " m";
            Camera above = lookAt(vec3(0, 2 * half, 0), vec3(0), 0.8f);
            EXPECT_GT(least(litShare(above)), 0.999f) << degrees << " degrees, above " << half << " m";
        }
    }
}

// What meets a triangle rounds by its size, not by where on it: turned to no axis, and seen from near.
TEST_F(ShadowsByRay, ALargePlaneTurnedAtWillNeverShadowsItself)
{
    size = {64, 64};
    floor(2000.0f);
    const mat4 turn(mat3_cast(angleAxis(0.7f, vec3(0.36f, 0.48f, 0.8f))));
    scene.objects[0].toWorld = dmat4(turn);
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    for (const float degrees : {0.0f, 45.0f, 80.0f, 89.0f}) {
        const float slope = std::tan(degrees * kPi / 180.0f);
        scene.lights[0].direction = mat3(turn) * normalize(vec3(0.8f * slope, -1, 0.6f * slope));
        const Camera near = lookAt(vec3(turn * vec4(-0.4f, 0.3f, 0.3f, 1)), vec3(turn * vec4(1, 0, 0, 1)), 1.0f);
        EXPECT_GT(least(litShare(near)), 0.999f) << degrees << " degrees";
    }
}

// How low a sheet may hang and still cast a shadow: it rests on how large the triangles of the receiver's material are, and on no other's.
TEST_F(ShadowsByRay, TouchByTheReachOfTheReceiver)
{
    constexpr float kSlope = 50.0f, kAway = 0.5f; // of the sun; of the eye, m
    size = {8, 8};
    addLight(scene, sunLight(vec3(kSlope, -1, 0), vec3(3.0f)));
    const auto casts = [&](float height, float width, float ground) {
        scene.vertices.clear(), scene.indices.clear(), scene.meshes.clear(), scene.objects.clear(), scene.materials.clear();
        floor(0.5f * width);
        const uint other = addMaterial(scene, matte(vec3(0.64f)));
        addQuad(scene, vec3(-0.1f, height, -0.1f), vec3(0, 0, 0.2f), vec3(0.1f, 0, 0), other); // its shadow: kSlope heights of x > 0
        if (ground > 0.0f) addQuad(scene, vec3(-0.5f * ground, -1, -0.5f * ground), vec3(0, 0, ground), vec3(ground, 0, 0), other);
        const vec3 shaded(0.1f * kSlope * height, 0, 0); // near the foot: a ray that begins higher than 0.9 heights passes the sheet
        const Camera camera = lookAt(shaded + vec3(0, kAway, 0), shaded, 0.2f * kSlope * height / kAway);
        return litAt(litShare(camera), camera, shaded) < 0.5f;
    };
    struct Row {
        float width, ground; // m; 0: none
    };
    std::printf("| receiver | sheets cast shadows on it from |\n| --- | --- |\n");
    for (const Row& row : {Row{1, 0}, Row{1, 4000}, Row{40, 0}, Row{400, 0}, Row{4000, 0}}) {
        float low = 1e-6f, high = 1e-2f; // m
        while (high > 1.02f * low) {
            const float height = std::sqrt(low * high);
            (casts(height, row.width, row.ground) ? high : low) = height;
        }
        std::printf("| %g m%s | %.3f mm |\n", double(row.width), row.ground > 0.0f ? ", above a ground of 4 km" : "", 1e3 * double(high));
        // What a ray leaves out by the origin, what depth may be off by before this eye, and what meets triangles of that size; a quarter
        // more for the foot, the search's steps and what a point is really off by
        const float wanted =
            offsetComponent(0.0f, 1.0f) + depthRounding(kAway, mat4(1), vec4(0, 0, 0, 1)) + meetingError(vec3(row.width), vec3(0), vec3(0));
        EXPECT_LT(low, 1.25f * wanted) << row.width << " m";
    }
}

// What a pixel takes from the ones beside it must not be the sky's: it lies nowhere.
TEST_F(ShadowsByRay, AShadedRimBeforeTheSkyIsDark)
{
    int asked = 0;
    EXPECT_EQ(litUnderRoof({.shadow = true, .shadowMethod = ShadowMethod::ray}, asked), 0);
    EXPECT_GT(asked, 1000);
}

// An orthographic eye that looks along the sun sees no shadow at all: each ray goes back the way the eye looks.
TEST_F(ShadowsByRay, AnOrthographicEyeInTheSunSeesNone)
{
    floor();
    addRoom(scene, vec3(-1, -1, -1), vec3(1, 1, 1), grey());
    addLight(scene, sunLight(vec3(-0.5f, -0.7f, 0.5f), vec3(3.0f)));
    Camera camera = lookAt(vec3(5, 7, -5), vec3(0));
    camera.fovY = 0.0f;
    camera.orthoHeight = 4.0f;
    size = {64, 64};
    const Image lit = litShare(camera);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) EXPECT_GT(lit.at(x, y)[0], 0.999f) << x << ' ' << y;
}

// The same on walls that meet, a kilometre from the origin, under a lamp with a size.
TEST_F(ShadowsByRay, ARoomFarOutIsLitIntoItsCorners)
{
    const vec3 far(1000, -700, 400);
    addRoom(scene, far - vec3(2), far + vec3(2), grey());
    Light lamp = pointLight(far + vec3(0.1f, 0.2f, 0.3f), vec3(5.0f));
    lamp.radius = 0.1f;
    addLight(scene, lamp);
    size = {64, 64};
    EXPECT_GT(least(litShare(lookAt(far + vec3(-1.5f, -1.2f, 1.5f), far + vec3(2, 1, -2), 1.8f))), 0.999f);
}

// In a picture of few pixels a triangle that is drawn a little beside its place lies far off it.
TEST_F(ShadowsByRay, WallsWithSnappedCornersNeverShadowThemselves)
{
    for (const vec2 off : furthestOff())
        EXPECT_GT(least(litInSnappedRoom({.shadow = true, .shadowMethod = ShadowMethod::ray}, off)), 0.999f) << off.x << ' ' << off.y;
}

// A light that a level gives no size takes one ray and has hard edges: no pixel is in between.
TEST_F(ShadowsByRay, OfALightWithoutASizeAreHard)
{
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, pointLight(vec3(0.3f, 4, 0.2f), vec3(30.0f)));
    size = {64, 64};
    const Image lit = litShare(lookAt(vec3(0, 0.8f, 6), vec3(0), 0.9f));
    for (int i = 0; i < 64 * 64; ++i) {
        const float share = lit.pixels[std::size_t(i) * lit.channels];
        EXPECT_TRUE(share < 1e-3f || share > 0.999f) << share;
    }
}

// H05: a face and its double, front to front or front to back, cast one shadow and take none from each other.
TEST_F(ShadowsByRay, OfTwoCoincidentFacesAreThoseOfOne)
{
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {64, 64};
    const Camera camera = lookAt(vec3(0, 0.9f, 6), vec3(0.5f, 0, 0), 0.9f);
    const Image once = litShare(camera);
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addQuad(scene, vec3(-1, 1, -1), vec3(2, 0, 0), vec3(0, 0, 2), grey());
    floor();
    const Image both = litShare(camera);
    for (std::size_t i = 0; i < both.pixels.size(); ++i) EXPECT_NEAR(both.pixels[i], once.pixels[i], 1e-3f);
}

// Four lights fill a layer of the texture: the fifth and the sixth find theirs.
TEST_F(ShadowsByRay, OfSixLightsAddUp)
{
    floor();
    addQuad(scene, vec3(-0.5f, 1, -0.5f), vec3(0, 0, 1), vec3(1, 0, 0), grey());
    size = {32, 32};
    const Camera camera = lookAt(vec3(0, 0.8f, 6), vec3(0), 0.9f);
    std::vector<double> sum;
    std::vector<Light> lights;
    for (int i = 0; i < 6; ++i) lights.push_back(sunLight(vec3(std::cos(float(i)), -1, std::sin(float(i))), vec3(0.1f * float(i + 1))));
    const DrawnParts traced{.shadow = true, .shadowMethod = ShadowMethod::ray};
    for (const Light& light : lights) {
        scene.lights = {light};
        const Image image = radiance(camera, traced);
        sum.resize(image.pixels.size());
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += double(image.pixels[i]);
    }
    scene.lights = lights;
    const Image all = radiance(camera, traced);
    for (std::size_t i = 0; i < sum.size(); ++i)
        if (i % 4 != 3) {
            EXPECT_NEAR(double(all.pixels[i]), sum[i], 2e-3 * sum[i] + 1e-4);
        } // half floats
}

TEST_F(ShadowsByRay, NeedNothingToMeetAndNoLight)
{
    const Camera camera = lookAt(vec3(0, 1, 5), vec3(0));
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(1)));
    scene.sky.radiance = vec3(0.5f);
    EXPECT_NEAR(radiance(camera, {.shadow = true, .shadowMethod = ShadowMethod::ray}).pixels[0], 0.5f, 1e-3f);
    floor();
    scene.lights.clear();
    radiance(camera, {.shadow = true, .shadowMethod = ShadowMethod::ray});
    for (const PassStats& pass : stats.passes) EXPECT_NE(pass.name, "shadow.rays");
}
}
