// The eye of a frame: where its samples stand in their pixels, and that its matrices hold it.
#include "engine/effects/jitter.h"
#include "engine/effects/view.hpp"
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
}
