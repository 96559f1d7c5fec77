// The filter of what few rays leave: by itself, on penumbras and on contact whose closed forms are known.
#include "engine/effects/local_fit.h"
#include "shaders/penumbra.h"
#include "shaders/random.h"
#include "tests/engine/effects/lit_share.hpp"

namespace afterglow
{
namespace
{
// What a function of the place says of 5 x 5 pixels, against what it says of the middle one.
template <typename Value>
LocalFit fitOf(Value value)
{
    LocalFit fit = emptyFit();
    for (int y = -kFitReach; y <= kFitReach; ++y)
        for (int x = -kFitReach; x <= kFitReach; ++x) addTo(fit, fitWeight(x, y), vec2(x, y), vec4(value(x, y) - value(0, 0)));
    return fit;
}
}

// Whatever the noise is said to be.
TEST(LocalFit, KeepsPlanes)
{
    for (const float noise : {0.0f, 0.01f, 1.0f}) {
        EXPECT_EQ(fitted(fitOf([](int, int) { return 0.3f; }), vec4(noise), 1.0f), vec4(0.0f)) << noise;
        const vec4 tilted = fitted(fitOf([](int x, int y) { return 0.5f + 0.07f * float(x) - 0.04f * float(y); }), vec4(noise), 1.0f);
        EXPECT_NEAR(tilted.x, 0.0f, 1e-6f) << noise;
    }
}

TEST(LocalFit, LeavesEverythingWhereThereIsNoNoise)
{
    const auto lot = [](int x, int y) { return hashFloat(uint(31 * x + 7 * y + 400)); };
    EXPECT_EQ(fitted(fitOf(lot), vec4(0.0f), 1.0f), vec4(0.0f));
    const vec4 one = fitted(fitOf(lot), vec4(0.0f, 0.05f, 0.0f, 0.0f), 1.0f); // each value by its own noise
    EXPECT_EQ(one.x, 0.0f);
    EXPECT_NE(one.y, 0.0f);
}

// An edge of height 1 is no noise of a variance v: no more than v / (variance left by the edge) of what the plane says is believed. Beside
// the edge the columns weigh 1/2 1 | 1 1 1/2: the plane leaves at least 0.03 of the variance, and misses by no more than 1.
TEST(LocalFit, KeepsAnEdgeThatTheNoiseDoesNotExplain)
{
    for (const float noise : {1e-6f, 1e-4f, 1e-3f}) {
        const vec4 change = fitted(fitOf([](int x, int) { return x < 0 ? 0.0f : 1.0f; }), vec4(noise), 1.0f);
        EXPECT_LE(std::abs(change.x), noise / 0.03f) << noise;
    }
}

// One surface that shows a pixel, a row or a column alone; nothing at all.
TEST(LocalFit, IsFiniteWhateverTheNeighboursAre)
{
    EXPECT_EQ(fitted(emptyFit(), vec4(0.1f), 1.0f), vec4(0.0f));
    LocalFit alone = emptyFit(), row = emptyFit();
    addTo(alone, 1.0f, vec2(0.0f), vec4(0.0f));
    EXPECT_EQ(fitted(alone, vec4(0.1f), 1.0f), vec4(0.0f));
    for (int x = -2; x <= 2; ++x) addTo(row, 1.0f, vec2(x, 0), vec4(0.1f * float(x)));
    EXPECT_NEAR(fitted(row, vec4(0.1f), 1.0f).x, 0.0f, 1e-6f);
}

// On independent noise around a slope: the mean stays, and the deviation falls to 0.22 of itself at best, the root of the sum of the squared
// weights, 3.5 / 16 along each axis; 0.4 is asked, for what is left by lot is kept.
TEST(LocalFit, TakesNoiseAway)
{
    constexpr uint kTimes = 4000;
    constexpr float kHalf = 0.2f; // evenly within +-0.2: a variance of 0.2^2 / 3
    double sum = 0, square = 0;
    for (uint k = 0; k < kTimes; ++k) {
        const auto value = [k](int x, int y) {
            return 0.05f * float(x) + kHalf * (2.0f * hashFloat(hash3(k, uint(x + 9), uint(y + 9))) - 1.0f);
        };
        const double left = double(value(0, 0) + fitted(fitOf(value), vec4(kHalf * kHalf / 3.0f), 1.0f).x);
        sum += left, square += left * left;
    }
    const double deviation = std::sqrt(square / kTimes);
    EXPECT_LE(deviation, 0.4 * double(kHalf) / std::sqrt(3.0));
    EXPECT_NEAR(sum / kTimes, 0.0, 4.0 * deviation / std::sqrt(double(kTimes)));
}

// The more pictures are averaged, the less is left to the filter.
TEST(LocalFit, FadesAsFramesAreGathered)
{
    const LocalFit fit = fitOf([](int x, int y) { return hashFloat(uint(31 * x + 7 * y + 400)); });
    float last = kFloatMax;
    for (const float frames : {1.0f, 4.0f, 16.0f, 1e6f}) {
        const float change = std::abs(fitted(fit, vec4(0.02f), frames).x);
        EXPECT_LT(change, last);
        last = change;
    }
    EXPECT_LT(last, 1e-5f);
}

class DenoisedShadow : public LitShare
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }
    Image litShare(const Camera& camera, uint denoise, uint rays = 8)
    {
        ShadowParameters parameters = defaultShadowParameters();
        parameters.rays = rays;
        parameters.denoise = denoise;
        return litShareOf(camera, {.shadow = true, .shadowMethod = ShadowMethod::ray, .shadowParameters = parameters});
    }
    // An edge along z at x = 0, `height` m above the floor, under a sun of 4 degrees at the zenith.
    void edgeUnderASun(float height)
    {
        floor();
        addQuad(scene, vec3(-5, height, -5), vec3(0, 0, 10), vec3(5, 0, 0), grey());
        Light sun = sunLight(vec3(0, -1, 0), vec3(3.0f));
        sun.sinAngle = std::sin(2.0f * kPi / 180.0f);
        addLight(scene, sun);
        size = {64, 64};
    }
};

