// Shadows: where they must fall, and above all where they must not.
#include "tests/engine/effects/lit_share.hpp"

namespace afterglow
{
class Shadow : public LitShare
{
protected:
    const Camera above = lookAt(vec3(0, 10, 0), vec3(0), 0.8f);

    Image litShare(const Camera& camera, SunMaps sun = SunMaps::level) { return litShareOf(camera, {.shadow = true, .sun = sun}); }
};

TEST_F(Shadow, FallsWhereTheSunIsHiddenAndNowhereElse)
{
    // A plate of 2 m hangs 1 m above the floor under a sun at 45 degrees from -x: its shadow covers x 0..2, z -1..1.
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {64, 64};
    const Camera side = lookAt(vec3(0, 0.9f, 6), vec3(0.5f, 0, 0), 0.9f); // under the plate
    const Image lit = litShare(side);
    for (const vec3 dark : {vec3(1, 0, 0), vec3(1.7f, 0, 0.7f)}) EXPECT_NEAR(litAt(lit, side, dark), 0.0f, 1e-3f) << dark.x;
    for (const vec3 bright : {vec3(-0.5f, 0, 0), vec3(2.5f, 0, 0), vec3(1, 0, 1.6f)})
        EXPECT_NEAR(litAt(lit, side, bright), 1.0f, 1e-3f) << bright.x;
}

// H31, H67: no plane shadows itself, from the zenith to 89 degrees from it, along an axis or a diagonal.
TEST_F(Shadow, APlaneNeverShadowsItself)
{
    floor();
    size = {48, 48};
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    for (const float degrees : {0.0f, 45.0f, 80.0f, 89.0f})
        for (const float turn : {0.0f, 0.25f * kPi}) {
            const float slope = std::tan(degrees * kPi / 180.0f);
            scene.lights[0].direction = normalize(vec3(slope * std::cos(turn), -1, slope * std::sin(turn)));
            EXPECT_GT(least(litShare(above)), 0.999f) << degrees << " degrees, turned by " << turn;
        }
}

// The same under a spot light, whose depth is no measure of distance and whose texels widen with it.
TEST_F(Shadow, APlaneUnderAGrazingSpotLightNeverShadowsItself)
{
    floor();
    size = {48, 48};
    Light spot = pointLight(vec3(-4.9f, 0.5f, 1), vec3(90.0f));
    spot.type = kLightSpot;
    spot.direction = normalize(vec3(1, -0.03f, -0.2f)); // the floor's far end is seen at 87 degrees
    spot.cosInner = 0.8f;
    spot.cosOuter = 0.7f;
    addLight(scene, spot);
    EXPECT_GT(least(litShare(above)), 0.999f);
}

// H67: the sun 1 degree above the floor. A plate that stands across it shadows the floor behind it from its foot on, and only that.
TEST_F(Shadow, AReceiverAt89DegreesIsInShadowWhereGeometrySays)
{
    floor();
    addQuad(scene, vec3(0, 0, -1), vec3(0, 0, 2), vec3(0, 0.5f, 0), grey());
    addLight(scene, sunLight(vec3(std::cos(kPi / 180.0f), -std::sin(kPi / 180.0f), 0), vec3(30.0f)));
    size = {256, 256};
    const Image lit = litShare(above);
    // The filter is 1.5 texels of (10 + 2 0.5 cos 1) 1.01 / 2048 = 5 mm across the sun; the floor's lift shifts it by as much again. Along
    // the sun a texel of (0.5 + 10 sin 1) 1.01 / 2048 = 0.34 mm covers 19 mm of the floor, filter and lift 6 cm
    for (const float x : {0.1f, 1.0f, 3.0f})
        for (const float z : {-0.95f, 0.0f, 0.95f}) EXPECT_NEAR(litAt(lit, above, vec3(x, 0, z)), 0.0f, 1e-3f) << x << ' ' << z;
    for (const float x : {-1.0f, -0.1f})
        for (const float z : {-0.95f, 0.0f, 0.95f}) EXPECT_NEAR(litAt(lit, above, vec3(x, 0, z)), 1.0f, 1e-3f) << x << ' ' << z;
    for (const float x : {0.1f, 3.0f})
        for (const float z : {-1.06f, 1.06f}) EXPECT_NEAR(litAt(lit, above, vec3(x, 0, z)), 1.0f, 1e-3f) << x << ' ' << z;
}

// H67: a wall 20 m high, 1 degree from the sun's rays. Its shadow is 20 m tan 1 = 35 cm deep, seven texels, and begins at its foot: the
// filter takes 1.5 texels of that, the bounded push 8.5 texels sin 1 = 0.15 more. Pushed by 1.5 tan 89 = 86 texels it would begin 3 away.
TEST_F(Shadow, ACasterAt89DegreesShadowsFromItsFootOn)
{
    const float texel = 1.01f * 100.0f / 2048.0f, end = 20.0f * std::tan(kPi / 180.0f);
    addQuad(scene, vec3(-50, 0, -50), vec3(0, 0, 100), vec3(100, 0, 0), grey());
    addQuad(scene, vec3(0, 0, -20), vec3(0, 0, 40), vec3(0, 20, 0), grey());
    addLight(scene, sunLight(vec3(std::sin(kPi / 180.0f), -std::cos(kPi / 180.0f), 0), vec3(3.0f)));
    size = {512, 16};
    const Camera behind = lookAt(vec3(0.2f, 2, 2), vec3(0.2f, 0, 0), 0.01f), before = lookAt(vec3(-0.2f, 2, 2), vec3(-0.2f, 0, 0), 0.01f);
    const Image shaded = litShare(behind), lit = litShare(before);
    for (float x = 1.8f * texel; x < end - 1.8f * texel; x += 0.2f * texel)
        EXPECT_LT(litAt(shaded, behind, vec3(x, 0, 0)), 0.02f) << x / texel << " texels from the wall";
    for (float x = end + 1.8f * texel; x < end + 4.0f * texel; x += 0.2f * texel)
        EXPECT_GT(litAt(shaded, behind, vec3(x, 0, 0)), 0.98f) << x / texel << " texels from the wall";
    for (float x = -1.8f * texel; x > -4.0f * texel; x -= 0.2f * texel)
        EXPECT_GT(litAt(lit, before, vec3(x, 0, 0)), 0.98f) << x / texel << " texels from the wall";
}

// H68: in a convex room nothing stands between a lamp and a wall; a seam of the six maps would show as a dark line.
TEST_F(Shadow, APointLightInARoomLightsEveryWallAcrossTheSeams)
{
    addRoom(scene, vec3(-2), vec3(2), grey());
    addLight(scene, pointLight(vec3(0.1f, 0.2f, 0.3f), vec3(5.0f)));
    size = {64, 64};
    const Image lit = litShare(lookAt(vec3(-1.5f, -1.2f, 1.5f), vec3(2, 1, -2), 1.8f));
    EXPECT_GT(least(lit), 0.99f) << darker(lit, 0.99f);
}

// In a picture of few pixels a triangle that is drawn a little beside its place lies far off it.
TEST_F(Shadow, WallsWithSnappedCornersNeverShadowThemselves)
{
    for (const vec2 off : furthestOff()) EXPECT_GT(least(litInSnappedRoom({.shadow = true}, off)), 0.999f) << off.x << ' ' << off.y;
}

// What a pixel takes from the ones beside it must not be the sky's: it lies nowhere.
TEST_F(Shadow, AShadedRimBeforeTheSkyIsDark)
{
    for (const bool toon : {false, true}) {
        scene = {};
        scene.display.toon = toon;
        int asked = 0;
        EXPECT_EQ(litUnderRoof({.shadow = true, .toon = toon}, asked), 0) << (toon ? "in steps" : "");
        EXPECT_GT(asked, 1000);
    }
}

TEST_F(Shadow, ASpotLightCastsInsideItsCone)
{
    floor();
    addQuad(scene, vec3(-0.5f, 1, -0.5f), vec3(0, 0, 1), vec3(1, 0, 0), grey());
    Light spot = pointLight(vec3(0, 3, 0), vec3(9.0f));
    spot.type = kLightSpot;
    spot.cosInner = 0.9f;
    spot.cosOuter = 0.7f;
    addLight(scene, spot);
    size = {64, 64};
    const Camera side = lookAt(vec3(0, 0.8f, 5), vec3(0, 0, 0), 0.9f);
    const Image lit = litShare(side);
    EXPECT_NEAR(litAt(lit, side, vec3(0)), 0.0f, 1e-3f); // the plate's shadow reaches 0.75 m
    EXPECT_NEAR(litAt(lit, side, vec3(1.3f, 0, 0)), 1.0f, 1e-3f);
}

TEST_F(Shadow, WithoutALightThereIsNoAtlas)
{
    floor();
    const GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {});
    const std::uint64_t before = gpu.memory.bytes();
    const ShadowMaps maps = makeShadowMaps(gpu, uploaded, defaultShadowParameters());
    EXPECT_FALSE(maps.atlas);
    EXPECT_EQ(gpu.memory.bytes(), before);
}

