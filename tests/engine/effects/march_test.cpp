// The march through a pyramid of depths, without a GPU: a picture's depths by closed form, and where a ray must meet them.
#include "shaders/camera.h"
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

namespace shared
{
struct DepthPyramid {
    ivec2 size;
    const std::vector<std::vector<vec2>>* levels; // of a square that halves evenly
    int edge;
};
inline vec2 depthRange(DepthPyramid p, int level, ivec2 cell)
{
    const ivec2 at = clamp(cell, ivec2(0), (p.size - 1) >> level);
    return (*p.levels)[std::size_t(level)][std::size_t(at.y * (p.edge >> level) + at.x)];
}
inline float depthBetween(DepthPyramid p, vec2 at)
{
    const vec2 corner = floor(at - 0.5f), f = at - 0.5f - corner;
    const auto depth = [&](int x, int y) { return depthRange(p, 0, ivec2(corner) + ivec2(x, y)).x; };
    return mix(mix(depth(0, 0), depth(1, 0), f.x), mix(depth(0, 1), depth(1, 1), f.x), f.y);
}
}
#include "engine/effects/reflection/march.h"

namespace afterglow
{
using namespace shared;

constexpr float kNear = 0.05f;

// A picture whose depths a function of the eye's ray says: the eye at 0 looks along -z.
class Marched : public ::testing::Test
{
protected:
    ivec2 size{128, 128};
    int edge = 0;
    std::vector<std::vector<vec2>> levels;
    mat4 worldToClip{1.0f};

    // `distance`: along -z to what the ray (x, y, -1) meets; 0: the sky.
    void picture(ivec2 pixels, const std::function<float(vec2)>& distance)
    {
        size = pixels;
        worldToClip = perspectiveReversed(kHalfPi, float(size.x) / float(size.y), kNear);
        for (edge = 64; edge < max(size.x, size.y);) edge *= 2;
        levels.assign(1, std::vector<vec2>(std::size_t(edge * edge)));
        for (int y = 0; y < edge; ++y)
            for (int x = 0; x < edge; ++x) {
                const ivec2 at = min(ivec2(x, y), size - 1);
                const vec2 ndc = uvToNdc((vec2(at) + 0.5f) / vec2(size));
                const float z = distance(vec2(ndc.x * float(size.x) / float(size.y), -ndc.y));
                levels[0][std::size_t(y * edge + x)] = vec2(z > 0.0f ? kNear / z : 0.0f);
            }
        for (int half = edge / 2; half >= 1; half /= 2) {
            const std::vector<vec2>& fine = levels.back();
            std::vector<vec2> coarse;
            for (int y = 0; y < half; ++y)
                for (int x = 0; x < half; ++x) {
                    vec2 range(0.0f, 2.0f);
                    for (int k = 0; k < 4; ++k) {
                        const vec2 r = fine[std::size_t((2 * y + k / 2) * 2 * half + 2 * x + k % 2)];
                        range = vec2(std::max(range.x, r.x), std::min(range.y, r.y));
                    }
                    coarse.push_back(range);
                }
            levels.push_back(coarse);
        }
    }
    MarchHit send(vec3 origin, vec3 direction, uint bisections = 8, float thickness = 0.04f, uint steps = 512) const
    {
        March how{steps, bisections, 7, {thickness, 0.0f}};
        return march({size, &levels, edge}, rayOf(origin, direction), how);
    }
    ScreenRay rayOf(vec3 origin, vec3 direction) const { return makeScreenRay(worldToClip, origin, direction, vec2(size)); }
    // Where the place on the ray is, by the ray's own depth.
    vec3 place(vec3 origin, vec3 direction, float along) const
    {
        const vec3 p = alongRay(rayOf(origin, direction), along);
        return worldFromDepth(vec2(p) / vec2(size), p.z, inverse(worldToClip));
    }
};

// The floor y = -1 up to the wall at z = -10: `ssr.wall_row` with e = 1, D = 10. A ray from the floor at distance d meets the wall at the
// height (10 - d) / d over the floor.
static float room(vec2 slope) { return slope.y < -0.1f ? -1.0f / slope.y : 10.0f; }

// The mean error of the height met, over rays from d = 3.2 .. 6.4 m, in m.
template <typename Send>
static double wallError(Send send)
{
    double sum = 0.0;
    const int rays = 201;
    for (int i = 0; i < rays; ++i) {
        const float d = 3.2f + 3.2f * float(i) / float(rays - 1);
        sum += std::abs(send(d) - double(10.0f - d) / double(d));
    }
    return sum / rays;
}

class WallRow : public Marched
{
protected:
    double error(ivec2 pixels, uint bisections)
    {
        picture(pixels, room);
        int lost = 0;
        const double mean = wallError([&](float d) {
            const vec3 origin(0.01f, -1, -d), direction = normalize(vec3(0.01f, 1, -d));
            const MarchHit hit = send(origin, direction, bisections);
            if (!(hit.along < 1.0f)) ++lost;
            return double(place(origin, direction, std::min(hit.along, 0.999f)).y) + 1.0;
        });
        EXPECT_EQ(lost, 0) << pixels.x << " px, " << bisections << " bisections";
        return mean;
    }
};

TEST_F(WallRow, IsMetWhereTheMirroredRaySays)
{
    picture({256, 256}, room);
    const vec3 origin(0, -1, -5), direction = normalize(vec3(0, 1, -5)); // z = D e / (e + y) = 5 sees the wall at y = 1
    const MarchHit hit = send(origin, direction, 12);
    EXPECT_NEAR(place(origin, direction, hit.along).y, 0.0f, 1e-3f);
    EXPECT_LT(hit.behind, 0.01f);
}

// Cost law of the march: without bisection the error is a part of a cell, so it falls with the number of cells across the picture.
TEST_F(WallRow, ErrorFallsAsOneOverTheCellsOfThePicture)
{
    std::vector<double> errors;
    for (const int edge_ : {32, 128, 512}) errors.push_back(error(ivec2(edge_), 0));
    const double slope = std::log(errors[2] / errors[0]) / std::log(16.0);
    std::printf("cells 32, 128, 512: error %.4f %.4f %.5f m, slope %.3f\n", errors[0], errors[1], errors[2], slope);
    EXPECT_NEAR(slope, -1.0, 0.15);
}

// And each bisection halves it: depths are linear between pixels, so a wall is met exactly in the end.
TEST_F(WallRow, EachBisectionHalvesTheError)
{
    std::vector<double> errors;
    for (const uint k : {0u, 2u, 4u, 6u}) errors.push_back(error(ivec2(128), k));
    const double slope = std::log2(errors[3] / errors[0]) / 6.0;
    std::printf("bisections 0, 2, 4, 6: error %.5f %.5f %.6f %.7f m, slope %.3f\n", errors[0], errors[1], errors[2], errors[3], slope);
    EXPECT_NEAR(slope, -1.0, 0.15);
}

// The pyramid pays: the same places are met as by the finest cells alone, in a fraction of the steps.
TEST_F(Marched, ThePyramidMeetsTheSameInFewerSteps)
{
    picture({512, 512}, room);
    const vec3 origin(-4, -1, -5), direction = normalize(vec3(12, 1, -5));
    const MarchHit hit = send(origin, direction);
    const MarchHit flat = march({size, &levels, edge}, rayOf(origin, direction), {512, 8, 1, {0.04f, 0.0f}});
    EXPECT_NEAR(hit.along, flat.along, 1e-4f);
    EXPECT_LT(hit.steps * 2, flat.steps);
}

// H70: to the eye, behind the near plane, off the picture, into the sky. Nothing is met, nothing is NaN.
TEST_F(Marched, RaysThatLeaveThePictureMeetNothing)
{
    picture({96, 64}, [](vec2) { return 10.0f; });
    const vec3 origin(1, 0.5f, -10);
    for (const vec3 direction :
         {vec3(-1, -0.5f, 10), vec3(0, 0, 1), vec3(0.01f, 0, 1), vec3(1, 0, 0.01f), vec3(0, -1, 0.2f), vec3(3, 2, 1)}) {
        const ScreenRay ray = rayOf(origin, normalize(direction));
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(ray.to[c]));
        const vec3 inside = clamp(ray.to, vec3(0.0f), vec3(96, 64, 1));
        EXPECT_LT(length(ray.to - inside), 1e-3f) << ray.to.x << ' ' << ray.to.y << ' ' << ray.to.z;
        EXPECT_EQ(send(origin, normalize(direction)).along, 1.0f);
    }
    picture({96, 64}, [](vec2 slope) { return slope.y < 0.0f ? -1.0f / slope.y : 0.0f; });
    EXPECT_EQ(send(vec3(0, -1, -5), normalize(vec3(0, 1, -5))).along, 1.0f) << "the sky is no wall (H65)";
    EXPECT_EQ(send(vec3(0, -0.9f, -5), vec3(0, 0, -1)).along, 1.0f) << "toward the vanishing point, infinitely far";
}