// shadow.penumbra_profile: the penumbra is 45 pixels wide. Pixels share a sequence, so that the picture's mean is one lot a frame.
TEST_F(DenoisedShadow, IsNearerToThePenumbraOfADiscBehindAnEdge)
{
    constexpr int kFrames = 8;
    edgeUnderASun(1.0f);
    const Camera camera = lookAt(vec3(0, 0.5f, 0), vec3(0), 0.2f);
    const float radius = std::tan(2.0f * kPi / 180.0f), half = 0.5f * std::tan(0.1f);
    const auto wanted = [&](int x) { return penumbra(((float(x) + 0.5f) / 32.0f - 1.0f) * half / radius); };
    const auto errors = [&](const Image& lit) { // mean, and mean square
        dvec2 sum(0.0);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const float share = lit.at(x, y)[0];
                EXPECT_TRUE(share >= 0.0f && share <= 1.0f + 1e-3f) << share;
                const double off = double(share - wanted(x));
                sum += dvec2(off, off * off);
            }
        return sum / 4096.0;
    };
    const double raw = std::sqrt(errors(litShare(camera, 0)).y);
    double square = 0, shift = 0, shifts = 0;
    for (frame = 0; frame < kFrames; ++frame) {
        const dvec2 e = errors(litShare(camera, 1)) / double(kFrames);
        shift += e.x, square += e.y, shifts += e.x * e.x * kFrames;
    }
    std::printf("penumbra of 45 px, 8 rays: RMSE %.4f, filtered %.4f, mean off by %.4f\n", raw, std::sqrt(square), shift);
    EXPECT_LE(std::sqrt(square), 0.6 * raw);
    EXPECT_NEAR(shift, 0.0, 4.0 * std::sqrt((shifts - shift * shift) / (kFrames - 1)) + 0.5 / 255.0);
}

// 2 cm above the floor the penumbra is narrower than a pixel: no pixel but those that hold it is other than light or dark.
TEST_F(DenoisedShadow, StaysSharpAtContact)
{
    edgeUnderASun(0.02f);
    const Image lit = litShare(lookAt(vec3(0, 1, 3), vec3(0), 0.4f), 1);
    for (int y = 0; y < 64; ++y) {
        int between = 0;
        for (int x = 0; x < 64; ++x) between += lit.at(x, y)[0] > 0.05f && lit.at(x, y)[0] < 0.95f;
        EXPECT_LE(between, 2) << y;
    }
}

