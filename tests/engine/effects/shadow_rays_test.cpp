// Shadows by ray query: exact edges, penumbras of the light's size, what lets light through, and no surface that shadows itself.
#include "engine/effects/view_ray.h"
#include "shaders/penumbra.h"
#include "shaders/ray.h"
#include "tests/engine/effects/lit_share.hpp"
#include <cstdio>

namespace afterglow
{
class ShadowRays : public LitShare
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }

    Image litShare(const Camera& camera, uint rays = 16)
    {
        ShadowParameters parameters = defaultShadowParameters();
        parameters.rays = rays;
        return litShareOf(camera, {.shadow = true, .shadowMethod = ShadowMethod::ray, .shadowParameters = parameters});
    }
};

// A plate of 2 m hangs 1 m above the floor under a sun at 45 degrees from -x: its shadow covers x 0..2, z -1..1, to the millimetre.
TEST_F(ShadowRays, EndWhereTheSunsRaysPassThePlatesEdge)
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
TEST_F(ShadowRays, TouchWhatCastsThem)
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
TEST_F(ShadowRays, APlaneNeverShadowsItself)
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
TEST_F(ShadowRays, ALargePlaneTurnedAtWillNeverShadowsItself)
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
TEST_F(ShadowRays, TouchByTheReachOfTheReceiver)
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
TEST_F(ShadowRays, AShadedRimBeforeTheSkyIsDark)
{
    int asked = 0;
    EXPECT_EQ(litUnderRoof({.shadow = true, .shadowMethod = ShadowMethod::ray}, asked), 0);
    EXPECT_GT(asked, 1000);
}

// An orthographic eye that looks along the sun sees no shadow at all: each ray goes back the way the eye looks.
TEST_F(ShadowRays, AnOrthographicEyeInTheSunSeesNone)
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
TEST_F(ShadowRays, ARoomFarOutIsLitIntoItsCorners)
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
TEST_F(ShadowRays, WallsWithSnappedCornersNeverShadowThemselves)
{
    for (const vec2 off : furthestOff())
        EXPECT_GT(least(litInSnappedRoom({.shadow = true, .shadowMethod = ShadowMethod::ray}, off)), 0.999f) << off.x << ' ' << off.y;
}

// The penumbra of a disc behind a straight edge (shaders/penumbra.h, shadow.penumbra_profile): a sun of 4 degrees square above the floor, an edge
// 1 m above it. Rays of a pixel are stratified, so 64 pixels of 64 rays each are worth at least 4096 independent ones.
TEST_F(ShadowRays, ThePenumbraOfASunIsThatOfADiscBehindAnEdge)
{
    floor();
    addQuad(scene, vec3(-5, 1, -5), vec3(0, 0, 10), vec3(5, 0, 0), grey()); // its edge is x = 0
    Light sun = sunLight(vec3(0, -1, 0), vec3(3.0f));
    sun.sinAngle = std::sin(2.0f * kPi / 180.0f);
    addLight(scene, sun);
    size = {64, 64};
    const Camera camera = lookAt(vec3(0, 0.5f, 0), vec3(0), 0.2f); // 10 cm of floor; the penumbra is 7 cm wide
    const Image lit = litShare(camera, 64);
    const float radius = std::tan(2.0f * kPi / 180.0f), half = 0.5f * std::tan(0.1f);
    for (int x = 0; x < 64; ++x) {
        const float t = ((float(x) + 0.5f) / 32.0f - 1.0f) * half / radius, wanted = penumbra(t);
        double sum = 0;
        for (int y = 0; y < 64; ++y) sum += double(lit.at(x, y)[0]);
        const float got = float(sum / 64), error = 4.0f * std::sqrt(wanted * (1.0f - wanted) / 4096.0f) + 0.5f / 255.0f + 1e-3f;
        // What twelve rays miss is spared: so much of the rarer of light and shadow may be lost, and never more is found
        const float lost = std::min(wanted, 1.0f - wanted) * std::pow(std::max(wanted, 1.0f - wanted), 12.0f);
        EXPECT_GE(got, wanted - error - (wanted < 0.5f ? lost : 0.0f)) << t;
        EXPECT_LE(got, wanted + error + (wanted < 0.5f ? 0.0f : lost)) << t;
    }
}

