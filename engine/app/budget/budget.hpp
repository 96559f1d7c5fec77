// A frame that keeps to a time: of what its effects offer, the choice with the least error that fits, and what it gives up.
#pragma once
#include "engine/app/budget/search.hpp"
#include "engine/frame/plan.hpp"
#include <nlohmann/json_fwd.hpp>

namespace afterglow
{
constexpr int kBudgetFrames = 20; // whose median counts

struct Fitted {
    double budgetMs = 0.0;
    Settings settings;
    bool fits = false;  // the median of kBudgetFrames, with the margin
    double ms = 0.0;    // that median
    double error = 0.0; // relative, in motion, against the path-traced picture
    double defaultMs = 0.0, defaultError = 0.0;
    double equalScale = 1.0, equalMs = 0.0, equalError = 0.0; // the default settings at the render scale that takes as long
    std::vector<std::string> gaveUp;                          // "fog: steps 4 instead of 16"
    std::size_t unmeasured = 0;                               // options that nobody had the time to measure yet
    double seconds = 0.0;                                     // that all this took
};

// Says how it goes on; throws Error.
Fitted fitBudget(Sitter sitter, double milliseconds, ProgressStyle progress);

// The plan's reason of what was given up, where it reads "asked for on the command line", which nobody did.
void tellGivenUp(Plan& plan, const Settings& asked, const Fitted& fitted);

// In sentences, for a person.
std::vector<std::string> spoken(const Fitted& fitted);

// {"ms","margin","frames","fits","frame_ms","error","default":{"ms","error"},"equal_time":{"render_scale","ms","error"},"gave_up":[...],
//  "unmeasured","seconds"}
nlohmann::json jsonOf(const Fitted& fitted);
}