TEST_F(Shadow, MapsOfTheAtlasNeverOverlapAndShrinkUntilTheyFit)
{
    for (int i = 0; i < 70; ++i) addLight(scene, i % 3 ? pointLight(vec3(float(i)), vec3(1)) : sunLight(vec3(0, -1, 0), vec3(1)));
    floor();
    const GpuScene uploaded = uploadScene(gpu, scene, instances(scene), scene.lights);
    ShadowParameters small = defaultShadowParameters();
    small.sunTexels = 512, small.faceTexels = 64;
    const ShadowMaps maps = makeShadowMaps(gpu, uploaded, small);
    for (std::size_t a = 0; a < maps.areas.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            const uvec4 p = maps.areas[a], q = maps.areas[b];
            EXPECT_TRUE(p.x + p.z <= q.x || q.x + q.z <= p.x || p.y + p.w <= q.y || q.y + q.w <= p.y) << a << ' ' << b;
        }
}

// Cascades: a level of 400 m, which one map resolves to 28 cm.
class Cascades : public Shadow
{
protected:
    void plain() { addQuad(scene, vec3(-200, 0, -200), vec3(0, 0, 400), vec3(400, 0, 0), grey()); }
    // 1 m above the ground; a sun at 45 degrees from -x casts its shadow to x 0..2, z -1..1.
    void plate() { addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey()); }
};

