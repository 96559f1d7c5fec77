// Shadows: where they must fall, and above all where they must not.
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class Shadow : public Drawn
{
protected:
    uint grey() { return scene.materials.empty() ? addMaterial(scene, matte(vec3(0.64f))) : 0u; }
    // 10 m of floor, seen from above; picture x runs along +x, picture y along +z.
    void floor() { addQuad(scene, vec3(-5, 0, -5), vec3(0, 0, 10), vec3(10, 0, 0), grey()); }
    const Camera above = lookAt(vec3(0, 10, 0), vec3(0), 0.8f);

    // Each pixel's radiance with shadows over that without.
    Image litShare(const Camera& camera)
    {
        const Image without = radiance(camera);
        Image with = radiance(camera, {.shadow = true});
        for (std::size_t i = 0; i < with.pixels.size(); ++i)
            with.pixels[i] = without.pixels[i] > 0.0f ? with.pixels[i] / without.pixels[i] : 1.0f;
        return with;
    }
    static float least(const Image& image)
    {
        float result = 1.0f;
        for (int i = 0; i < image.width * image.height; ++i) result = std::min(result, image.pixels[std::size_t(i) * image.channels]);
        return result;
    }
};

TEST_F(Shadow, FallsWhereTheSunIsHiddenAndNowhereElse)
{
    // A plate of 2 m hangs 1 m above the floor under a sun at 45 degrees from -x: its shadow covers x 0..2, z -1..1.
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, sunLight(vec3(1, -1, 0), vec3(3.0f)));
    size = {64, 64};
    const Image lit = litShare(lookAt(vec3(0, 0.9f, 6), vec3(0.5f, 0, 0), 0.9f)); // from the side, under the plate
    const View view = makeView(lookAt(vec3(0, 0.9f, 6), vec3(0.5f, 0, 0), 0.9f), size);
    const auto at = [&](vec3 world) {
        const vec4 clip = view.worldToClip * vec4(world, 1.0f);
        return lit.at(int((clip.x / clip.w * 0.5f + 0.5f) * 64), int((clip.y / clip.w * 0.5f + 0.5f) * 64))[0];
    };
    EXPECT_NEAR(at(vec3(1, 0, 0)), 0.0f, 1e-3f);
    EXPECT_NEAR(at(vec3(1.7f, 0, 0.7f)), 0.0f, 1e-3f);
    EXPECT_NEAR(at(vec3(-0.5f, 0, 0)), 1.0f, 1e-3f);
    EXPECT_NEAR(at(vec3(2.5f, 0, 0)), 1.0f, 1e-3f);
    EXPECT_NEAR(at(vec3(1, 0, 1.6f)), 1.0f, 1e-3f);
}

// H31, H67: no plane shadows itself, whether the sun stands at the zenith or 80 degrees from it, along an axis or a diagonal.
TEST_F(Shadow, APlaneNeverShadowsItself)
{
    floor();
    size = {48, 48};
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
    const float grazing = std::tan(1.3962634f); // 80 degrees
    for (const vec3 direction :
         {vec3(0, -1, 0), vec3(grazing, -1, 0), vec3(0.7071f * grazing, -1, 0.7071f * grazing), vec3(0.3f, -1, 0.1f)}) {
        scene.lights[0].direction = normalize(direction);
        EXPECT_GT(least(litShare(above)), 0.999f) << direction.x << ' ' << direction.z;
    }
}

// H68: in a convex room nothing stands between a lamp and a wall; a seam of the six maps would show as a dark line.
TEST_F(Shadow, APointLightInARoomLightsEveryWallAcrossTheSeams)
{
    addRoom(scene, vec3(-2), vec3(2), grey());
    addLight(scene, pointLight(vec3(0.1f, 0.2f, 0.3f), vec3(5.0f)));
    size = {64, 64};
    EXPECT_GT(least(litShare(lookAt(vec3(-1.5f, -1.2f, 1.5f), vec3(2, 1, -2), 1.8f))), 0.99f);
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
    const View view = makeView(side, size);
    const auto at = [&](vec3 world) {
        const vec4 clip = view.worldToClip * vec4(world, 1.0f);
        return lit.at(int((clip.x / clip.w * 0.5f + 0.5f) * 64), int((clip.y / clip.w * 0.5f + 0.5f) * 64))[0];
    };
    EXPECT_NEAR(at(vec3(0)), 0.0f, 1e-3f); // the plate's shadow reaches 0.75 m
    EXPECT_NEAR(at(vec3(1.3f, 0, 0)), 1.0f, 1e-3f);
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
}