// A board 3 cm under the edge and 2 beside it is lit, over a floor in the penumbra: it takes nothing of that.
TEST_F(DenoisedShadow, KeepsToASurface)
{
    edgeUnderASun(1.0f);
    addQuad(scene, vec3(0.02f, 0.97f, -0.01f), vec3(0, 0, 0.02f), vec3(0.01f, 0, 0), grey());
    const Camera camera = lookAt(vec3(0.02f, 1.5f, 0), vec3(0.02f, 0, 0), 0.05f);
    const Image lit = litShare(camera, 1);
    int board = 0, between = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const vec2 at = ((vec2(x, y) + 0.5f) / 32.0f - 1.0f) * (0.53f * std::tan(0.025f)); // on the board's plane, from the middle
            const bool on = at.x > 0.0f && at.x < 0.01f && std::abs(at.y) < 0.01f;
            const float share = lit.at(x, y)[0];
            board += on, between += !on && share > 0.05f && share < 0.95f;
            if (on) {
                EXPECT_GT(share, 0.999f) << x << ' ' << y;
            }
        }
    EXPECT_GT(board, 500);
    EXPECT_GT(between, 500);
}

// Bit by bit: rays to a point agree, and those that a veil dims alike.
TEST_F(DenoisedShadow, ChangesNothingWhereTheRaysAgree)
{
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, pointLight(vec3(0.3f, 4, 0.2f), vec3(30.0f)));
    size = {64, 64};
    const Camera camera = lookAt(vec3(0, 0.8f, 6), vec3(0), 0.9f);
    EXPECT_EQ(litShare(camera, 1).pixels, litShare(camera, 0).pixels);
}

class DenoisedContact : public Drawn
{
};

// ao.wall_range: a wall at a distance of t ranges hides 1 - penumbra(t). At the picture's own resolution, 8 rays; and a floor in the open stays 1.
TEST_F(DenoisedContact, IsNearerToTheWallsClosedForm)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    addQuad(scene, vec3(-50, 0, -50), vec3(0, 0, 100), vec3(100, 0, 0), addMaterial(scene, matte(vec3(0.64f))));
    addQuad(scene, vec3(0, 0, -50), vec3(0, 50, 0), vec3(0, 0, 100), 0);
    size = {64, 64};
    OcclusionParameters parameters = defaultOcclusionParameters();
    parameters.divisor = 1, parameters.smooth_ = 0;
    const Camera camera = lookAt(vec3(0.8f, 2, 0), vec3(0.8f, 0, 0), 0.38f); // 0.4 m to both sides: x from 0.4 to 1.2 m
    const float half = 2.0f * std::tan(0.19f);
    double error[2] = {};
    for (const uint denoise : {0u, 1u}) {
        parameters.denoise = denoise;
        const Image open = visibility(camera, OcclusionMethod::ray, parameters);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const float at = 0.8f + ((float(x) + 0.5f) / 32.0f - 1.0f) * half;
                if (at < 1.0f)
                    error[denoise] += std::pow(double(open.at(x, y)[0] - penumbra(at)), 2);
                else if (at > 1.1f) {
                    EXPECT_EQ(open.at(x, y)[0], 1.0f) << "out of reach";
                }
            }
    }
    std::printf("wall, 8 rays: squared error %.4f, filtered %.4f\n", error[0], error[1]);
    EXPECT_LE(error[1], 0.25 * error[0]);
}

// Twelve blocks and six slanted boards under a lamp of 25 cm, one of 5 cm, and the sun: wide and narrow penumbras, and contact.
class DenoisedBlocks : public DenoisedShadow
{
protected:
    static constexpr uint kTruth = 64, kFrames = 16; // the truth: rays, of the mean of so many frames
    static constexpr uint kLots = 4;                 // frames that are judged
    const Camera camera = lookAt(vec3(0, 3.5f, 5), vec3(0, 0.2f, 0));

    void block(vec3 lower, vec3 upper)
    {
        const vec3 s = upper - lower, x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
        addQuad(scene, lower + y, z, x, grey());
        addQuad(scene, lower, y, x, grey());
        addQuad(scene, lower + z, x, y, grey());
        addQuad(scene, lower, z, y, grey());
        addQuad(scene, lower + x, y, z, grey());
    }
    void blocks()
    {
        floor(8.0f);
        for (int i = 0; i < 12; ++i) {
            const float turn = 2.4f * float(i), away = 0.5f + 0.25f * float(i), high = 0.2f + 0.12f * float(i);
            const vec3 middle(away * std::cos(turn), high, away * std::sin(turn)), half(0.2f, high, 0.2f);
            block(middle - half, middle + half);
        }
        for (int i = 0; i < 6; ++i) addQuad(scene, vec3(i - 3, 1.5f, 0.3f * float(i) - 3), vec3(0, 0, 1.5f), vec3(0.3f, 0.1f, 0), grey());
        size = {400, 225};
    }
    // Root of the mean square of how far frames lie from `truth`; shown(frame) draws one.
    template <typename Shown>
    double errorOf(Shown shown, const Image& truth)
    {
        double sum = 0;
        for (uint k = 0; k < kLots; ++k) {
            const Image image = shown(k);
            for (std::size_t i = 0; i < truth.pixels.size(); ++i) sum += std::pow(double(image.pixels[i] - truth.pixels[i]), 2);
        }
        return std::sqrt(sum / (double(truth.pixels.size()) * kLots));
    }
    template <typename Shown>
    static Image meanOf(Shown shown)
    {
        Image mean = shown(1000u);
        for (uint k = 1; k < kFrames; ++k) {
            const Image image = shown(1000u + k);
            for (std::size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] += image.pixels[i];
        }
        for (float& value : mean.pixels) value /= float(kFrames);
        return mean;
    }
};

