// Slopes, floors and fronts, of rows whose answer is put in.
#include "engine/app/study/law.hpp"
#include "shaders/random.h"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
// factor value^slope over a floor, each off by up to `noise` of itself.
static std::vector<std::pair<double, double>> rowOf(double slope, double floor, double noise = 0.0)
{
    std::vector<std::pair<double, double>> row;
    for (int i = 0; i < 8; ++i) {
        shared::Sampler random = makeSampler(7u, uint(i));
        const double value = std::exp2(double(i)), off = 2.0 * double(next1(random)) - 1.0;
        row.emplace_back(value, std::hypot(floor, 0.3 * std::pow(value, slope)) * (1.0 + noise * off));
    }
    return row;
}

TEST(StudyLaw, finds_the_slope_of_a_power_law)
{
    for (double slope : {-2.0, -1.0, -0.5, 0.0, 2.0}) {
        const auto fit = fitLaw(rowOf(slope, 0.0));
        ASSERT_TRUE(fit);
        EXPECT_NEAR(fit->slope, slope, 0.01);
        EXPECT_NEAR(fit->factor, 0.3, 0.01);
        EXPECT_EQ(fit->floor, 0.0) << slope;
        EXPECT_DOUBLE_EQ(fit->range, 128.0);
    }
    EXPECT_NEAR(fitLaw(rowOf(-1.0, 0.0, 0.05))->slope, -1.0, 0.05); // 5 % of noise are no floor
    EXPECT_EQ(fitLaw(rowOf(-1.0, 0.0, 0.02))->floor, 0.0);
}

TEST(StudyLaw, finds_the_floor_that_a_row_ends_on)
{
    const auto fit = fitLaw(rowOf(-1.0, 0.02));
    ASSERT_TRUE(fit);
    EXPECT_NEAR(fit->slope, -1.0, 0.05);
    EXPECT_NEAR(fit->floor, 0.02, 0.002);
    const auto straight = fitLaw(rowOf(-1.0, 0.02), Floor::none); // where none may be, the line through all points
    ASSERT_TRUE(straight);
    EXPECT_EQ(straight->floor, 0.0);
    EXPECT_GT(straight->slope, -0.9);
}

TEST(StudyLaw, says_nothing_of_too_little)
{
    EXPECT_FALSE(fitLaw({}));
    EXPECT_FALSE(fitLaw({{1, 1}, {2, 0.5}}));
    EXPECT_FALSE(fitLaw({{1, 1}, {2, 0.0}, {4, 0.1}})) << "no logarithm";
    EXPECT_FALSE(fitLaw({{2, 1}, {2, 1}, {2, 1}})) << "no range";
}

TEST(StudyLaw, holds_only_over_a_range_and_within_its_slack)
{
    const Law law{-1.0, ""};
    const auto says = [&](double slope, double range) { return verdictOf(law, "steps", Fit{slope, 1.0, 0.0, range}); };
    EXPECT_TRUE(says(-0.9, 16.0).ends_with(": the law holds"));
    EXPECT_TRUE(says(-0.9, 8.0).ends_with("over a short range"));
    EXPECT_TRUE(says(-0.8, 64.0).ends_with("the law does not show here"));
    EXPECT_EQ(verdictOf({}, "steps", {}), "");
    const Law tree{0.3, "log n", /* most= */ true};
    EXPECT_EQ(verdictOf(tree, "n", Fit{0.2, 1.0, 0.0, 1000.0}),
              "expected below n^0.3, log n; measured n^0.2 over a factor of 1000: the law holds");
    EXPECT_TRUE(verdictOf(tree, "n", Fit{-0.5, 1.0, 0.0, 1000.0}).ends_with(": the law holds"));
    EXPECT_TRUE(verdictOf(tree, "n", Fit{0.31, 1.0, 0.0, 1000.0}).ends_with("the law does not show here"));
}

TEST(StudyLaw, marks_what_nothing_else_beats_in_both)
{
    std::vector<Point> points(6);
    const double ms[] = {1, 2, 2, 3, 4, 5}, error[] = {9, 5, 6, 5, 1, 2};
    const bool front[] = {true, true, false, false, true, false};
    std::vector<Point*> all;
    for (int i = 0; i < 6; ++i)
        points[std::size_t(i)].ms = ms[i], points[std::size_t(i)].error = error[i], all.push_back(&points[std::size_t(i)]);
    markPareto(all);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(points[std::size_t(i)].pareto, front[i]) << i;
}

// What cannot be told from none is as good as anything else that cannot.
TEST(StudyLaw, marks_nothing_for_an_error_below_the_noise)
{
    Point fast{.ms = 1.0, .error = 0.04, .noise = 0.05}, slow{.ms = 2.0, .error = 0.01, .noise = 0.05};
    markPareto({&fast, &slow});
    EXPECT_TRUE(fast.pareto);
    EXPECT_FALSE(slow.pareto);
}

TEST(StudyLaw, names_values_without_exponents)
{
    EXPECT_EQ(spokenValue(1024.0), "1024");
    EXPECT_EQ(spokenValue(0.0625), "0.0625");
    EXPECT_EQ(spokenValue(16.0), "16");
}

TEST(StudyLaw, quartiles_lie_between_the_values)
{
    EXPECT_DOUBLE_EQ(quartiles({5, 1, 4, 2, 3}).median, 3.0);
    EXPECT_DOUBLE_EQ(quartiles({5, 1, 4, 2, 3}).lower, 2.0);
    EXPECT_DOUBLE_EQ(quartiles({5, 1, 4, 2, 3}).spread, 2.0);
    EXPECT_DOUBLE_EQ(quartiles({7}).median, 7.0);
    EXPECT_DOUBLE_EQ(quartiles({7}).spread, 0.0);
    EXPECT_DOUBLE_EQ(quartiles({1, 2}).median, 1.5);
}
}
