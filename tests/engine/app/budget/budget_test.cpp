// The verbs that keep to a time; they need a device.
#include "engine/app/budget/budget.hpp"
#include "engine/app/cli.hpp"
#include "engine/core/file.hpp"
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace afterglow
{
namespace
{
using nlohmann::json;

struct Said {
    int code;
    std::string out, err;
};

class BudgetVerbs : public testing::Test
{
protected:
    BudgetVerbs()
    {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        setenv("XDG_CACHE_HOME", (folder / "cache").c_str(), 1);
    }
    ~BudgetVerbs() override
    {
        unsetenv("XDG_CACHE_HOME");
        std::filesystem::remove_all(folder);
    }

    Said ask(const std::vector<std::string>& words)
    {
        std::vector<const char*> all = {"afterglow"};
        for (const std::string& word : words) all.push_back(word.c_str());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        const int code = runCommandLine(int(all.size()), all.data());
        return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
    }

    json drawn(const std::string& milliseconds)
    {
        const std::vector<std::string> words = {"render",      "content/truth/sun_plane.glb",
                                                "-o",          (folder / "a.png").string(),
                                                "--size",      "48x36",
                                                "--stats",     stats(),
                                                "--budget-ms", milliseconds,
                                                "--effects",   "-shadow", // fewer options, soon measured
                                                "--progress",  "none"};
        const Said said = ask(words);
        EXPECT_EQ(said.code, 0) << said.err;
        return json::parse(readText(stats()));
    }

    std::string stats() const { return (folder / "stats.json").string(); }
    std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "budget_verbs" /
                                   testing::UnitTest::GetInstance()->current_test_info()->name(); // tests run side by side
};
}

TEST_F(BudgetVerbs, change_nothing_for_the_worse_where_there_is_time)
{
    const json budget = drawn("1e5")["budget"];
    EXPECT_TRUE(budget["fits"].get<bool>());
    EXPECT_EQ(budget["frames"], 20);
    EXPECT_LE(budget["frame_ms"].get<double>(), 0.9e5);
    EXPECT_EQ(budget["equal_time"]["render_scale"], 1.0) << "the default frame fits as it is";
    EXPECT_LE(budget["error"].get<double>(), budget["default"]["error"].get<double>()) << "time enough for what is better";
}

// Whatever a clock says, what is drawn is no farther from the truth than the default frame at the size that the same time allows.
TEST_F(BudgetVerbs, are_never_worse_than_the_default_frame_drawn_smaller)
{
    const double whole = drawn("1e5")["budget"]["default"]["ms"];
    for (const double share : {0.5, 0.9}) {
        const json budget = drawn(std::to_string(share * whole))["budget"];
        if (budget["fits"].get<bool>()) {
            EXPECT_LE(budget["frame_ms"].get<double>(), 0.9 * share * whole);
            EXPECT_LE(budget["error"].get<double>(), budget["equal_time"]["error"].get<double>()) << share;
        }
        EXPECT_LE(budget["equal_time"]["error"].get<double>(), 1.42) << "no relative error is larger than the root of two";
    }
}

TEST_F(BudgetVerbs, draw_what_harms_least_where_nothing_fits_and_remember_what_it_costs)
{
    const json none = drawn("0.001")["budget"];
    EXPECT_FALSE(none["fits"].get<bool>()) << "no frame takes a microsecond";
    EXPECT_GT(none["frame_ms"].get<double>(), 0.001);
    EXPECT_LE(none["frame_ms"].get<double>(), none["equal_time"]["ms"].get<double>()) << "at a quarter of the size, and less";
    EXPECT_EQ(none["equal_time"]["render_scale"], 0.25);
    EXPECT_EQ(none["unmeasured"], 0) << "so few options have their time";

    // A truth's two pictures and one list of prices, read again: nothing is measured anew
    const std::filesystem::path cache = folder / "cache" / "afterglow";
    const auto prices = [&] {
        for (const auto& entry : std::filesystem::directory_iterator(cache))
            if (entry.path().extension() == ".json") return entry.path();
        return cache;
    };
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(cache), {}), 3);
    const std::string kept = readText(prices());
    EXPECT_EQ(drawn("0.001")["budget"]["default"]["error"], none["default"]["error"]);
    EXPECT_EQ(readText(prices()), kept);

    // What an earlier run had no time for is measured by the next one, and what it had stays as it is
    json part = json::parse(kept);
    part["options"]["antialias"].erase("left out");
    part["options"]["lods"]["marked"] = {{"error", 7.0}, {"times", json::object()}, {"added", 0.0}};
    writeText(prices(), part.dump());
    drawn("0.001");
    const json whole = json::parse(readText(prices()));
    EXPECT_TRUE(whole["options"]["antialias"].contains("left out"));
    EXPECT_EQ(whole["options"]["lods"]["marked"]["error"], 7.0);

    // What is damaged is measured anew
    writeText(prices(), "{\"key\": 7");
    drawn("0.001");
    EXPECT_EQ(json::parse(readText(prices()))["options"].size(), json::parse(kept)["options"].size());
}