// A ray that passes behind a pillar goes on to the wall: the farthest depths say that it has left everything behind.
TEST_F(Marched, ARayPassesBehindWhatIsThin)
{
    picture({256, 256}, [](vec2 slope) { return std::abs(slope.x) < 0.2f ? 2.0f : 10.0f; });
    const vec3 origin(-9, 0, -9.5f),
        direction = normalize(vec3(18, 0.3f, -0.6f)); // crosses the picture behind the pillar, meets the wall at x = 6
    const MarchHit hit = send(origin, direction);
    ASSERT_LT(hit.along, 1.0f);
    EXPECT_NEAR(place(origin, direction, hit.along).x, 6.0f, 0.05f);
}

// Sizes that no power of two divides: the last cells hold the border's pixels.
TEST_F(Marched, OddSizesMeetTheWallAtTheirLastPixels)
{
    for (const ivec2 odd : {ivec2(97, 61), ivec2(65, 127), ivec2(33, 9)}) {
        picture(odd, [](vec2 slope) { return slope.x > 0.0f ? 4.0f / (0.4f + slope.x) : 10.0f; }); // a wall that comes nearer to the right
        const float aspect = float(odd.x) / float(odd.y), right = aspect * (1.0f - 2.2f / float(odd.x)); // slope in the last pixel but one
        const vec3 target = vec3(right, 0, -1) * (4.0f / (0.4f + right)), origin(-1, 0, -2);
        const MarchHit hit = send(origin, normalize(target - origin));
        ASSERT_LT(hit.along, 1.0f) << odd.x;
        EXPECT_NEAR(length(place(origin, normalize(target - origin), hit.along) - target), 0.0f, 0.1f) << odd.x;
    }
}
}
