// The remaining time of invented commands, whose end is known.
#include "engine/core/forecast.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
// A command whose stages take so many times what was reckoned.
struct History {
    std::vector<StageForecast> stages;
    std::vector<double> slowness;

    double seconds(std::size_t i) const { return stages[i].units * stages[i].cost * slowness[i]; }
    double all() const
    {
        double sum = 0.0;
        for (std::size_t i = 0; i < stages.size(); i++) sum += seconds(i);
        return sum;
    }
    // What is said after so many seconds, over what is so.
    double said(double after) const
    {
        const double left = all() - after;
        std::vector<StageForecast> now = stages;
        for (std::size_t i = 0; i < now.size() && after > 0.0; i++) {
            now[i].seconds = std::min(after, seconds(i));
            now[i].worked = now[i].units * now[i].seconds / seconds(i);
            now[i].over = now[i].seconds == seconds(i);
            after -= now[i].seconds;
        }
        return secondsLeft(now) / left;
    }
};
}

static History invented(std::vector<double> slowness)
{
    return {{{"layout", 1000, 1e-3}, {"light", 5e4, 1e-3, Tempo::light}, {"more light", 2e4, 1e-3, Tempo::light}, {"files", 1, 3.0}},
            std::move(slowness)};
}

// The machine is three times slower and the level four times darker than anybody reckoned.
TEST(Forecast, learnsHowSlowEachKindIs)
{
    const History history = invented({3.0, 12.0, 12.0, 3.0});
    for (const double share : {0.1, 0.5, 0.9, 0.99}) EXPECT_NEAR(history.said(share * history.all()), 1.0, 0.02) << share;
}

TEST(Forecast, bearsWhatIsReckonedWrong)
{
    // More light is a sixth dearer than light has shown, files a third dearer than the layout has
    const History history = invented({1.0, 6.0, 7.0, 1.33});
    for (const double share : {0.1, 0.3, 0.6}) EXPECT_NEAR(history.said(share * history.all()), 1.0, 0.15) << share;
}

TEST(Forecast, isWhatWasReckonedAtFirst)
{
    EXPECT_NEAR(invented({1, 1, 1, 1}).said(0.0), 1.0, 1e-12);
    EXPECT_EQ(secondsLeft({}), 0.0);
}

// A stage of a millisecond is no measure of the machine.
TEST(Forecast, believesNoStageThatIsTooShort)
{
    StageForecast tiny{"layout", 10, 1e-5};
    tiny.worked = 10, tiny.seconds = 3e-3, tiny.over = true; // thirty times what was reckoned
    EXPECT_NEAR(secondsLeft({tiny, {"files", 1, 1.0}}), 1.0, 0.05);
}

// What was found done took no time: it makes nothing look fast.
TEST(Forecast, takesWhatWasFoundForNoWork)
{
    StageForecast stage{"light", 1000, 1.0};
    stage.found = 500, stage.worked = 100, stage.seconds = 200;
    EXPECT_NEAR(secondsLeft({stage}), 400 * 2.0, 0.1);
    stage.found = 1000, stage.worked = 0, stage.seconds = 0;
    EXPECT_EQ(secondsLeft({stage}), 0.0);
}
}
