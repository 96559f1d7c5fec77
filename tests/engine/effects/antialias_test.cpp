// Frames gathered into one picture: their mean at rest, what an edge covers of a pixel, no ghosts in motion, any size.
#include "engine/effects/antialias/antialias.h"
#include "engine/effects/antialias/antialias.hpp"
#include "engine/effects/jitter.h"
#include "tests/engine/effects/drawn.hpp"
#include <cmath>
#include <cstdio>

namespace afterglow
{
class Antialias : public Drawn
{
protected:
    struct Frame {
        Image drawn, gathered;
    };

    // A surface that shines by itself, across the view along -z.
    uint lamp(vec3 corner, vec3 u, vec3 v, float emission)
    {
        Material m = matte(vec3(0.0f));
        m.emission = vec3(emission);
        addQuad(scene, corner, u, v, addMaterial(scene, m));
        return uint(scene.objects.size() - 1);
    }
    // Bars before a dim sky: slanted, some thinner than a pixel, at two distances.
    void bars()
    {
        scene.sky.radiance = vec3(0.2f);
        for (int i = -6; i <= 6; ++i) {
            const float x = 0.7f * float(i), wide = i % 2 ? 0.25f : 0.05f;
            lamp(vec3(x, -3, i % 3 ? -5.0f : -4.0f), vec3(wide, 0, 0), vec3(0.6f, 6, 0), 1.0f + float((i + 6) % 4));
        }
    }

    // The next frame of the picture that is being gathered.
    Frame frame(const Camera& camera, float scale = 1.0f)
    {
        if (!level) level = std::make_unique<GpuLevel>(gpu, uploadScene(gpu, scene, placed(), {}), uploadBaked(gpu, baked, {}));
        const uvec2 drawn = max(uvec2(round(vec2(size) * scale)), 1u);
        View view = makeView(camera, size, {gathered.frames, jitterOf(gathered.frames), drawn});
        view.last = std::exchange(lastEye, view.steady);
        Graph graph;
        const GBuffer surfaces = geometry(graph, view, level->scene, {.emission = true});
        const Texture image =
            lighting(graph, view, surfaces, {}, {}, *level, {meanSky(scene.sky), scene.sky.radiance, scene.sky.rotation}, {}).radiance;
        const Texture result = antialias(graph, view, surfaces, level->scene, image, {size, scale < 1.0f}, gathered);
        settle(level->scene);
        graph.output(image);
        graph.output(result);
        stats = executor.run(graph, level->set);
        return {executor.download(image), executor.download(result)};
    }
    Image gather(const Camera& camera, int frames, float scale = 1.0f)
    {
        Image last;
        for (int i = 0; i < frames; ++i) last = frame(camera, scale).gathered;
        return last;
    }
    // The picture with nothing before it.
    Image afresh(const Camera& camera, int frames)
    {
        gathered = {};
        return gather(camera, frames);
    }
    bool ran(const std::string& pass) const
    {
        for (const PassStats& p : stats.passes)
            if (p.name == pass) return true;
        return false;
    }
    static double rmse(const Image& a, const Image& b)
    {
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); i += 4) sum += std::pow(double(a.pixels[i]) - double(b.pixels[i]), 2.0);
        return std::sqrt(sum / double(a.pixels.size() / 4));
    }

    std::unique_ptr<GpuLevel> level;
    Gathered gathered;
    dmat4 lastEye{1.0};
    const Camera ahead = lookAt(vec3(0), vec3(0, 0, -1));
};

// The law of the weights, without a GPU.
TEST(AntialiasLaws, ThePastIsPulledIntoTheBoxAndNoFurther)
{
    const vec3 mean(1.0f, 0.2f, -0.1f), deviation(0.1f, 0.0f, 0.2f);
    EXPECT_EQ(believed(mean, mean, deviation), mean);
    const vec3 inside = mean + vec3(0.1f, 0.0f, -0.2f);
    EXPECT_EQ(believed(inside, mean, deviation), inside);
    const vec3 pulled = believed(mean + vec3(10.0f, 0.0f, 1.0f), mean, deviation) - mean;
    EXPECT_NEAR(pulled.x, kBelieved * 0.1f, 1e-5f);
    EXPECT_NEAR(pulled.z, 0.1f * pulled.x, 1e-5f) << "straight toward the mean";
    for (const vec3 c : {vec3(0.0f), vec3(1.0f, 2.0f, 3.0f), vec3(60000.0f, 0.0f, 1.0f)}) {
        const vec3 back = fromLumaChroma(toLumaChroma(c));
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(back[i], c[i], 1e-6f * 60000.0f);
    }
}

