// Which options are measured first, which need not be, and what the small picture's times say of the large one's.
#include "engine/app/budget/change.hpp"
#include "engine/app/budget/queue.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
Option valued(const char* name, int place, bool staged = true, int standing = 2)
{
    return {.name = name, .staged = staged, .knob = "steps", .place = place, .standing = standing, .last = 4};
}

Group steps(const char* effect)
{
    return {effect, {{.name = "as it is"}, valued("1", 0), valued("2", 1), valued("8", 3), valued("16", 4), {.name = "left out"}}};
}

PassTime pass(double ms, std::uint8_t told) { return {ms, {.told = {told}}}; }

Judged judgedBy(double error, std::map<std::string, PassTime> passes)
{
    Judged judged{.error = error};
    judged.look.passes = std::move(passes);
    for (const auto& [name, time] : judged.look.passes) judged.look.ms += time.ms;
    return judged;
}
}

TEST(BudgetQueue, begins_with_what_is_quick_and_promises_most)
{
    const std::vector<Group> groups = {steps("fog"), steps("reflection")};
    std::vector<std::string> order;
    for (const Place place : queueOf(groups, {{"fog", 0.1}, {"reflection", 0.3}}))
        order.push_back(groups[place.group].effect + " " + groups[place.group].options[place.option].name);
    // What no pipeline is compiled for, by the share of time that it can save; what costs more may pay, too. Last, what is made anew
    EXPECT_EQ(order, (std::vector<std::string>{"reflection 1", "reflection 2", "fog 1", "reflection 16", "fog 2", "reflection 8", "fog 16",
                                               "fog 8", "reflection left out", "fog left out"}));
}

TEST(BudgetQueue, passes_over_what_lies_between)
{
    const Group group = steps("fog");
    const Option &one = group.options[1], &two = group.options[2], &eight = group.options[3];
    EXPECT_FALSE(liesBetween(group, one, {{"", 1.0}}, 0.01)) << "nothing is beyond it";
    EXPECT_TRUE(liesBetween(group, two, {{"", 1.0}, {"1", 1.005}}, 0.01)) << "one step is as good as four";
    EXPECT_FALSE(liesBetween(group, two, {{"", 1.0}, {"1", 1.5}}, 0.01));
    EXPECT_FALSE(liesBetween(group, eight, {{"", 1.0}, {"1", 1.005}}, 0.01)) << "to the other side nothing is known";
    EXPECT_TRUE(liesBetween(group, eight, {{"", 1.0}, {"16", 1.005}}, 0.01));
    EXPECT_FALSE(liesBetween(group, group.options.back(), {{"", 1.0}, {"1", 1.0}}, 0.01)) << "left out is no value";

    // Of another method the default says nothing
    const Group other = {"fog", {{.name = "as it is"}, valued("1", 0, false, -1), valued("2", 1, false, -1), valued("16", 4, false, -1)}};
    EXPECT_FALSE(liesBetween(other, other.options[2], {{"", 1.0}, {"1", 1.0}}, 0.01));
    EXPECT_TRUE(liesBetween(other, other.options[2], {{"", 2.0}, {"1", 1.0}, {"16", 1.0}}, 0.01));
}

TEST(BudgetChange, counts_passes_that_are_declared_otherwise)
{
    const Judged standing = judgedBy(0.5, {{"fog", pass(4.0, 16)}, {"lighting", pass(5.0, 0)}, {"gone", pass(1.0, 0)}});
    const Judged changed = judgedBy(0.7, {{"fog", pass(1.0, 4)}, {"lighting", pass(9.0, 0)}, {"rays", pass(2.0, 0)}});
    const Change change = changeOf(standing, changed);
    EXPECT_EQ(change.error, 0.7);
    EXPECT_EQ(change.times, (std::map<std::string, double>{{"fog", 0.25}, {"gone", 0.0}}))
        << "lighting is as it was, whatever the clock says";
    EXPECT_DOUBLE_EQ(change.added, 0.2);

    // Six times the pixels: fog takes ten times as long and what is gone twice; of the new pass nothing is known but its pixels
    Look large;
    large.passes = {{"fog", pass(40.0, 16)}, {"lighting", pass(30.0, 0)}, {"gone", pass(2.0, 0)}};
    EXPECT_DOUBLE_EQ(addedMs(change, standing.look, large, 6.0), -0.75 * 40.0 - 2.0 + 2.0 * 6.0);
}
}