// The same behind a lamp's ball: w (zr - zb) / zb wide (shadow.penumbra_width).
TEST_F(ShadowRays, ThePenumbraOfALampIsAsWideAsSimilarTrianglesSay)
{
    floor();
    addQuad(scene, vec3(-5, 3, -5), vec3(0, 0, 10), vec3(5, 0, 0), grey());
    Light lamp = pointLight(vec3(0, 5, 0), vec3(50.0f)); // zb = 2, zr = 5
    lamp.radius = 0.25f;
    addLight(scene, lamp);
    size = {128, 16};
    const Camera camera = lookAt(vec3(0, 2.5f, 0), vec3(0), 0.06f);
    const Image lit = litShare(camera, 64);
    const float half = 0.5f * penumbraWidth(0.5f, 2, 5);
    EXPECT_NEAR(half, 0.375f, 1e-6f);
    const auto mean = [&](float x) {
        double sum = 0;
        for (int z = 0; z < 10; ++z) sum += double(litAt(lit, camera, vec3(x, 0, 0.01f * float(z) - 0.05f)));
        return float(sum / 10);
    };
    EXPECT_NEAR(mean(-half - 0.02f), 0.0f, 1e-3f);
    EXPECT_NEAR(mean(half + 0.02f), 1.0f, 1e-3f);
    for (const float t : {-0.5f, 0.0f, 0.5f}) EXPECT_NEAR(mean(t * half), penumbra(t), 0.04f) << t;
}

// A light that a level gives no size takes one ray and has hard edges: no pixel is in between.
TEST_F(ShadowRays, OfALightWithoutASizeAreHard)
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

// A blended sheet lets 1 - alpha by; a mask all or nothing, by its texel, its alpha equal to the cutoff keeping (H51).
TEST_F(ShadowRays, PassWhatIsCutOutAndShareWhatIsBlended)
{
    floor();
    SceneTexture texture;
    texture.image.width = 4, texture.image.height = 1;
    texture.nearest = true;
    texture.image.pixels = {255, 255, 255, 0, 255, 255, 255, 127, 255, 255, 255, 128, 255, 255, 255, 255};
    scene.textures.push_back(texture);
    Material leaf = matte(vec3(0.5f)), sheet = matte(vec3(0.5f));
    leaf.flags |= kMaterialAlphaMask;
    leaf.alphaCutoff = 128.0f / 255.0f;
    leaf.baseColorTexture.texture = 0;
    sheet.flags |= kMaterialAlphaBlend;
    sheet.baseColor.a = 0.25f;
    addQuad(scene, vec3(-2, 1, 0), vec3(4, 0, 0), vec3(0, 0, -1), addMaterial(scene, leaf)); // a texel for each metre of x
    addQuad(scene, vec3(-2, 1, 2), vec3(4, 0, 0), vec3(0, 0, -1), addMaterial(scene, sheet));
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    size = {128, 128};
    const Camera camera = lookAt(vec3(0, 0.5f, 0.5f), vec3(0, 0, 0.5f), 2.8f); // from below both
    const Image lit = litShare(camera);
    EXPECT_NEAR(litAt(lit, camera, vec3(-1.5f, 0, -0.5f)), 1.0f, 1e-3f);
    EXPECT_NEAR(litAt(lit, camera, vec3(-0.5f, 0, -0.5f)), 1.0f, 1e-3f);
    EXPECT_EQ(litAt(lit, camera, vec3(0.5f, 0, -0.5f)), 0.0f) << "alpha = cutoff keeps";
    EXPECT_EQ(litAt(lit, camera, vec3(1.5f, 0, -0.5f)), 0.0f);
    EXPECT_NEAR(litAt(lit, camera, vec3(0.5f, 0, 1.5f)), 0.75f, 0.5f / 255.0f + 1e-3f);
}

// H05: a face and its double, front to front or front to back, cast one shadow and take none from each other.
TEST_F(ShadowRays, OfTwoCoincidentFacesAreThoseOfOne)
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
TEST_F(ShadowRays, OfSixLightsAddUp)
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

TEST_F(ShadowRays, NeedNothingToMeetAndNoLight)
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
