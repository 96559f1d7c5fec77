// The camera: reversed depth without a far plane, its inverse, mirrors, and what is no camera.
#include "shaders/camera.h"
#include "tests/shaders/statistics.hpp"
#include <limits>

namespace afterglow::test
{
namespace
{
vec3 project(const mat4& m, vec3 p)
{
    vec4 c = m * vec4(p, 1.0f);
    return vec3(c) / c.w;
}
}

TEST(Camera, DepthIsNearOverDistance)
{
    mat4 p = perspectiveReversed(1.0f, 1.5f, 0.1f);
    expectRelative(project(p, vec3(0, 0, -0.1f)).z, 1.0, 1e-6);
    expectRelative(project(p, vec3(0, 0, -1000.0f)).z, 1e-4, 1e-6);
    EXPECT_GT(project(p, vec3(0, 0, -1e30f)).z, 0.0f);
    expectRelative(depthToDistance(distanceToDepth(37.0f, 0.1f), 0.1f), 37.0, 1e-6);
    EXPECT_EQ(depthToDistance(0.0f, 0.1f), kFloatMax);
}

TEST(Camera, PictureIsRightSideUp)
{
    mat4 p = perspectiveReversed(1.0f, 1.5f, 0.1f);
    vec2 uv = ndcToUv(vec2(project(p, vec3(1, 1, -5))));
    EXPECT_GT(uv.x, 0.5f); // +x to the right
    EXPECT_LT(uv.y, 0.5f); // +y to the top
    // The top edge of the picture is half the field of view up
    EXPECT_NEAR(project(p, vec3(0, std::tan(0.5f), -1)).y, -1.0f, 1e-6f);
}

TEST(Camera, WorldComesBackFromDepth)
{
    mat4 p = perspectiveReversed(0.8f, 1.7f, 0.05f), o = orthographicReversed(4.0f, 3.0f, -2.0f, 50.0f);
    for (const mat4& m : {p, o})
        for (vec3 point : {vec3(0.3f, -0.2f, -1), vec3(1, 2, -9), vec3(-2, 1, -40)}) {
            vec3 c = project(m, point);
            EXPECT_NEAR(length(worldFromDepth(ndcToUv(vec2(c)), c.z, inverse(m)) - point), 0.0f, 2e-4f * length(point));
        }
    EXPECT_NEAR(project(o, vec3(0, 0, 2)).z, 1.0f, 1e-6f);
    EXPECT_NEAR(project(o, vec3(0, 0, -50)).z, 0.0f, 1e-6f);
    vec3 c = project(p, vec3(1, 2, -9));
    EXPECT_NEAR(length(viewDirection(ndcToUv(vec2(c)), vec2(p[0][0], p[1][1])) - normalize(vec3(1, 2, -9))), 0.0f, 1e-6f);
}

TEST(Camera, RefusesWhatHasNoPicture)
{
    const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
    EXPECT_TRUE(validPerspective(0.8f, 1.0f, 0.05f));
    for (float fov : {0.0f, -1.0f, kPi, 4.0f, nan}) EXPECT_FALSE(validPerspective(fov, 1.0f, 0.05f));
    for (float near : {0.0f, -1.0f, inf, nan}) EXPECT_FALSE(validPerspective(0.8f, 1.0f, near));
    for (float aspect : {0.0f, -1.0f, inf, nan}) EXPECT_FALSE(validPerspective(0.8f, aspect, 0.05f));
    EXPECT_TRUE(validOrthographic(2.0f, 1.0f, -1.0f, 10.0f));
    EXPECT_FALSE(validOrthographic(2.0f, 1.0f, 10.0f, 1.0f));
    EXPECT_FALSE(validOrthographic(0.0f, 1.0f, 0.0f, 1.0f));
}

TEST(Camera, DepthSteps)
{
    expectRelative(depthStepUnorm(100.0f, 0.1f, 1000.0f, 24.0f), 0.005959868431, 1e-4);
    expectRelative(depthStepUnorm(100.0f, 0.1f, 1000.0f, 16.0f), 1.525726318, 1e-4);
    expectRelative(depthStepReversedFloat(100.0f), 1.192092896e-05, 0.6);
    // 1/n - 1/f rather than (f - n) / (f n): an infinite far plane has a step
    expectRelative(depthStepUnorm(100.0f, 0.1f, std::numeric_limits<float>::infinity(), 24.0f), 1e4 * 10.0 / 16777216.0, 1e-6);
}

TEST(Mirror, PointAndMatrix)
{
    // From eye height 1, a wall's point at height 1 and distance 10 is seen in the floor 5 m away: on the line to its mirror image
    vec3 eye(0, 1, 0), image = mirrorPoint(vec3(0, 1, 10), vec3(0, 1, 0), 0.0f);
    expectRelative(mix(eye, image, eye.y / (eye.y - image.y)).z, 5.0, 1e-6);
    vec3 m = mirrorPoint(vec3(1, 2, 3), vec3(0, 1, 0), 0.5f);
    EXPECT_NEAR(length(m - vec3(1, -1, 3)), 0.0f, 1e-6f);
    vec3 n = normalize(vec3(1, 2, -2)), x(3, -1, 4);
    EXPECT_NEAR(length(vec3(mirrorMatrix(n, 0.7f) * vec4(x, 1.0f)) - mirrorPoint(x, n, 0.7f)), 0.0f, 1e-5f);
    EXPECT_NEAR(length(mirrorPoint(mirrorPoint(x, n, 0.7f), n, 0.7f) - x), 0.0f, 1e-5f);
}

// The oblique near plane: depth 1 on the plane, below 1 beyond it, above 1 (clipped) before it, and never below 0 within the frustum.
TEST(Mirror, ObliqueNearPlaneCutsAtTheMirror)
{
    mat4 p = perspectiveReversed(1.0f, 1.3f, 0.1f);
    vec3 n = normalize(vec3(0.2f, 0.5f, -1.0f));
    vec4 plane(n, -2.0f); // kept: n.p >= 2
    mat4 m = obliqueNearPlane(p, plane, obliqueReach(inverse(p), plane));
    Random random;
    float least = 1.0f;
    for (int i = 0; i < 2000; ++i) {
        vec2 ndc = random.next2() * 2.0f - 1.0f;
        vec3 d = viewDirection(ndcToUv(ndc), vec2(p[0][0], p[1][1]));
        if (dot(n, d) < 0.05f) continue;
        float t = 2.0f / dot(n, d);
        EXPECT_NEAR(project(m, d * t).z, 1.0f, 1e-4f);
        EXPECT_GT(project(m, d * (t * 0.9f)).z, 1.0f);
        float far = project(m, d * (t * 1e4f)).z;
        EXPECT_TRUE(far < 1.0f && far >= -1e-4f) << far;
        least = min(least, far);
        EXPECT_NEAR(length(vec2(project(m, d)) - ndc), 0.0f, 1e-5f); // the picture itself does not move
    }
    EXPECT_LT(least, 0.05f); // no depth is given away: the corner that looks furthest beyond the plane comes close to 0
    // A plane that keeps only what is behind the eye
    EXPECT_LE(obliqueReach(inverse(p), vec4(0, 0, 1, -1)), 0.0f);
}

// The same of an orthographic view, whose depth runs from the plane to the end of its box.
TEST(Mirror, ObliqueNearPlaneOfAnOrthographicView)
{
    mat4 p = orthographicReversed(4.0f, 3.0f, -2.0f, 50.0f);
    vec4 plane(normalize(vec3(0.2f, 0.5f, -1.0f)), -2.0f);
    mat4 m = obliqueNearPlane(p, plane, obliqueReach(inverse(p), plane)), back = inverse(m);
    Random random;
    for (int i = 0; i < 2000; ++i) {
        vec3 at = vec3(random.next2() * 2.0f - 1.0f, random.next2().x) * vec3(4.0f, 3.0f, -52.0f) + vec3(0, 0, 2); // anywhere in the box
        vec3 clip = project(m, at);
        EXPECT_EQ(dot(plane, vec4(at, 1.0f)) > 1e-4f, clip.z < 1.0f - 1e-6f);
        if (clip.z <= 1.0f) {
            EXPECT_GE(clip.z, -1e-5f);
            EXPECT_NEAR(length(worldFromDepth(ndcToUv(vec2(clip)), clip.z, back) - at), 0.0f, 1e-4f);
        }
        EXPECT_NEAR(length(vec2(clip) - vec2(project(p, at))), 0.0f, 1e-6f);
    }
}
}