// At rest: the mean of 64 frames, to rounding, in every pixel.
TEST_F(Antialias, AtRestIsTheMeanOfItsFrames)
{
    bars();
    size = {37, 23};
    std::vector<double> mean(std::size_t(size.x) * size.y * 4, 0.0);
    for (int i = 1; i <= 64; ++i) {
        const Frame f = frame(ahead);
        for (std::size_t p = 0; p < mean.size(); ++p) mean[p] += (double(f.drawn.pixels[p]) - mean[p]) / i;
        if (i != 1 && i != 16 && i != 64) continue;
        for (std::size_t p = 0; p < mean.size(); ++p)
            ASSERT_NEAR(double(f.gathered.pixels[p]), p % 4 == 3 ? i : mean[p], 1e-5 * std::max(1.0, mean[p])) << i << ' ' << p;
    }
    EXPECT_FALSE(ran("antialias.motion"));
}

// A lamp of radiance 2 that covers a known share of a column of pixels: after 64 frames, whose samples stand in 64 columns of the pixel, it
// is known to 1/64; drawn at half the size 16 of them fall into each shown pixel.
TEST_F(Antialias, ShowsTheShareOfAPixelThatAnEdgeCovers)
{
    size = {16, 8};
    Camera flat = ahead;
    flat.fovY = 0.0f, flat.orthoHeight = 8.0f; // a pixel is 1 m
    for (const float share : {0.1f, 0.37f, 0.75f}) {
        scene = {};
        lamp(vec3(-9, -9, -5), vec3(9.0f + 2.0f + share, 0, 0), vec3(0, 18, 0), 2.0f); // its edge in column 10
        for (const auto& [scale, samples] : {std::pair(1.0f, 64.0f), std::pair(0.5f, 16.0f)}) {
            level.reset(), gathered = {};
            const Image result = gather(flat, 64, scale);
            for (int y = 0; y < 8; ++y) {
                EXPECT_NEAR(*result.at(10, y), 2.0f * share, 2.0f / samples + 0.02f) << share << ' ' << scale << ' ' << y;
                EXPECT_NEAR(*result.at(9, y), 2.0f, 1e-5f);
                EXPECT_NEAR(*result.at(11, y), 0.0f, 1e-5f);
            }
        }
    }
}

// H72: the first frame is the frame, at any size and by either camera; a picture of another size begins anew.
TEST_F(Antialias, BeginsWithTheFrameItself)
{
    bars();
    Camera flat = ahead;
    flat.fovY = 0.0f, flat.orthoHeight = 5.0f;
    for (const Camera& camera : {ahead, flat})
        for (const uvec2 of : {uvec2(1, 1), uvec2(1, 9), uvec2(13, 1), uvec2(21, 14)}) {
            size = of;
            gathered = {};
            const Frame f = frame(camera);
            for (std::size_t p = 0; p < f.drawn.pixels.size(); ++p) {
                if (p % 4 == 3)
                    EXPECT_EQ(f.gathered.pixels[p], 1.0f);
                else
                    EXPECT_EQ(f.gathered.pixels[p], f.drawn.pixels[p]);
            }
            gather(camera, 3);
        }
    size = {30, 20}; // the window was resized, nobody said so
    const Image resized = gather(ahead, 1);
    for (std::size_t p = 3; p < resized.pixels.size(); p += 4) EXPECT_EQ(resized.pixels[p], 1.0f);
}

// Rest is counted for whoever filters what is gathered, too: it ends with whatever moves, the eye or a surface under a resting eye.
TEST_F(Antialias, CountsTheFramesSinceAnythingMoved)
{
    lamp(vec3(-1, -1, -3), vec3(2, 0, 0), vec3(0, 2, 0), 1.0f);
    const Camera camera = lookAt(vec3(0, 0, 1), vec3(0));
    for (uint i = 0; i < 3; ++i) {
        frame(camera);
        EXPECT_EQ(gathered.resting, i);
    }
    View view = makeView(camera, size);
    view.last = view.steady;
    EXPECT_EQ(restingFrames(view, level->scene, gathered), 3u);
    EXPECT_EQ(restingFrames(view, level->scene, {}), 0u) << "the first frame";
    level->scene.draws[0].moved = true;
    EXPECT_EQ(restingFrames(view, level->scene, gathered), 0u);
    level->scene.draws[0].moved = false;
    view.last = makeView(lookAt(vec3(0, 0, 2), vec3(0)), size).steady;
    EXPECT_EQ(restingFrames(view, level->scene, gathered), 0u);
}

