// Proposals from prices, and the verbs that keep to a time; the verbs need a device.
#include "engine/app/budget/budget.hpp"
#include "engine/app/budget/propose.hpp"
#include "engine/app/cli.hpp"
#include "engine/core/file.hpp"
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

Option priced(const char* name, double ms, double error, double scale = 1.0)
{
    return {.name = name, .choose = [](Settings&) {}, .scale = scale, .price = {ms, error}};
}

// 20 ms and an error of 10 %; half the size takes 8 ms.
Curves handMade()
{
    Curves curves{.ms = 20.0, .error = 0.01};
    curves.groups = {{"fog", {{.name = "as it is"}, priced("few", -4.0, 0.001), priced("none", -6.0, 0.02)}},
                     {"bloom", {{.name = "as it is"}, priced("none", -2.0, 0.0001)}},
                     {"upscale", {{.name = "as it is"}, priced("half", -12.0, 0.005, 0.5)}}};
    return curves;
}

// Or had no time to find out what it could, or saw nothing that was faster: clocks scatter.
bool gaveUp(const json& budget)
{
    return !budget["gave_up"].empty() || budget["skipped"] > 0 || budget["frame_ms"] == budget["default"]["ms"];
}

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

TEST(Budget, proposes_the_least_error_for_the_time)
{
    const Curves curves = handMade();
    EXPECT_EQ(propose(curves, 100.0), (std::vector<std::size_t>{0, 0, 0}));
    EXPECT_EQ(propose(curves, 18.0), (std::vector<std::size_t>{0, 1, 0})) << "bloom is the cheapest loss";
    EXPECT_EQ(propose(curves, 16.0), (std::vector<std::size_t>{1, 0, 0}));
    EXPECT_EQ(propose(curves, 14.0), (std::vector<std::size_t>{1, 1, 0}));
    EXPECT_EQ(propose(curves, 13.0), (std::vector<std::size_t>{0, 0, 1})) << "8 ms: no fog costs more than half the size";
    EXPECT_EQ(propose(curves, 0.8 * 9.0), (std::vector<std::size_t>{0, 1, 1})) << "0.4 of (20 - 2) ms";
    EXPECT_EQ(propose(curves, 1.0), (std::vector<std::size_t>{2, 1, 1})) << "nothing fits: the fastest";

    const Price price = predicted(curves, {1, 1, 1});
    EXPECT_NEAR(price.ms, (20.0 - 4.0 - 2.0) * 8.0 / 20.0, 1e-12);
    EXPECT_NEAR(price.error, 0.01 + 0.001 + 0.0001 + 0.005, 1e-12);
}

TEST_F(BudgetVerbs, give_up_nothing_where_there_is_time)
{
    const json budget = drawn("1e5")["budget"];
    EXPECT_TRUE(budget["fits"].get<bool>());
    EXPECT_EQ(budget["frames"], 20);
    EXPECT_LE(budget["frame_ms"].get<double>(), 0.9e5);
    EXPECT_LE(budget["error"].get<double>(), budget["default"]["error"].get<double>()) << "time enough for what is better";
}

TEST_F(BudgetVerbs, give_up_what_they_must_and_remember_what_it_costs)
{
    const json none = drawn("0.001");
    EXPECT_FALSE(none["budget"]["fits"].get<bool>()) << "no frame takes a microsecond";
    EXPECT_TRUE(gaveUp(none["budget"]));
    const double fastest = none["budget"]["frame_ms"];
    EXPECT_GT(fastest, 0.0);

    // Three files, read again: what was measured is the same to the digit
    const std::filesystem::path cache = folder / "cache" / "afterglow";
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(cache), {}), 3);
    EXPECT_EQ(drawn("0.001")["budget"]["default"]["error"], none["budget"]["default"]["error"]);

    // Where four times the fastest is kept, it is seen to be
    const json some = drawn(std::to_string(4.0 * fastest))["budget"];
    if (some["fits"].get<bool>()) {
        EXPECT_LE(some["frame_ms"].get<double>(), 0.9 * 4.0 * fastest);
    }

    // What is damaged is measured anew
    for (const auto& entry : std::filesystem::directory_iterator(cache))
        if (entry.path().extension() == ".json") writeText(entry.path(), "{\"key\": 7");
    EXPECT_TRUE(gaveUp(drawn("0.001")["budget"]));
}

TEST_F(BudgetVerbs, say_what_the_plan_gives_up)
{
    const Said said = ask({"plan", "content/truth/sun_plane.glb", "--milliseconds", "0.001", "--effects", "-shadow", "--size", "32x24",
                           "--progress", "none"});
    ASSERT_EQ(said.code, 0) << said.err;
    EXPECT_NE(said.out.find("nothing here fits 0.001 ms with its margin of 10 %: the fastest frame is drawn, which takes "),
              std::string::npos)
        << said.out;
    const Said asJson = ask({"plan", "content/truth/sun_plane.glb", "--milliseconds", "0.001", "--effects", "-shadow", "--size", "32x24",
                             "--progress", "none", "--json"});
    const json plan = json::parse(asJson.out);
    for (const json& effect : plan["plan"])
        if (effect["reason"] == "given up for a frame of 0.001 ms") {
            EXPECT_FALSE(effect["on"].get<bool>());
        }
    EXPECT_TRUE(gaveUp(plan["budget"]));
}

TEST_F(BudgetVerbs, refuse_what_is_no_time)
{
    EXPECT_EQ(ask({"plan", "content/truth/furnace.glb", "--camera", "Nobody"}).code, 2) << "a camera of no frame";
    for (const char* word : {"0", "-3", "nan", "16ms"})
        EXPECT_EQ(ask({"plan", "content/truth/furnace.glb", "--milliseconds", word}).code, 2) << word;
    EXPECT_EQ(ask({"render", "content/truth/furnace.glb", "-o", stats() + ".png", "--mode", "truth", "--budget-ms", "16"}).code, 2);
}
}
