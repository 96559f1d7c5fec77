// What occlusion takes from the light: bounds, ends, and the closed form of surroundings that are as bright as the point.
#include "shaders/visibility.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
TEST(Visibility, OfABlackSurfaceIsItsOwn)
{
    for (int i = 0; i <= 100; ++i) {
        const float v = 0.01f * float(i);
        EXPECT_NEAR(bouncedVisibility(v, vec3(0.0f)).x, v, 0.05f); // the fit's own error
        EXPECT_GE(bouncedVisibility(v, vec3(0.0f)).x, v);
    }
}

TEST(Visibility, NeverLeavesItsBoundsAndEndsInNothingAndAll)
{
    for (int r = 0; r <= 20; ++r) {
        const vec3 albedo(0.05f * float(r));
        EXPECT_EQ(bouncedVisibility(1.0f, albedo).x, 1.0f);
        EXPECT_EQ(bouncedVisibility(0.0f, albedo).x, 0.0f);
        float before = 0.0f;
        for (int i = 0; i <= 100; ++i) {
            const float v = 0.01f * float(i), bounced = bouncedVisibility(v, albedo).x;
            EXPECT_GE(bounced, v);
            EXPECT_LE(bounced, 1.0f);
            EXPECT_GE(bounced, before - 1e-3f) << "more opening, more light";
            before = bounced;
        }
    }
}

// What hides is as bright as what is hidden: L = albedo (v + (1 - v) L / albedo ...), that is v / (1 - albedo (1 - v)) of the open surface.
TEST(Visibility, BouncesAsAmongEquals)
{
    for (const float albedo : {0.2f, 0.5f, 0.8f})
        for (const float v : {0.3f, 0.5f, 0.7f, 0.9f})
            EXPECT_NEAR(bouncedVisibility(v, vec3(albedo)).x, v / (1.0f - albedo * (1.0f - v)), 0.07f) << albedo << ' ' << v;
}

TEST(Visibility, OfASharpMirrorFadesLate)
{
    for (const float cosine : {0.1f, 0.5f, 1.0f})
        for (const float roughness : {0.0f, 0.3f, 1.0f}) {
            EXPECT_EQ(specularVisibility(1.0f, cosine, roughness), 1.0f);
            EXPECT_GE(specularVisibility(0.5f, cosine, roughness), 0.0f);
        }
    EXPECT_GT(specularVisibility(0.7f, 0.9f, 0.0f), 0.9f);
    EXPECT_NEAR(specularVisibility(0.5f, 1.0f, 0.5f), 0.51275f, 1e-4f); // alpha 1/4: 1.5^(1/32) - 1/2
    EXPECT_NEAR(specularVisibility(0.7f, 0.5f, 1.0f), 0.7f, 1e-3f);     // a lobe as wide as the hemisphere
}
}