TEST_F(Cascades, AnEdgeBeforeTheEyeLiesWithinThreeCentimetresOfTheTruth)
{
    plain();
    plate();
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {512, 16};
    for (const float edge : {0.0f, 2.0f}) {
        const Camera camera = lookAt(vec3(edge, 0.5f, 1.2f), vec3(edge, 0, 0), 0.01f); // a pixel is 0.8 mm wide
        const Image lit = litShare(camera, SunMaps::cascades);
        const float inside = edge == 0.0f ? 1.0f : -1.0f;
        for (float away = 0.03f; away < 0.2f; away += 0.01f) {
            EXPECT_LT(litAt(lit, camera, vec3(edge + inside * away, 0, 0)), 0.02f) << away << " m inside of " << edge;
            EXPECT_GT(litAt(lit, camera, vec3(edge - inside * away, 0, 0)), 0.98f) << away << " m outside of " << edge;
        }
    }
}

// H68: on a plane from the eye's feet to the horizon no border of a map shows, the sun 10, 45 and 80 degrees from the zenith.
TEST_F(Cascades, NoBorderShowsOnAPlane)
{
    plain();
    size = {96, 96};
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    for (const float degrees : {10.0f, 45.0f, 80.0f}) {
        const float slope = std::tan(degrees * kPi / 180.0f);
        scene.lights[0].direction = normalize(vec3(0.8f * slope, -1, 0.6f * slope));
        EXPECT_GT(least(litShare(lookAt(vec3(20, 1.7f, 30), vec3(0, 0, 0), 1.2f), SunMaps::cascades)), 0.999f) << degrees << " degrees";
        EXPECT_GT(least(litShare(lookAt(vec3(0, 60, 0), vec3(0, 0, 0), 1.8f), SunMaps::cascades)), 0.999f) << degrees << " degrees, above";
    }
}