// A margin that is not kept is not a budget that is not kept.
TEST(BudgetWords, tell_the_margin_from_the_budget)
{
    const auto first = [](bool fits, double ms) {
        const Fitted fitted{.budgetMs = 60.0, .fits = fits, .ms = ms};
        return spoken(fitted).front();
    };
    EXPECT_TRUE(first(true, 53.0).ends_with("takes 53 ms, the median of 20: within 60 ms and its margin of 10 %"));
    EXPECT_TRUE(first(false, 59.7).ends_with("takes 59.7 ms, the median of 20: within 60 ms, but its margin of 10 % is not kept"));
    EXPECT_TRUE(first(false, 61.0).starts_with("nothing here fits 60 ms"));
    EXPECT_TRUE(first(false, 61.0).ends_with("takes 61 ms, the median of 20"));
}

TEST_F(BudgetVerbs, say_what_the_plan_gives_up)
{
    const std::vector<std::string> words = {
        "plan", "content/truth/sun_plane.glb", "--milliseconds", "0.001", "--effects", "-shadow", "--size", "32x24", "--progress", "none"};
    const Said said = ask(words);
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_NE(
        said.out.find("nothing here fits 0.001 ms that is not much worse than the plain frame at its smallest: a frame at rest takes "),
        std::string::npos)
        << said.out;
    EXPECT_NE(said.out.find("found in "), std::string::npos) << said.out;
    std::vector<std::string> asJson = words;
    asJson.push_back("--json");
    const json plan = json::parse(ask(asJson).out);
    std::set<std::string> off;
    for (const json& effect : plan["plan"])
        if (effect["reason"] == "given up for a frame of 0.001 ms") {
            EXPECT_FALSE(effect["on"].get<bool>());
            off.insert(effect["effect"].get<std::string>() + ": left out");
        }
    std::set<std::string> leftOut;
    for (const std::string what : plan["budget"]["gave_up"])
        if (what.ends_with(": left out")) leftOut.insert(what);
    EXPECT_EQ(off, leftOut);
}

// Said is said, if only what stands there anyway.
TEST_F(BudgetVerbs, leave_alone_what_the_command_line_says)
{
    ask({"plan", "content/truth/fog_sky.glb", "--milliseconds", "1e5", "--effects", "-shadow", "--size", "32x24", "--progress", "none"});
    const Said said = ask({"plan", "content/truth/fog_sky.glb", "--milliseconds", "0.001", "--effects", "-shadow", "--size", "32x24",
                           "--progress", "none", "--json", "--fog-steps", "16", "--render-scale", "1", "--lod-error", "0.25"});
    ASSERT_EQ(said.code, 0) << said.err;
    const json plan = json::parse(said.out);
    EXPECT_EQ(plan["budget"]["equal_time"]["render_scale"], 1.0);
    for (const std::string what : plan["budget"]["gave_up"])
        EXPECT_FALSE(what.starts_with("fog") || what.starts_with("upscale") || what.starts_with("lods")) << what;
    for (const json& effect : plan["plan"])
        if (effect["effect"] == "fog") {
            EXPECT_TRUE(effect["on"].get<bool>());
        }
}

TEST_F(BudgetVerbs, refuse_what_is_no_time)
{
    EXPECT_EQ(ask({"plan", "content/truth/furnace.glb", "--camera", "Nobody"}).code, 2) << "a camera of no frame";
    for (const char* word : {"0", "-3", "nan", "16ms"})
        EXPECT_EQ(ask({"plan", "content/truth/furnace.glb", "--milliseconds", word}).code, 2) << word;
    EXPECT_EQ(ask({"render", "content/truth/furnace.glb", "-o", stats() + ".png", "--mode", "truth", "--budget-ms", "16"}).code, 2);
}
}
