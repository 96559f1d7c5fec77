// What is proposed from prices, and what a search takes of the frames that it sees; prices and frames are made by hand.
#include "engine/app/budget/search.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
Option priced(const char* name, double ms, double error)
{
    return {.name = name, .choose = [](Settings&) {}, .price = {ms, error}};
}

// 20 ms and a squared error of 0.01. Half the size takes two fifths of the time and adds 0.005.
Curves handMade()
{
    Curves curves{.ms = 20.0, .error = 0.01};
    curves.groups = {{"fog", {{.name = "as it is"}, priced("few", -4.0, 0.001), priced("none", -6.0, 0.02)}},
                     {"bloom", {{.name = "as it is"}, priced("none", -2.0, 0.0001)}}};
    curves.scales = {{0.5, 0.4, 0.005}, {1.0, 1.0, 0.0}};
    return curves;
}

// The same that can only be drawn at its size.
Curves unscaled()
{
    Curves curves = handMade();
    curves.scales = {Scale{}};
    return curves;
}

using Options = std::vector<std::size_t>;

// Frames as the prices say, and the truth of what they are together.
struct Made {
    const Curves& curves;
    std::function<Price(const Choice&, Price)> really;
    std::vector<Choice> seen = {};

    Found search(double ms)
    {
        const auto look = [this](const Choice& choice) { return really(choice, predicted(curves, choice)); };
        return afterglow::search(curves, ms,
                                 {.error = [=](const Choice& c) { return look(c).error; },
                                  .ms =
                                      [=, this](const Choice& c) {
                                          seen.push_back(c);
                                          return look(c).ms;
                                      }});
    }
};
}

TEST(BudgetPrices, propose_the_least_error_for_the_time)
{
    const Curves curves = unscaled();
    EXPECT_EQ(propose(curves, 100.0).options, (Options{0, 0}));
    EXPECT_EQ(propose(curves, 18.0).options, (Options{0, 1})) << "bloom is the cheapest loss";
    EXPECT_EQ(propose(curves, 16.0).options, (Options{1, 0}));
    EXPECT_EQ(propose(curves, 14.0).options, (Options{1, 1}));
    EXPECT_EQ(propose(curves, 1.0).options, (Options{1, 1})) << "nothing fits: no fog is faster, and 1.25 times the error forbids it";
    EXPECT_EQ(propose(curves, 1.0).scale, 1.0);

    const Price price = predicted(handMade(), {{1, 1}, 0.5});
    EXPECT_NEAR(price.ms, (20.0 - 4.0 - 2.0) * 0.4, 1e-12);
    EXPECT_NEAR(price.error, 0.01 + 0.001 + 0.0001 + 0.005, 1e-12);
}

// Other work fell on the second frame that was looked at: its size is looked at again, and the time is filled.
TEST(BudgetSearch, climbs_back_from_a_frame_that_was_seen_too_slow)
{
    Curves curves{.ms = 40.0, .error = 0.01};
    curves.groups = {{"fog", {{.name = "as it is"}}}};
    curves.scales = {{0.25, 0.1, 0.1}, {0.5, 0.4, 0.005}, {1.0, 1.0, 0.0}};
    int looked = 0;
    Made made{curves, [&](const Choice&, Price price) { return price; }};
    made.really = [&](const Choice&, Price price) {
        ++looked; // once for the time, once for the error
        return looked <= 2 ? Price{2.5 * price.ms, price.error} : price;
    };
    const Found found = made.search(20.0);
    EXPECT_TRUE(found.best.fits);
    EXPECT_GT(found.best.seen.ms, 0.8 * 20.0);
}

TEST(BudgetPrices, fill_the_time_with_size)
{
    const Curves curves = handMade();
    // 0.4 + 0.6 t of 20 ms is 14: t = 1/2, so three quarters of the size
    EXPECT_NEAR(stretched(curves, plainChoice(curves), 14.0).scale, 0.75, 1e-9);
    EXPECT_NEAR(stretched(curves, plainChoice(curves), 1.0).scale, 0.5, 1e-9) << "the smallest";
    EXPECT_EQ(stretched(curves, plainChoice(curves), 1e3), plainChoice(curves)) << "and no larger than it is";
    for (double ms = 9.0; ms < 20.0; ms += 1.3) {
        const Choice choice = propose(curves, ms);
        EXPECT_LE(predicted(curves, choice).ms, ms);
        EXPECT_LE(predicted(curves, choice).error, predicted(curves, stretched(curves, plainChoice(curves), ms)).error) << ms;
        if (choice.scale < 1.0) {
            EXPECT_GT(predicted(curves, {choice.options, choice.scale + 0.01}).ms, ms) << "no time is left over";
        }
    }
}

TEST(BudgetSearch, takes_what_was_proposed_where_prices_told_right)
{
    const Curves curves = handMade();
    Made made{curves, [](const Choice&, Price said) { return said; }};
    const Found found = made.search(14.0);
    EXPECT_TRUE(found.best.fits && found.plain.fits);
    EXPECT_NEAR(found.plain.choice.scale, 0.75, 1e-9);
    EXPECT_EQ(found.best.choice, propose(curves, 14.0));
    EXPECT_LT(found.best.seen.error, found.plain.seen.error);
}

