// Shadows by ray query that are not dark all over: penumbras of the light's size, and what lets light through.
#include "shaders/penumbra.h"
#include "tests/engine/effects/shadow_rays.hpp"
#include <cstdio>

namespace afterglow
{
// The penumbra of a disc behind a straight edge (shaders/penumbra.h, shadow.penumbra_profile): a sun of 4 degrees square above the floor,
// an edge 1 m above it. Rays of a pixel are stratified, so 64 pixels of 64 rays each are worth at least 4096 independent ones.
TEST_F(ShadowsByRay, ThePenumbraOfASunIsThatOfADiscBehindAnEdge)
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
TEST_F(ShadowsByRay, ThePenumbraOfALampIsAsWideAsSimilarTrianglesSay)
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

// A blended sheet lets 1 - alpha by; a mask all or nothing, by its texel, its alpha equal to the cutoff keeping (H51).
TEST_F(ShadowsByRay, PassWhatIsCutOutAndShareWhatIsBlended)
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
}
