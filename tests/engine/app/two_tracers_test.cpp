// Two tracers, one estimator: the CPU (Embree) and the GPU (ray query) draw the same random numbers for the same paths, so that their pictures
// agree pixel by pixel but where a path took another turn; there they agree within their noise (engine/effects/truth/README.md quotes the
// table).
#include "tests/engine/app/stated_truth.hpp"
#include "tests/engine/app/tracers.hpp"
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace afterglow
{
class TwoTracers : public Tracers
{
protected:
    // Of what the GPU found against the CPU, all relative to the CPU's mean.
    struct Agreement {
        double equal = 0; // share of pixels that are the same up to rounding
        double bias = 0;  // difference of the means, of the channel that is furthest out
        double error = 0; // its standard error, by the differences of the pixels
    };
    static Agreement agreement(const Image& gpu, const Image& cpu)
    {
        constexpr double kRounding = 1e-3; // of a pixel's value: paths of many vertices in fp32
        const double pixels = cpu.width * cpu.height;
        Agreement a;
        dvec3 sum(0.0), squares(0.0);
        double mean = 0.0;
        for (int y = 0; y < cpu.height; ++y)
            for (int x = 0; x < cpu.width; ++x) {
                const float *g = gpu.at(x, y), *e = cpu.at(x, y);
                const dvec3 expected(e[0], e[1], e[2]), d = dvec3(g[0], g[1], g[2]) - expected;
                EXPECT_TRUE(std::isfinite(d.x + d.y + d.z)) << x << ' ' << y;
                sum += d;
                squares += d * d;
                mean += (expected.x + expected.y + expected.z) / (3.0 * pixels);
                const dvec3 off = abs(d) - kRounding * expected;
                a.equal += std::max({off.x, off.y, off.z}) <= 1e-6 ? 1.0 / pixels : 0.0;
            }
        const double unit = mean > 0.0 ? mean : 1.0;
        for (int c = 0; c < 3; ++c) {
            const double bias = std::abs(sum[c]) / pixels / unit;
            const double variance = std::max(squares[c] / pixels - sum[c] * sum[c] / (pixels * pixels), 0.0);
            if (bias < a.bias) continue;
            a.bias = bias;
            a.error = std::sqrt(variance / (pixels - 1.0)) / unit;
        }
        return a;
    }

    static constexpr double kRounding = 1e-5; // of a mean: exp and pow of two compilers

    Agreement agreement(const std::string& name, const Scene& scene, uvec2 size, uint samples)
    {
        const TruthOptions picture = pictureOf(scene, "", ivec2(size), int(samples));
        const Agreement a = agreement(byRayQuery(scene, picture), byEmbree(scene, picture));
        std::printf("| %s | %ux%u, %u | %.1f %% | %.4f %% | %.4f %% |\n", name.c_str(), size.x, size.y, samples, 100.0 * a.equal,
                    100.0 * a.bias, 100.0 * a.error);
        return a;
    }

    void expectAgreement(const std::string& name, const Scene& scene, uvec2 size, uint samples)
    {
        const Agreement a = agreement(name, scene, size, samples);
        // A pixel is the same when all its paths are
        EXPECT_GT(std::pow(a.equal, 1.0 / samples), 0.97) << name;
        EXPECT_LT(a.bias, 3.0 * a.error + kRounding) << name;
    }
};

TEST_F(TwoTracers, AgreeOnEveryLevelWhoseAnswerIsKnown)
{
    for (const std::string& name : levelsOfKnownAnswer()) expectAgreement(name, loadLevel(kKnownAnswers / (name + ".glb")), {24, 24}, 4);
}

TEST_F(TwoTracers, AgreeOnRooms)
{
    for (const char* name : {"cornell/cornell", "two_rooms/two_rooms_open", "two_rooms/two_rooms_closed", "hanging_cube/hanging_cube",
                             "still_life/still_life"})
        expectAgreement(name, loadLevel(std::string("content/") + name + ".glb"), {32, 32}, 4);
}

TEST_F(TwoTracers, slowAgreeOnTexturedLevels)
{
    for (const char* name : {"gallery/gallery", "pool/pool"})
        expectAgreement(name, loadLevel(std::string("content/") + name + ".glb"), {48, 32}, 8);
}
}