// The eye goes sideways past bars at two distances. The last frame is nearer to the picture that a resting eye would see than a frame by
// itself, and where that picture is plain sky, two pixels from all else, there is no trace of what stood there before.
TEST_F(Antialias, FollowsAMovingEyeAndLeavesNoGhost)
{
    bars();
    size = {96, 64};
    const auto at = [](int step) {
        return lookAt(vec3(0.03f * float(step), 0.01f * float(step), 0), vec3(0.03f * float(step), 0.01f * float(step), -1));
    };
    Image moving;
    for (int step = 0; step <= 24; ++step) moving = frame(at(step)).gathered;
    const Image resting = afresh(at(24), 64), alone = afresh(at(24), 1);
    std::printf("| moving eye | %.4f | %.4f |\n", rmse(moving, resting), rmse(alone, resting));
    EXPECT_LT(rmse(moving, resting), rmse(alone, resting));
    int plain = 0;
    for (int y = 2; y < int(size.y) - 2; ++y)
        for (int x = 2; x < int(size.x) - 2; ++x) {
            bool sky = true;
            for (int j = -2; j <= 2; ++j)
                for (int i = -2; i <= 2; ++i) sky &= std::abs(*resting.at(x + i, y + j) - 0.2f) < 1e-4f;
            if (!sky) continue;
            ++plain;
            EXPECT_NEAR(*moving.at(x, y), 0.2f, 2e-3f) << x << ' ' << y;
        }
    EXPECT_GT(plain, 100);
}

// A board of stripes slides over the sky: its past follows it, and the sky that it leaves is clean at once.
TEST_F(Antialias, FollowsAMovingObject)
{
    size = {96, 64};
    scene.sky.radiance = vec3(0.2f);
    std::vector<uint> board;
    for (int i = 0; i < 8; ++i)
        board.push_back(lamp(vec3(-1.0f + 0.25f * float(i), -1, -5), vec3(0.25f, 0, 0), vec3(0, 2, 0), i % 2 ? 1.0f : 3.0f));
    const auto slid = [&](int step) {
        mat4 there(1.0f);
        there[3] = vec4(0.06f * float(step), 0.02f * float(step), 0.0f, 1.0f);
        for (const uint object : board) move(level->scene, object, there);
    };
    gather(ahead, 4);
    EXPECT_FALSE(ran("antialias.motion"));
    Image moving;
    for (int step = 1; step <= 12; ++step) {
        slid(step);
        moving = frame(ahead).gathered;
        EXPECT_TRUE(ran("antialias.motion"));
    }
    const Image resting = afresh(ahead, 64), alone = afresh(ahead, 1);
    EXPECT_FALSE(ran("antialias.motion")) << "it holds still again";
    std::printf("| moving object | %.4f | %.4f |\n", rmse(moving, resting), rmse(alone, resting));
    EXPECT_LT(rmse(moving, resting), rmse(alone, resting));
    const float* within = moving.at(55, 28); // on the board, whose past has come along
    EXPECT_GT(within[3], 0.9f * kMovingFrames);
    for (int y = 0; y < int(size.y); ++y)
        for (int x = 0; x < 34; ++x) EXPECT_NEAR(*moving.at(x, y), 0.2f, 2e-3f) << "where it began, " << x << ' ' << y;
}

// H78: a pixel that is not a number is black in the mean, and gone from it as the frames go on.
TEST_F(Antialias, KeepsNothingThatIsNotFinite)
{
    bars();
    size = {8, 8};
    level = std::make_unique<GpuLevel>(gpu, uploadScene(gpu, scene, placed(), {}), uploadBaked(gpu, baked, {}));
    const auto gathered4 = [&](vec4 value) {
        GpuImage picture = gpu.memory.image("picture", {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {size, 1}});
        const std::vector<vec4> texels(64, value);
        gpu.memory.upload(picture, texels.data(), texels.size() * sizeof(vec4));
        const View view = makeView(ahead, size);
        Graph graph;
        const GBuffer surfaces = geometry(graph, view, level->scene, {.emission = true});
        const Texture result = antialias(graph, view, surfaces, level->scene, graph.import(picture), {size}, gathered);
        graph.output(result);
        executor.run(graph, level->set);
        return executor.download(result);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Image first = gathered4(vec4(nan, INFINITY, -1.0f, 1.0f));
    EXPECT_EQ(first.pixels[0], 0.0f);
    EXPECT_EQ(first.pixels[1], kHalfMax);
    EXPECT_EQ(first.pixels[2], 0.0f);
    const Image second = gathered4(vec4(1.0f));
    EXPECT_EQ(second.pixels[0], 0.5f);
    EXPECT_EQ(second.pixels[2], 0.5f);
}
}
