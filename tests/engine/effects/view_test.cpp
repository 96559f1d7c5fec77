// The eye of a frame: where its samples stand in their pixels, and that its matrices hold it.
#include "engine/effects/jitter.h"
#include "engine/effects/view.hpp"
#include "engine/effects/view_ray.h"
#include "shaders/camera.h"
#include "tests/engine/upload/toy_level.hpp"
#include <gtest/gtest.h>
#include <set>

namespace afterglow
{
TEST(Jitter, OfTheFirstFrameIsThePixelsCentre) { EXPECT_EQ(jitterOf(0), vec2(0.0f)); }

// A (0,2)-sequence: of 2^k frames from a multiple of 2^k on, each box of 2^-i by 2^(i-k) holds one.
TEST(Jitter, OfAnyPowerOfTwoFramesHasOneInEachBox)
{
    for (const uint power : {1u, 3u, 4u, 6u})
        for (const uint start : {0u, 5u << power})
            for (uint i = 0; i <= power; ++i) {
                std::set<std::pair<int, int>> boxes;
                for (uint frame = start; frame < start + (1u << power); ++frame) {
                    const vec2 p = jitterOf(frame) + 0.5f;
                    ASSERT_TRUE(p.x >= 0.0f && p.x < 1.0f && p.y >= 0.0f && p.y < 1.0f);
                    boxes.insert({int(p.x * float(1u << i)), int(p.y * float(1u << (power - i)))});
                }
                EXPECT_EQ(boxes.size(), std::size_t(1) << power) << power << ' ' << start << ' ' << i;
            }
}

// What stands at the sample is drawn at the pixel's centre, by either kind of camera.
TEST(View, BringsTheSampleToThePixelsCentre)
{
    Camera camera = lookAt(vec3(1, 2, 3), vec3(0, 0, -1));
    const vec2 jitter(0.375f, -0.25f);
    const uvec2 size(40, 30);
    for (const float fovY : {0.8f, 0.0f}) {
        camera.fovY = fovY, camera.orthoHeight = 5.0f;
        const View still = makeView(camera, size), moved = makeView(camera, size, {7, jitter});
        EXPECT_EQ(moved.frame, 7u);
        const vec2 pixel(11.5f, 20.5f);
        const float depth = fovY > 0.0f ? 0.01f : 0.999f; // 5 and 10 m away
        const vec3 seen = worldFromDepth((pixel + jitter) / vec2(size), depth, still.clipToWorld);
        const vec4 clip = moved.worldToClip * vec4(seen, 1.0f);
        const vec2 at = ndcToUv(vec2(clip) / clip.w) * vec2(size);
        EXPECT_NEAR(at.x, pixel.x, 1e-3f);
        EXPECT_NEAR(at.y, pixel.y, 1e-3f);
        EXPECT_NEAR(clip.z / clip.w, depth, 1e-5f);
    }
}

// Where the ray through `pixel` meets the plane z = -6.
static vec3 onWall(vec2 pixel, const View& view)
{
    const ViewRay ray = viewRay(pixel / vec2(view.size), 0.0f, view.clipToWorld, view.rayEye());
    const vec3 eye(view.eye);
    return eye + ray.direction * ((-6.0f - eye.z) / ray.direction.z);
}

// An eye below a mirror on the floor sees a wall whose corners stand a 512th of a pixel beside their places: its points lie off it by no
// more than is said.
TEST(View, KnowsHowFarSnappedCornersMoveWhatAMirrorShows)
{
    View view = makeView(lookAt(vec3(0.2f, -1.3f, 1), vec3(0, -0.4f, -5), 0.9f), {64, 48});
    const vec4 floor(0, 1, 0, -1e-4f);
    view.worldToClip = obliqueNearPlane(view.worldToClip, floor, obliqueReach(view.clipToWorld, floor));
    view.clipToWorld = inverse(view.worldToClip);
    view.fromNear = true;
    const vec2 size(view.size);
    int seen = 0;
    for (const vec2 off : {vec2(1, 1), vec2(1, -1), vec2(-1, 1), vec2(-1, -1)})
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                const vec2 pixel(float(x) + 0.5f, float(y) + 0.5f), uv = pixel / size;
                const vec3 drawn = onWall(pixel + off / 512.0f, view);
                if (drawn.y < 0.05f || drawn.y > 4.0f) continue; // under the mirror, or no wall
                const vec4 clip = view.worldToClip * vec4(drawn, 1.0f);
                const float depth = clip.z / clip.w;
                const vec3 read = worldFromDepth(uv, depth, view.clipToWorld);
                const float said = cornerRounding(read, uv, 1.0f / size, depth, view.clipToWorld);
                ++seen;
                EXPECT_LE(std::abs(read.z + 6.0f), said + 1e-5f * distance(read, vec3(view.eye))) << x << ' ' << y;
            }
    EXPECT_GT(seen, 4 * 64);
}
}