// Frames that take half as long again as said, or half of it: each proposal learns from the last.
TEST(BudgetSearch, learns_how_long_frames_take)
{
    const Curves curves = handMade();
    for (const double times : {1.5, 0.5}) {
        Made made{curves, [&](const Choice&, Price said) { return Price{said.ms * times, said.error}; }};
        const Found found = made.search(14.0);
        EXPECT_TRUE(found.best.fits && found.plain.fits);
        EXPECT_EQ(found.best.choice, propose(curves, 14.0 / times)) << times;
        EXPECT_EQ(found.plain.choice, stretched(curves, plainChoice(curves), 14.0 / times)) << times;
    }
}

// Two changes that are good alone and bad together: one of them is taken.
TEST(BudgetSearch, tries_one_by_one_what_does_not_go_together)
{
    const Curves curves = handMade();
    Made made{curves, [](const Choice& choice, Price said) { return choice.options == Options{1, 1} ? Price{said.ms, 1.0} : said; }};
    ASSERT_EQ(propose(curves, 14.0).options, (Options{1, 1}));
    const Found found = made.search(14.0);
    EXPECT_TRUE(found.best.fits);
    EXPECT_NE(found.best.choice.options, (Options{0, 0}));
    EXPECT_NE(found.best.choice.options, (Options{1, 1}));
    EXPECT_LT(found.best.seen.error, found.plain.seen.error);
}

// Half the size saves a twentieth of the time for 2.4 times the error: no frame fits, and the whole one is drawn.
TEST(BudgetSearch, keeps_the_size_where_it_hardly_costs_time)
{
    Curves curves = handMade();
    curves.scales = {{0.5, 0.95, 0.05}, {1.0, 1.0, 0.0}};
    Made made{curves, [](const Choice&, Price said) { return said; }};
    EXPECT_EQ(made.search(1.0).best.choice, plainChoice(curves));
    for (const double error : {0.05, 5.0}) {
        curves.scales[0] = {0.5, 0.2, error};
        EXPECT_EQ(made.search(1.0).best.choice.scale, 0.5) << "five times as fast, however exact the whole one is";
    }
}

// The frame at its smallest takes 8 ms and is off by 0.015: squares of 0.0234, 1.25 times the error, are the most that a faster one may
// have.
TEST(BudgetSearch, draws_no_ruin_where_nothing_fits)
{
    const Curves curves = handMade();
    const Options plain{0, 0}, few{1, 1};
    const auto found = [&](double ms, Price fewer) {
        Made made{curves, [=](const Choice& choice, Price said) {
                      return choice.options == few ? fewer : choice.options == plain ? said : Price{1.3 * said.ms, 0.5};
                  }};
        return made.search(ms).best;
    };
    EXPECT_EQ(found(1.0, {7.9, 0.3}).choice, (Choice{plain, 0.5})) << "hardly faster, and a ruin";
    EXPECT_EQ(found(1.0, {4.0, 0.3}).choice, (Choice{plain, 0.5})) << "twice as fast, and a ruin";
    EXPECT_EQ(found(1.0, {6.6, 0.0154}).choice, (Choice{plain, 0.5})) << "a little faster is not worth a worse picture";
    EXPECT_EQ(found(1.0, {6.0, 0.0230}).choice, (Choice{few, 0.5})) << "much faster, not much worse";
    EXPECT_EQ(found(1.0, {7.9, 0.0140}).choice, (Choice{few, 0.5})) << "faster and better";
    EXPECT_EQ(found(6.0, {6.6, 0.0154}).choice.options, few) << "6 ms with a margin of a tenth are 6.67 ms without";
    EXPECT_FALSE(found(6.0, {6.6, 0.0154}).fits);
}

// However wrong the prices are: what is taken fits and is no worse than the plain frame, or is that.
TEST(BudgetSearch, is_never_worse_than_the_plain_frame)
{
    const Curves curves = handMade();
    for (int seed = 0; seed < 200; ++seed) {
        const auto noise = [&](const Choice& choice, int salt) {
            const auto mixed = std::size_t(seed * 7919 + salt) + std::size_t(100.0 * choice.scale) * 104729 + choice.options[0] * 1299709 +
                               choice.options[1] * 15485863;
            return double(mixed * 2654435761u % 1000) / 1000.0;
        };
        Made made{curves, [&](const Choice& choice, Price said) {
                      return Price{said.ms * (0.5 + noise(choice, 1)), said.error * (0.5 + noise(choice, 2))};
                  }};
        const Found found = made.search(12.0);
        EXPECT_LE(made.seen.size(), std::size_t(kMostTrials)) << seed;
        EXPECT_EQ(found.best.fits, std::any_of(made.seen.begin(), made.seen.end(),
                                               [&](const Choice& c) { return made.really(c, predicted(curves, c)).ms <= 12.0; }))
            << seed;
        EXPECT_LE(found.best.seen.ms, found.best.fits ? 12.0 : found.plain.seen.ms) << seed;
        if (found.plain.fits) {
            EXPECT_LE(found.best.seen.error, found.plain.seen.error) << seed;
        }
    }
}
}
