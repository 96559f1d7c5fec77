#include "engine/upload/split_sum.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
// Scale and bias of F0 by quadrature of the GGX lobe with height-correlated Smith shadowing, to six digits.
TEST(SplitSum, MeetsTheQuadrature)
{
    struct Row {
        float alpha, mu, scale, bias;
    };
    for (const Row row : {Row{0.25f, 0.9f, 0.90703634f, 0.000346750587f}, Row{0.5f, 0.5f, 0.6881007121f, 0.01014998478f},
                          Row{1.0f, 0.2f, 0.6276205049f, 0.01402760128f}}) {
        const shared::vec2 got = splitSum(row.mu, std::sqrt(row.alpha));
        EXPECT_NEAR(got.x, row.scale, 0.002f * row.scale + 0.001f) << "alpha " << row.alpha;
        EXPECT_NEAR(got.y, row.bias, 0.002f * row.bias + 0.001f) << "alpha " << row.alpha;
    }
}

// A mirror reflects F and nothing is shadowed: f0 + (1 - f0)(1 - mu)^5.
TEST(SplitSum, OfAMirrorIsFresnelAlone)
{
    for (const float mu : {0.05f, 0.3f, 0.7f, 1.0f}) {
        const shared::vec2 got = splitSum(mu, 0.0f);
        const float weight = std::pow(1.0f - mu, 5.0f);
        EXPECT_NEAR(got.x, 1.0f - weight, 2e-3f);
        EXPECT_NEAR(got.y, weight, 2e-3f);
    }
}

TEST(SplitSum, IsFiniteAndNeverAboveOne)
{
    for (int r = 0; r <= 16; ++r)
        for (int m = 0; m <= 16; ++m) {
            const shared::vec2 got = splitSum(float(m) / 16, float(r) / 16);
            EXPECT_TRUE(got.x >= 0.0f && got.y >= 0.0f && got.x + got.y <= 1.0001f) << m << ' ' << r;
        }
}
}
