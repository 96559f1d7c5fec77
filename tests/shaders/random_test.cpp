// The sampler: in [0, 1), evenly spread in every pair, pairs apart from each other, and faster than chance to converge.
#include "shaders/random.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>
#include <set>

namespace afterglow::test
{
TEST(Random, FloatsStayBelowOne)
{
    EXPECT_EQ(unitFloat(0u), 0.0f);
    EXPECT_LT(unitFloat(0xffffffffu), 1.0f);
    EXPECT_EQ(unitFloat(0xffffffffu), 1.0f - 1.0f / 16777216.0f);
}

TEST(Random, HashesAreUniform)
{
    std::vector<double> counts(256, 0.0), expected(256, 100000.0 / 256);
    for (uint i = 0; i < 100000; ++i) counts[std::size_t(hashFloat(i) * 256.0f)] += 1.0;
    EXPECT_LT(chiSquare(counts, expected), 4.0);
    std::set<uint> distinct;
    for (uint x = 0; x < 100; ++x)
        for (uint y = 0; y < 100; ++y) distinct.insert(hash2(x, y));
    EXPECT_GT(distinct.size(), 9995u);
}

// Any 2^k first points, in any pair of any stream, meet every elementary interval of area 2^-k exactly once: a (0,2)-sequence.
TEST(Sampler, EveryPairIsStratified)
{
    for (uint seed : {1u, 77u, 123456u})
        for (int pair : {0, 1, 5, 40}) {
            std::vector<vec2> points;
            for (uint i = 0; i < 64; ++i) {
                Sampler s = makeSampler(seed, i);
                vec2 p(0.0f);
                for (int d = 0; d <= pair; ++d) p = next2(s);
                points.push_back(p);
            }
            for (int bits = 0; bits <= 6; ++bits) {
                std::set<int> cells;
                for (vec2 p : points) cells.insert((int(p.x * float(1 << bits)) << (6 - bits)) + int(p.y * float(1 << (6 - bits))));
                EXPECT_EQ(cells.size(), 64u) << "seed " << seed << " pair " << pair << " split " << bits;
            }
        }
}

TEST(Sampler, SingleNumbersAreStratified)
{
    std::set<int> cells;
    for (uint i = 0; i < 256; ++i) {
        Sampler s = makeSampler(9u, i);
        next2(s);
        cells.insert(int(next1(s) * 256.0f));
    }
    EXPECT_EQ(cells.size(), 256u);
}

TEST(Sampler, KnowsTheSampleThatItIsOf)
{
    for (uint index : {0u, 1u, 77u, 0x80000000u, 0xffffffffu}) {
        Sampler s = makeSampler(9u, index);
        next2(s);
        EXPECT_EQ(sampleIndexOf(s), index);
    }
}

// Mean over streams of a point's first coordinate is uniform, and two pairs of one stream know nothing of each other.
TEST(Sampler, PairsAndStreamsAreIndependent)
{
    const int n = 16;
    std::vector<double> across(n * n, 0.0), streams(n * n, 0.0), expected(n * n, 65536.0 / (n * n));
    for (uint i = 0; i < 65536; ++i) {
        Sampler s = makeSampler(i, 3u); // one sample each of many streams
        vec2 a = next2(s);
        float b = next1(s);
        vec2 c = next2(s);
        across[std::size_t(int(a.x * n) * n + int(c.y * n))] += 1.0;
        streams[std::size_t(int(b * n) * n + int(c.x * n))] += 1.0;
    }
    EXPECT_LT(chiSquare(across, expected), 4.0);
    EXPECT_LT(chiSquare(streams, expected), 4.0);
    // Within one stream: the correlation of the pairs over the first 1024 samples is that of chance
    Mean product;
    for (uint i = 0; i < 1024; ++i) {
        Sampler s = makeSampler(5u, i);
        vec2 a = next2(s), b = next2(s);
        product.add(double((a.x - 0.5f) * (b.x - 0.5f)));
    }
    EXPECT_NEAR(product.value(), 0.0, 4.0 * product.error());
}

// Dimension after dimension of one stream is a fair coin: in a furnace of emission 1 and albedo rho a path that ends with 1 - rho sums to
// 1 / (1 - rho), with variance rho / (1 - rho)^2.
TEST(Sampler, CarriesPathsOfAnyDepth)
{
    const float rho = 0.5f;
    Mean path;
    for (uint i = 0; i < 65536; ++i) {
        Sampler s = makeSampler(31u, i);
        double sum = 1.0;
        while (next1(s) < rho) sum += 1.0;
        path.add(sum);
    }
    EXPECT_NEAR(path.value(), 2.0, 4.0 * path.error());
    expectRelative(path.variance(), 2.0, 0.05);
}

// RMSE of a smooth integral over scramblings falls faster than N^-1: from 64 to 1024 points by more than 16.
TEST(Sampler, ConvergesFasterThanChance)
{
    auto rmse = [](uint count) {
        double squares = 0.0;
        for (uint seed = 0; seed < 64; ++seed) {
            double sum = 0.0;
            for (uint i = 0; i < count; ++i) {
                Sampler s = makeSampler(seed, i);
                next2(s);
                vec2 p = next2(s);
                sum += std::exp(double(p.x)) * std::sin(3.0 * double(p.y));
            }
            double truth = (M_E - 1.0) * (1.0 - std::cos(3.0)) / 3.0;
            squares += std::pow(sum / count - truth, 2.0);
        }
        return std::sqrt(squares / 64.0);
    };
    EXPECT_GT(rmse(64) / rmse(1024), 16.0);
}
}
