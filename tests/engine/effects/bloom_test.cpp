// Bloom keeps all light at any size, spreads a point as a Gaussian of the same variance, and survives what is not a number.
#include "engine/effects/bloom/bloom.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"
#include <cmath>
#include <cstdio>
#include <random>

namespace afterglow
{
using namespace shared;

namespace
{
using Row = std::vector<double>;

// One axis of a step, by the law of bloom.h over all pixels, not only over those that the shader visits.
Row stepDown(const Row& fine)
{
    const int n = int(fine.size()), m = (n + 1) / 2;
    Row coarse(std::size_t(m), 0.0);
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) coarse[std::size_t(j)] += double(bloomShare(i, j, n, m)) / n * fine[std::size_t(i)];
    return coarse;
}
Row stepUp(const Row& coarse, int n)
{
    const int m = int(coarse.size());
    Row fine(std::size_t(n), 0.0);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) fine[std::size_t(i)] += double(bloomShare(i, j, n, m)) / m * coarse[std::size_t(j)];
    return fine;
}

double sumOf(const Row& row)
{
    double sum = 0;
    for (const double value : row) sum += value;
    return sum;
}

// Down by `levels` and up again.
Row spread(Row row, int levels)
{
    std::vector<int> sizes;
    for (int l = 0; l < levels; ++l) {
        sizes.push_back(int(row.size()));
        row = stepDown(row);
    }
    for (int l = levels; l-- > 0;) row = stepUp(row, sizes[std::size_t(l)]);
    return row;
}
}

class Bloom : public Validated
{
protected:
    Image bloomed(const std::vector<vec4>& texels, uvec2 size, const BloomParameters& parameters)
    {
        GpuImage picture = gpu.memory.image("picture", {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {size, 1}});
        gpu.memory.upload(picture, texels.data(), texels.size() * sizeof(vec4));
        Executor executor(gpu);
        Graph graph;
        const Texture result = bloom(graph, graph.import(picture), parameters);
        graph.output(result);
        passes = executor.run(graph).passes.size();
        return executor.download(result);
    }
    static BloomParameters parameters(float strength, float share = 0.7f)
    {
        BloomParameters p = defaultBloomParameters();
        p.strength = strength, p.spread = share;
        return p;
    }
    std::size_t passes = 0;
};

// For every length of an axis: all light of a pixel arrives, even light stays even, and the shader's few taps are all that have a share.
TEST(BloomShare, OfRowsAndColumnsSumsToOne)
{
    for (int n = 1; n <= 67; ++n) {
        const int m = (n + 1) / 2;
        for (int i = 0; i < n; ++i) {
            double given = 0;
            for (int j = 0; j < m; ++j) {
                given += double(bloomShare(i, j, n, m));
                const int down = i - bloomFirstFine(j, n, m), up = j - bloomFirstCoarse(i, n, m);
                if (bloomShare(i, j, n, m) == 0.0f) continue;
                EXPECT_TRUE(down >= 0 && down < (n % 2 ? 5 : 4)) << n << ' ' << i << ' ' << j;
                EXPECT_TRUE(up >= 0 && up < (n % 2 ? 3 : 2)) << n << ' ' << i << ' ' << j;
            }
            EXPECT_DOUBLE_EQ(given, m);
        }
        for (int j = 0; j < m; ++j) {
            double taken = 0;
            for (int i = 0; i < n; ++i) taken += double(bloomShare(i, j, n, m));
            EXPECT_DOUBLE_EQ(taken, n);
        }
    }
}

// Each of the two filters of a step has a variance of 3/4 of its finer pixels: L levels have 2 * 3/4 * (1 + 4 + ... + 4^(L-1)) = (4^L - 1)
// / 2.
TEST(BloomShare, SpreadsAPointAsAGaussianOfTheSameVariance)
{
    std::printf("| levels | variance, px^2 | of the Gaussian | largest distance from it, of its peak |\n|---|---|---|---|\n");
    for (int levels = 1; levels <= 5; ++levels) {
        const int cell = 1 << levels, n = 64 * cell, radius = 8 * cell;
        Row mean(std::size_t(2 * radius + 1), 0.0);
        for (int phase = 0; phase < cell; ++phase) {
            Row row(std::size_t(n), 0.0);
            const int at = n / 2 + phase;
            row[std::size_t(at)] = 1.0;
            const Row result = spread(row, levels);
            EXPECT_NEAR(sumOf(result), 1.0, 1e-6);
            for (int d = -radius; d <= radius; ++d) mean[std::size_t(d + radius)] += result[std::size_t(at + d)] / cell;
        }
        const double wanted = (std::pow(4.0, levels) - 1.0) / 2.0;
        double variance = 0, furthest = 0;
        for (int d = -radius; d <= radius; ++d) variance += double(d) * d * mean[std::size_t(d + radius)];
        for (int d = -radius; d <= radius; ++d) {
            // The Gaussian's share of the pixel
            const double edge = std::sqrt(2.0 * wanted);
            const double share = 0.5 * (std::erf((d + 0.5) / edge) - std::erf((d - 0.5) / edge));
            furthest = std::max(furthest, std::abs(mean[std::size_t(d + radius)] - share) / std::erf(0.5 / edge));
        }
        std::printf("| %d | %.3f | %.3f | %.1f %% |\n", levels, variance, wanted, 100.0 * furthest);
        EXPECT_NEAR(variance, wanted, 1e-3 * wanted);
        EXPECT_LT(furthest, 0.06);
    }
}

