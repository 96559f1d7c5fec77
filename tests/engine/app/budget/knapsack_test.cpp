// The best choice that fits, against every choice that there is.
#include "engine/app/budget/knapsack.hpp"
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace afterglow
{
using Groups = std::vector<std::vector<Price>>;

static Price sumOf(const Groups& groups, const std::vector<std::size_t>& choice)
{
    Price sum;
    for (std::size_t g = 0; g < groups.size(); ++g) sum.ms += groups[g][choice[g]].ms, sum.error += groups[g][choice[g]].error;
    return sum;
}

// The least error of all choices that fit; infinite when none does.
static double byBruteForce(const Groups& groups, double budget)
{
    double best = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> choice(groups.size(), 0);
    for (;;) {
        const Price sum = sumOf(groups, choice);
        if (sum.ms <= budget) best = std::min(best, sum.error);
        std::size_t g = 0;
        while (g < groups.size() && ++choice[g] == groups[g].size()) choice[g++] = 0;
        if (g == groups.size()) return best;
    }
}

TEST(Knapsack, takes_the_least_error_that_fits)
{
    // Whole halves, so that sums are exact: ties and exact fits happen
    std::mt19937 random(7);
    const auto halves = [&](int most) { return 0.5 * double(int(random() % unsigned(2 * most + 1)) - most); };
    int fits = 0, misfits = 0;
    for (int round = 0; round < 400; ++round) {
        Groups groups(1 + random() % 5);
        for (auto& group : groups)
            for (std::size_t i = 1 + random() % 5; i > 0; --i) group.push_back({halves(8), halves(6)});
        const double budget = halves(20), best = byBruteForce(groups, budget);
        const auto choice = chooseWithin(groups, budget);
        ASSERT_EQ(choice.has_value(), best < std::numeric_limits<double>::infinity()) << round;
        ++(choice ? fits : misfits);
        if (!choice) continue;
        EXPECT_LE(sumOf(groups, *choice).ms, budget) << round;
        EXPECT_EQ(sumOf(groups, *choice).error, best) << round;
    }
    EXPECT_GT(fits, 50);
    EXPECT_GT(misfits, 50);
}

TEST(Knapsack, takes_the_faster_of_equals_and_says_when_nothing_fits)
{
    const Groups groups = {{{3.0, 1.0}, {2.0, 1.0}, {1.0, 5.0}}, {{0.0, 0.0}, {-1.0, 2.0}}};
    EXPECT_EQ(chooseWithin(groups, 10.0), (std::vector<std::size_t>{1, 0}));
    EXPECT_EQ(chooseWithin(groups, 1.0), (std::vector<std::size_t>{1, 1})) << "1 + 2 is less than 5 + 0";
    EXPECT_EQ(chooseWithin(groups, 0.0), (std::vector<std::size_t>{2, 1}));
    EXPECT_FALSE(chooseWithin(groups, -0.5));
    EXPECT_EQ(chooseWithin({}, 0.0), std::vector<std::size_t>{});
}

// Twelve effects of six options are two thousand million choices.
TEST(Knapsack, is_quick_where_there_are_many)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    Groups groups(12);
    for (auto& group : groups)
        for (int i = 0; i < 6; ++i) group.push_back({share(random), share(random)});
    const auto choice = chooseWithin(groups, 5.0);
    ASSERT_TRUE(choice);
    EXPECT_LE(sumOf(groups, *choice).ms, 5.0);
    // No single exchange makes it better
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (std::size_t i = 0; i < 6; ++i) {
            auto other = *choice;
            other[g] = i;
            const Price sum = sumOf(groups, other);
            EXPECT_FALSE(sum.ms <= 5.0 && sum.error < sumOf(groups, *choice).error - 1e-12) << g << ' ' << i;
        }
}
}
