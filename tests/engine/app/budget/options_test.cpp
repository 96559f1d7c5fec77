// What a frame may be drawn with instead, and what is left as it is.
#include "engine/app/budget/curves.hpp"
#include "engine/app/budget/options.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace afterglow
{
static Plan planOf(const std::vector<std::string>& on)
{
    Plan plan;
    for (const std::string& effect : on) plan.effects.push_back({effect, true, "because"});
    return plan;
}

static const Group* groupOf(const std::vector<Group>& groups, const std::string& effect)
{
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) { return group.effect == effect; });
    return found == groups.end() ? nullptr : &*found;
}

static std::vector<std::string> namesOf(const Group& group)
{
    std::vector<std::string> names;
    for (const Option& option : group.options) names.push_back(option.name);
    return names;
}

TEST(BudgetOptions, are_the_study_s_knobs_and_leaving_out)
{
    const std::vector<Group> groups =
        optionsFor(planOf({"geometry", "masked", "fog", "lightmaps", "toon", "bloom"}), {}, /* rayQuery= */ false);
    const Group* fog = groupOf(groups, "fog");
    ASSERT_TRUE(fog);
    EXPECT_EQ(namesOf(*fog), (std::vector<std::string>{"as it is", "steps 1 instead of 16", "steps 2 instead of 16",
                                                       "steps 4 instead of 16", "steps 8 instead of 16", "steps 32 instead of 16",
                                                       "steps 64 instead of 16", "divisor 2 instead of 4", "left out"}));
    Settings settings;
    fog->options[3].choose(settings);
    EXPECT_EQ(settings.fog.steps, 4u);
    EXPECT_EQ(settings.fog.divisor, FogParameters(defaultFogParameters()).divisor);
    fog->options.back().choose(settings);
    EXPECT_EQ(settings.effects.forced, (std::map<std::string, bool>{{"fog", false}}));
    EXPECT_FALSE(fog->options.front().choose);

    EXPECT_FALSE(groupOf(groups, "bloom")) << "no path says how much there is of it";
    EXPECT_FALSE(groupOf(groups, "upscale")) << "its share of the size is free";
    EXPECT_TRUE(fog->options[1].staged);
    EXPECT_FALSE(fog->options.back().staged) << "shaders without fog are others";
    EXPECT_EQ(fog->options[1].standing, 4) << "16 steps are the fifth of seven";
    EXPECT_EQ(fog->options[1].last, 6);
    EXPECT_FALSE(groupOf(groups, "reflection")) << "not drawn";
    EXPECT_FALSE(groupOf(groups, "toon")) << "a style is no shortcut";
    EXPECT_FALSE(groupOf(groups, "lightmaps")) << "they cost little to read";
    EXPECT_FALSE(groupOf(groups, "masked")) << "a leaf would be a square";
    EXPECT_FALSE(groupOf(groups, "geometry")) << "without it there is no picture";
}

TEST(BudgetOptions, leave_alone_what_the_command_line_says)
{
    const Plan plan = planOf({"fog", "occlusion"});
    Settings said;
    EXPECT_TRUE(groupOf(optionsFor(plan, said, false), "occlusion"));
    said.effects.forced["occlusion"] = true;
    EXPECT_FALSE(groupOf(optionsFor(plan, said, false), "occlusion"));
    EXPECT_TRUE(groupOf(optionsFor(plan, said, false), "fog"));
    EXPECT_TRUE(mayBeScaled(said));
    said.said = {{"--fog-steps", "fog"}, {"--render-scale", "upscale"}}; // if only to what it is anyway
    EXPECT_FALSE(groupOf(optionsFor(plan, said, false), "fog"));
    EXPECT_FALSE(mayBeScaled(said));
}

// A stage is made for a method: that of the default draws none of the others.
TEST(BudgetOptions, of_another_method_have_stages_of_their_own)
{
    const std::vector<Group> groups = optionsFor(planOf({"occlusion", "reflection"}), {}, true);
    for (const Option& option : groupOf(groups, "occlusion")->options) EXPECT_FALSE(option.staged) << option.name;
    for (const Option& option : groupOf(groups, "reflection")->options)
        EXPECT_EQ(option.staged, !option.knob.empty() && option.knob != "method") << option.name;
}

TEST(BudgetOptions, by_rays_are_for_devices_that_have_them)
{
    const Plan plan = planOf({"shadow"});
    const auto rays = [&](bool can) {
        const std::vector<std::string> names = namesOf(*groupOf(optionsFor(plan, {}, can), "shadow"));
        return std::count_if(names.begin(), names.end(), [](const std::string& name) { return name.starts_with("rays"); });
    };
    EXPECT_EQ(rays(false), 0);
    EXPECT_EQ(rays(true), 5) << "all of them: none is what is drawn without a word";
}

TEST(BudgetOptions, that_do_not_pay_are_dropped)
{
    const auto change = [](Settings&) {};
    const auto priced = [&](const char* name, double ms, double error) {
        return Option{.name = name, .choose = change, .price = {ms, error}};
    };
    Group group{"fog",
                {{.name = "as it is"},
                 priced("slow and bad", 2.0, 0.1),
                 priced("fast", -5.0, 0.3),
                 priced("faster and better", -6.0, 0.2),
                 priced("hardly faster", -0.004, 0.0),
                 priced("slow and good", 3.0, -0.2),
                 priced("slower, hardly better", 4.0, -0.2001)}};
    keepWhatPays(group, 10.0, 1.0);
    EXPECT_EQ(namesOf(group), (std::vector<std::string>{"as it is", "faster and better", "slow and good"}));

    Group beaten{"fog", {{.name = "as it is"}, priced("better in both", -1.0, -0.1)}};
    keepWhatPays(beaten, 10.0, 1.0);
    EXPECT_EQ(namesOf(beaten), (std::vector<std::string>{"as it is", "better in both"})) << "the default stays, whatever it is worth";
}
}