// H72, H77: random light with every bad pixel in it, at odd and tiny sizes.
TEST_F(Bloom, KeepsAllLightAtAnySize)
{
    std::printf("| size | light after / before |\n|---|---|\n");
    for (const uvec2 size : {uvec2(1, 1), uvec2(1, 97), uvec2(33, 1), uvec2(37, 23), uvec2(64, 48), uvec2(101, 66)}) {
        std::mt19937 random(7);
        std::exponential_distribution<float> light(1.0f);
        std::vector<vec4> texels;
        for (uint i = 0; i < size.x * size.y; ++i) texels.push_back(vec4(light(random), light(random), light(random), 1.0f));
        const float bad[] = {kHalfMax, 1e8f, INFINITY, std::numeric_limits<float>::quiet_NaN(), -1.0f};
        for (std::size_t i = 0; i < 5 && texels.size() > 8; ++i) texels[i * texels.size() / 5] = vec4(bad[i], bad[i], bad[i], 1.0f);
        texels.back() = vec4(2000.0f, 3.0f, 1.0f, 1.0f);
        const Image result = bloomed(texels, size, parameters(0.5f));
        dvec3 before(0.0), after(0.0);
        for (std::size_t i = 0; i < texels.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                before[c] += double(displayInput(texels[i][c]));
                after[c] += double(result.pixels[i * 4 + std::size_t(c)]);
                ASSERT_TRUE(std::isfinite(result.pixels[i * 4 + std::size_t(c)]));
            }
        std::printf("| %ux%u | %.6f |\n", size.x, size.y, (after.x + after.y + after.z) / (before.x + before.y + before.z));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(after[c] / before[c], 1.0, 1e-3) << size.x << 'x' << size.y;
    }
}

TEST_F(Bloom, LeavesEvenLightEven)
{
    for (const uvec2 size : {uvec2(1, 1), uvec2(5, 64), uvec2(37, 23)}) {
        const Image result =
            bloomed(std::vector<vec4>(std::size_t(size.x) * size.y, vec4(0.25f, 3.0f, 900.0f, 1.0f)), size, parameters(1.0f));
        for (std::size_t i = 0; i < result.pixels.size(); i += 4) {
            EXPECT_NEAR(result.pixels[i], 0.25f, 1e-6f);
            EXPECT_NEAR(result.pixels[i + 2], 900.0f, 1e-3f);
        }
    }
}

// The shaders do what the law says: a point in pictures of odd and even sizes, in their middle and in a corner, spread by the product of
// the two axes.
TEST_F(Bloom, SpreadsAPointByTheLaw)
{
    for (const uvec2 size : {uvec2(37, 64), uvec2(40, 64)})
        for (const uvec2 at : {uvec2(17, 30), uvec2(0, 63)}) {
            std::vector<vec4> texels(std::size_t(size.x) * size.y, vec4(0.0f));
            texels[at.y * size.x + at.x] = vec4(1000.0f);
            const Image result = bloomed(texels, size, parameters(1.0f, 1.0f)); // 64 -> 32 -> 16: two levels, nothing stays on the way
            EXPECT_EQ(passes, 4u);
            Row x(size.x, 0.0), y(size.y, 0.0);
            x[at.x] = y[at.y] = 1.0;
            x = spread(x, 2), y = spread(y, 2);
            for (uint j = 0; j < size.y; ++j)
                for (uint i = 0; i < size.x; ++i)
                    EXPECT_NEAR(double(*result.at(int(i), int(j))), 1000.0 * x[i] * y[j], 1e-3) << i << ' ' << j;
        }
}

TEST_F(Bloom, OfStrengthZeroRunsAndChangesNothing)
{
    std::vector<vec4> texels;
    for (int i = 0; i < 35 * 21; ++i) texels.push_back(vec4(float(i), 0.5f * float(i % 7), 60000.0f, 1.0f));
    const Image result = bloomed(texels, {35, 21}, parameters(0.0f));
    EXPECT_GE(passes, 4u);
    for (std::size_t i = 0; i < texels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) EXPECT_EQ(result.pixels[i * 4 + c], texels[i][int(c)]);
}
}
