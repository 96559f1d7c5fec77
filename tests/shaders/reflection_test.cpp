// Reflection probes: faces, solid angles, roughness by mip, and the box.
#include "shaders/frame.h"
#include "shaders/microfacet.h"
#include "shaders/random.h"
#include "shaders/reflection.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
TEST(Cube, FacesAndDirectionsAreInverse)
{
    Random random;
    for (int i = 0; i < 20000; ++i) {
        vec3 d = onSphere(2.0 * double(random.next()) - 1.0, 2.0 * M_PI * double(random.next()));
        vec3 face = cubeFace(d);
        EXPECT_NEAR(length(normalize(cubeDirection(int(face.z), vec2(face))) - d), 0.0f, 1e-6f);
        EXPECT_TRUE(face.x >= 0.0f && face.x <= 1.0f && face.y >= 0.0f && face.y <= 1.0f);
    }
    const vec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int f = 0; f < 6; ++f) EXPECT_EQ(cubeDirection(f, vec2(0.5f)), axes[f]);
    EXPECT_LT(cubeDirection(4, vec2(0.5f, 1.0f)).y, 0.0f); // rows run downwards on the sides
    EXPECT_GT(cubeDirection(4, vec2(1.0f, 0.5f)).x, 0.0f); // +z: +x to the right
}

TEST(Cube, TexelsCoverTheSphere)
{
    expectRelative(cubeTexelSolidAngle(0, 0, 16), 0.003414585924, 1e-5);
    expectRelative(cubeTexelSolidAngle(7, 7, 16), 0.01538522234, 1e-5);
    double sum = 0.0;
    for (int i = 0; i < 16; ++i)
        for (int j = 0; j < 16; ++j) sum += 6.0 * double(cubeTexelSolidAngle(i, j, 16));
    EXPECT_NEAR(sum, 4.0 * M_PI, 1e-5);
    // Fine texels keep their digits: at the middle of a face one is (2 / n)^2, at its corner 3^(-3/2) of that
    expectRelative(cubeTexelSolidAngle(512, 512, 1024), 4.0 / (1024.0 * 1024.0), 1e-5);
    expectRelative(cubeTexelSolidAngle(0, 0, 1024), 4.0 / (1024.0 * 1024.0) * std::pow(3.0, -1.5), 3e-3);
}

TEST(Reflection, RoughnessOfMips)
{
    for (int m = 0; m < 7; ++m) EXPECT_NEAR(reflectionMip(reflectionRoughness(float(m), 7.0f), 7.0f), float(m), 1e-5f);
    EXPECT_EQ(reflectionRoughness(0.0f, 7.0f), 0.0f);
    EXPECT_EQ(reflectionRoughness(6.0f, 7.0f), 1.0f);
    EXPECT_EQ(reflectionRoughness(0.0f, 1.0f), 0.0f);
    EXPECT_EQ(reflectionMip(0.7f, 1.0f), 0.0f);
}

// The middle of what a GGX lobe mirrors, by its facets: the axis is nearer to it than the mirror direction is. Radians off at 80 degrees,
// axis and mirror, for a roughness of 0.35, 0.5, 0.75, 1: 0.17 and 0.24, 0.35 and 0.52, 0.36 and 0.96, 0 and 1.29.
TEST(Reflection, LobesLeanTowardTheNormal)
{
    const vec3 normal(0, 0, 1);
    for (const float roughness : {0.0f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
        for (const float degrees : {0.0f, 30.0f, 60.0f, 80.0f}) {
            const vec3 o = fromDegrees(degrees, 0.0f), mirror(-o.x, -o.y, o.z);
            const vec2 alpha = max(roughnessToAlpha(roughness, 0.0f), vec2(kMirrorAlpha));
            vec3 sum(0.0f);
            for (uint i = 0; i < 1u << 14; ++i) {
                shared::Sampler random = makeSampler(3u, i);
                const vec3 l = mirrorDirection(o, sampleGgxVisible(o, alpha, next2(random)));
                if (l.z > 0.0f) sum += l * (ggxG2(o, l, alpha) / ggxG1(o, alpha));
            }
            const vec3 middle = normalize(sum), axis = lobeAxis(mirror, normal, roughness);
            EXPECT_NEAR(length(axis), 1.0f, 1e-5f);
            const float off = distance(axis, middle), mirrorOff = distance(mirror, middle); // radians, nearly
            EXPECT_LE(off, roughness < 0.5f ? mirrorOff + 0.01f : 0.7f * mirrorOff + 1e-3f) << roughness << " " << degrees;
        }
}

TEST(BoxParallax, MeetsItsValues)
{
    vec3 p(1), lo(0), hi(4, 3, 5), probe(2, 1.5f, 2.5f);
    struct Row {
        vec3 d, hit, dir;
        double t;
    };
    for (const Row& r : {Row{vec3(1, 0, 0), vec3(4, 1, 1), vec3(0.7844645406f, -0.1961161351f, -0.5883484054f), 3.0},
                         Row{normalize(vec3(1, 2, -1)), vec3(2, 3, 0), vec3(0, 0.5144957554f, -0.8574929257f), 2.449489743}}) {
        float t = boxExit(p, r.d, lo, hi);
        expectRelative(t, r.t, 1e-5, 1e-6);
        vec3 hit = p + r.d * t, dir = boxParallax(p, r.d, lo, hi, probe);
        for (int a = 0; a < 3; ++a) {
            expectRelative(hit[a], double(r.hit[a]), 1e-5, 1e-6);
            expectRelative(dir[a], double(r.dir[a]), 1e-5, 1e-6);
        }
    }
}

// H87
TEST(BoxParallax, IsSafeOnTheWallOutsideAndInsideOut)
{
    vec3 lo(0), hi(4, 3, 5), probe(2, 1.5f, 2.5f);
    for (vec3 p : {vec3(4, 1, 1), vec3(0, 0, 0), vec3(9, 9, 9), vec3(2, 1.5f, 2.5f), vec3(-3, 1, 1)})
        for (vec3 d : {vec3(1, 0, 0), vec3(0, -1, 0), normalize(vec3(1, 1, 1)), vec3(0, 0, -1)}) {
            EXPECT_GE(boxExit(p, d, lo, hi), 0.0f);
            EXPECT_NEAR(length(boxParallax(p, d, lo, hi, probe)), 1.0f, 1e-5f);
        }
    EXPECT_EQ(boxParallax(vec3(1), vec3(1, 0, 0), hi, lo, probe), vec3(1, 0, 0));
    EXPECT_EQ(boxExit(vec3(1), vec3(0), lo, hi), 0.0f);
}
}