// In a level that calls for none they change the width of the blur at an edge, and nothing else: a texel of the level's map is
// 10 1.01 / 2048 m = 5 mm wide across the sun, 7 mm on the floor along it, and its filter reaches 1.5 of them; a pixel is 33 mm.
TEST_F(Cascades, ChangeASmallLevelOnlyAtTheEdgesOfShadows)
{
    floor();
    plate();
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {256, 256};
    const Image one = litShare(above), several = litShare(above, SunMaps::cascades);
    const View view = makeView(above, size);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            if (std::abs(one.at(x, y)[0] - several.at(x, y)[0]) <= 1.0f / 255.0f) continue;
            const vec4 near_ = view.clipToWorld * vec4((vec2(x, y) + 0.5f) / 128.0f - 1.0f, 1.0f, 1.0f);
            const vec3 direction = vec3(near_) / near_.w - vec3(0, 10, 0);
            const vec2 at = vec2(0, 0) - vec2(direction.x, direction.z) * (10.0f / direction.y);
            const vec2 outside = abs(at - vec2(1, 0)) - vec2(1); // of the shadow's square
            EXPECT_LT(std::abs(std::max(outside.x, outside.y)), 1.5f * 0.0072f) << at.x << ' ' << at.y;
        }
}

TEST_F(Cascades, MoveByWholeTexelsAndHoldWhatIsBeforeTheEye)
{
    plain();
    addLight(scene, sunLight(vec3(0.3f, -0.8f, 0.5f), vec3(3.0f)));
    const GpuScene uploaded = uploadScene(gpu, scene, instances(scene), scene.lights);
    const ShadowMaps maps = makeShadowMaps(gpu, uploaded, defaultShadowParameters(), SunMaps::cascades);
    ASSERT_EQ(maps.cascades.size() + 1, maps.sunMaps);
    ASSERT_GE(maps.sunMaps, 3u);
    const mat4 first = cascadeClip(maps.cascades[0], makeView(lookAt(vec3(0, 2, 0), vec3(1, 2, 0)), {160, 90}));
    int moved = 0;
    for (int i = 0; i < 40; ++i) {
        const View view = makeView(lookAt(vec3(0.1f * float(i), 2, 0), vec3(0.1f * float(i) + 1.0f, 2, 0)), {160, 90});
        const mat4 clip = cascadeClip(maps.cascades[0], view);
        const vec2 texels = vec2(clip[3] - first[3]) * 1024.0f;
        EXPECT_LT(length(texels - round(texels)), 0.02f);
        moved += clip != first;
        for (const float far_ : {0.1f, 3.0f, 12.0f}) {
            const vec4 seen = clip * vec4(0.1f * float(i) + far_, 2, 0, 1);
            EXPECT_LT(std::max(std::abs(seen.x), std::abs(seen.y)), 1.0f - kCascadeBlend) << far_ << " m before the eye";
        }
    }
    EXPECT_GT(moved, 20);
    EXPECT_EQ(first, cascadeClip(maps.cascades[0], makeView(lookAt(vec3(0.001f, 2, 0), vec3(1, 2, 0)), {160, 90})));
}

// Fog asks the same maps: a plate's shaft of shadow in the air takes as much light by cascades as by the one map of a small level.
TEST_F(Cascades, ShadeTheAirAsOneMapDoes)
{
    floor();
    plate();
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    Medium air{};
    air.scattering = vec3(0.1f);
    air.lower = vec3(-5, 0, -5), air.upper = vec3(5, 3, 5);
    scene.media.push_back(air);
    size = {16, 16};
    const Camera side = lookAt(vec3(0, 1, 6), vec3(0.5f, 0.5f, 0));
    const Image one = radiance(side, {.shadow = true, .fog = true});
    const Image several = radiance(side, {.shadow = true, .fog = true, .sun = SunMaps::cascades});
    double sum = 0, difference = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        sum += double(one.pixels[i]);
        difference += std::abs(double(one.pixels[i]) - double(several.pixels[i]));
    }
    EXPECT_LT(difference, 2e-3 * sum);
}
}
