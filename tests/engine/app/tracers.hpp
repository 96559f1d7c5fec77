// All tracers on one level, asked for the same picture: the CPU's (Embree), and the GPU's, however it is organised.
#pragma once
#include "baker/baker.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace afterglow
{
class Tracers : public Validated
{
protected:
    uint perFrame = 4096u; // paths of a pixel at the most: a device may end what takes it longer than seconds

    void SetUp() override
    {
        if (!canTrace(gpu.device, Tracing::automatic)) GTEST_SKIP() << gpu.device.deviceName << " traces no rays";
    }

    // Of few pixels and many paths, where a wavefront would have a step for each vertex of each path. Organisations compares them on fewer.
    Image onGpu(const Scene& scene, const TruthOptions& asked)
    {
        return onGpu(scene, asked, gpu.device.rayQuery ? Tracing::kernel : Tracing::pipeline);
    }

    Image onGpu(const Scene& scene, const TruthOptions& asked, Tracing tracing)
    {
        Settings settings;
        settings.size = uvec2(asked.size);
        settings.mode = Mode::truth;
        settings.tracing = tracing;
        settings.portal.depth = uint(asked.portalDepth);
        TruthParameters& truth = settings.truth;
        truth.samples = uint(asked.samples);
        truth.perFrame = min(truth.samples, perFrame);
        truth.seed = asked.seed;
        truth.bounces = uint(asked.bounces);
        if (asked.scatterings) truth.scatterings = uint(*asked.scatterings);
        Stage stage = makeStage(gpu, scene, nullptr, settings);
        Executor executor(gpu);
        Texture radiance;
        while (stage.traced.count < truth.samples) {
            Graph graph;
            radiance = drawTruth(graph, stage, asked.camera, settings).radiance;
            graph.output(radiance);
            executor.run(graph, stage.level->set);
        }
        return executor.download(radiance);
    }

    static Image byEmbree(const Scene& scene, const TruthOptions& asked)
    {
        Progress silent(ProgressStyle::none);
        return truth(scene, asked, silent);
    }

    // Of a picture against that which another tracer made of the same random numbers, all relative to the other's mean.
    struct Agreement {
        double equal = 0; // share of pixels that are the same up to rounding
        double bias = 0;  // difference of the means, of the channel that is furthest out
        double error = 0; // its standard error, by the differences of the pixels
    };
    static Agreement agreement(const Image& found, const Image& wanted)
    {
        constexpr double kRounding = 1e-3; // of a pixel's value: paths of many vertices in fp32
        const double pixels = wanted.width * wanted.height;
        Agreement a;
        dvec3 sum(0.0), squares(0.0);
        double mean = 0.0;
        for (int y = 0; y < wanted.height; ++y)
            for (int x = 0; x < wanted.width; ++x) {
                const float *f = found.at(x, y), *e = wanted.at(x, y);
                const dvec3 expected(e[0], e[1], e[2]), d = dvec3(f[0], f[1], f[2]) - expected;
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

    // Prints a row for engine/effects/truth/README.md. `floor`: the share of paths that must be the same at the least.
    static void expectAgreement(const std::string& name, const TruthOptions& picture, const Image& found, const Image& wanted, double floor)
    {
        constexpr double kMeanRounding = 1e-5; // exp and pow of two compilers
        const Agreement a = agreement(found, wanted);
        std::printf("| %s | %dx%d, %d | %.1f %% | %.4f %% | %.4f %% |\n", name.c_str(), picture.size.x, picture.size.y, picture.samples,
                    100.0 * a.equal, 100.0 * a.bias, 100.0 * a.error);
        // A pixel is the same when all its paths are
        EXPECT_GT(std::pow(a.equal, 1.0 / picture.samples), floor) << name;
        EXPECT_LT(a.bias, 3.0 * a.error + kMeanRounding) << name;
    }
};

inline TruthOptions pictureOf(const Scene& scene, const std::string& camera, ivec2 size, int samples)
{
    TruthOptions options;
    options.camera = findCamera(scene, camera);
    options.size = size;
    options.samples = samples;
    return options;
}
}