TEST_F(DenoisedBlocks, slowShadowsByTheNumberOfRays)
{
    blocks();
    Light large = pointLight(vec3(-2, 4, 2), vec3(50.0f)), small = pointLight(vec3(3, 3, -1), vec3(50.0f)),
          sun = sunLight(vec3(1, -1.5f, 0.3f), vec3(3.0f));
    large.radius = 0.25f, small.radius = 0.05f, sun.sinAngle = std::sin(0.265f * kPi / 180.0f);
    for (const auto& [name, light] : {std::pair("lamp of 25 cm", large), std::pair("lamp of 5 cm", small), std::pair("sun", sun)}) {
        GpuScene uploaded = uploadScene(gpu, scene, placed(), {light}, lods);
        uploaded.rays = buildRays(gpu, scene, placed());
        const GpuLevel level(gpu, std::move(uploaded), uploadBaked(gpu, baked, {}));
        const auto shares = [&](uint rays, uint denoise) {
            return [&, rays, denoise](uint frame) {
                View view = makeView(camera, size);
                view.frame = frame;
                ShadowParameters parameters = defaultShadowParameters();
                parameters.rays = rays, parameters.denoise = denoise;
                Graph graph;
                const Texture traced = tracedShadows(graph, view, geometry(graph, view, level.scene, {}), level.scene, parameters);
                graph.output(traced);
                executor.run(graph, level.set);
                Image all = executor.download(traced), one(all.width, all.height, 1);
                for (std::size_t i = 0; i < one.pixels.size(); ++i) one.pixels[i] = all.pixels[4 * i];
                return one;
            };
        };
        const Image truth = meanOf(shares(kTruth, 0));
        for (const uint rays : {4u, 8u, 16u, 32u}) {
            const double raw = errorOf(shares(rays, 0), truth), filtered = errorOf(shares(rays, 1), truth);
            std::printf("%s, %u rays: RMSE %.4f, filtered %.4f\n", name, rays, raw, filtered);
            if (rays <= defaultShadowParameters().rays) {
                EXPECT_LT(filtered, 1.05 * raw) << name << ", " << rays << " rays";
            } // a lot's worth
        }
    }
}

TEST_F(DenoisedBlocks, slowContactByTheNumberOfRays)
{
    blocks();
    GpuScene uploaded = uploadScene(gpu, scene, placed(), {}, lods);
    uploaded.rays = buildRays(gpu, scene, placed());
    const GpuLevel level(gpu, std::move(uploaded), uploadBaked(gpu, baked, {}));
    const GpuVoxels none;
    const auto open = [&](uint rays, uint divisor, uint smooth, uint denoise) {
        return [&, rays, divisor, smooth, denoise](uint frame) {
            View view = makeView(camera, size);
            view.frame = frame;
            OcclusionParameters parameters = defaultOcclusionParameters();
            parameters.rays = rays, parameters.divisor = divisor, parameters.smooth_ = smooth, parameters.denoise = denoise;
            Graph graph;
            const GBuffer surfaces = geometry(graph, view, level.scene, {});
            const Texture seen = occlusion(graph, view, surfaces, {none, level.scene.rays}, OcclusionMethod::ray, parameters);
            graph.output(seen);
            executor.run(graph, level.set);
            return executor.download(seen);
        };
    };
    const Image truth = meanOf(open(kTruth, 1, 0, 0));
    for (const uint rays : {2u, 4u, 8u, 16u}) {
        const double averaged = errorOf(open(rays, 2, 1, 0), truth), filtered = errorOf(open(rays, 2, 1, 1), truth);
        std::printf("contact, %u rays: RMSE %.4f averaged, %.4f filtered\n", rays, averaged, filtered);
        if (rays >= defaultOcclusionParameters().rays) {
            EXPECT_LT(filtered, averaged) << rays << " rays";
        }
    }
}
}
