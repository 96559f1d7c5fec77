// Both path tracers against the levels that carry their own answer.
// Closed forms, by their names: scene.furnace, scene.sphere_point_light, scene.parallel_plates, scene.mirror_corridor, scene.slab_glass; by
// levels whose names begin with fog_: medium.transmittance, medium.height_fog, medium.airlight_directional, medium.airlight_point,
// medium.slab_single, medium.slab_multiple, medium.H, medium.furnace.
#include "tests/engine/app/stated_truth.hpp"
#include "tests/engine/app/tracers.hpp"
#include <cstdio>
#include <gtest/gtest.h>

namespace afterglow
{
using nlohmann::json;

namespace
{
constexpr int kWidth = 16;             // px, and down
constexpr int kLonger = 16;            // times as many paths at the most, where they tell too little
constexpr double kTelling = 0.01;      // relative standard error that is asked for
constexpr double kLeastTelling = 0.05; // an estimate of a larger one says nothing

// Of a picture's pixels, or of one point's paths.
struct Estimate {
    dvec3 value, error; // standard error
};
Estimate meanOf(const Image& image)
{
    constexpr double kPixels = kWidth * kWidth;
    dvec3 sum(0.0), squares(0.0);
    for (int y = 0; y < kWidth; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const float* p = image.at(x, y);
            const dvec3 pixel(p[0], p[1], p[2]);
            sum += pixel;
            squares += pixel * pixel;
        }
    const dvec3 mean = sum / kPixels;
    return {mean, sqrt(max(squares / kPixels - mean * mean, dvec3(0.0)) / (kPixels - 1.0))};
}

vec3 vectorOf(const json& row, const char* key) { return {row[key][0], row[key][1], row[key][2]}; }

// estimate(paths), with more of them until they tell enough.
template <class Work>
Estimate telling(const json& row, int paths, int most, Work estimate)
{
    for (;; paths *= 4) {
        const Estimate found = estimate(paths);
        bool enough = true;
        for (int c = 0; c < 3; ++c) enough &= found.error[c] <= kTelling * row["value"][std::size_t(c)].get<double>();
        if (enough || 4 * paths > most) return found;
    }
}

// Four standard errors of the estimate, and what the level itself says of its own accuracy.
void expectMet(const char* tracer, const std::string& level, const json& row, const Estimate& found)
{
    for (int c = 0; c < 3; ++c) {
        const double value = row["value"][std::size_t(c)];
        EXPECT_NEAR(found.value[c], value, row["relative_tolerance"].get<double>() * value + 4.0 * found.error[c])
            << tracer << ", channel " << c << ", standard error " << found.error[c] << ": " << row["derivation"];
        EXPECT_LE(found.error[c], kLeastTelling * value) << tracer << ", channel " << c;
    }
    const double value = row["value"][1];
    std::printf("| %s | %s | %s | %.7g | %.7g | %+.2f |\n", level.c_str(), row.value("camera", "a point").c_str(), tracer, value,
                found.value[1], found.error[1] > 0.0 ? (found.value[1] - value) / found.error[1] : 0.0);
}
}

class StatedTruth : public Tracers, public testing::WithParamInterface<std::string>
{
protected:
    void SetUp() override {} // the CPU's answers need no device

    void expectEveryAnswer(int samples, int most)
    {
        const Scene scene = loadLevel(kKnownAnswers / (GetParam() + ".glb"));
        for (const json& row : statedTruth(GetParam())) {
            if (row["quantity"] == "irradiance") {
                const ProbePoint point{dvec3(vectorOf(row, "position")), vectorOf(row, "normal")};
                expectMet("CPU", GetParam(), row, telling(row, samples, most, [&](int paths) {
                              Progress silent(ProgressStyle::none);
                              const PointIrradiance found = probeTruth(scene, {point}, 256 * paths, 3, 0, silent)[0];
                              return Estimate{dvec3(found.value[0]), dvec3(found.error[0])};
                          }));
                continue;
            }
            TruthOptions asked = pictureOf(scene, row["camera"], ivec2(kWidth), samples);
            asked.bounces = row.value("bounces", asked.bounces);
            if (row.contains("scatterings")) asked.scatterings = row["scatterings"].get<int>();
            const auto by = [&](auto trace) {
                return telling(row, samples, most, [&](int paths) {
                    asked.samples = paths;
                    return meanOf(trace());
                });
            };
            expectMet("CPU", GetParam(), row, by([&] { return byEmbree(scene, asked); }));
            asked.seed = 2; // other paths: of one seed both tracers' are the same (two_tracers_test.cpp)
            if (canTrace(gpu.device, Tracing::automatic)) expectMet("GPU", GetParam(), row, by([&] { return onGpu(scene, asked); }));
        }
    }
};

TEST_P(StatedTruth, IsMetByBothTracers) { expectEveryAnswer(64, 64 * kLonger); }

// Air in which few paths collide, or few where it counts: it takes many.
class RareTruth : public StatedTruth
{
};
TEST_P(RareTruth, slowIsMetByBothTracers)
{
    const int paths = GetParam() == "fog_lamp_thin" ? 1 << 18 : 1 << 12;
    expectEveryAnswer(paths, paths);
}

static const std::vector<std::string> kRare = {"fog_lamp_near", "fog_lamp_thin"};
static std::vector<std::string> levels()
{
    std::vector<std::string> names = levelsOfKnownAnswer();
    std::erase_if(names, [](const std::string& name) { return std::count(kRare.begin(), kRare.end(), name) > 0; });
    return names;
}
static const auto kByLevel = [](const auto& info) { return info.param; };
INSTANTIATE_TEST_SUITE_P(Levels, StatedTruth, testing::ValuesIn(levels()), kByLevel);
INSTANTIATE_TEST_SUITE_P(Levels, RareTruth, testing::ValuesIn(kRare), kByLevel);
}
