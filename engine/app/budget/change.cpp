#include "engine/app/budget/change.hpp"

namespace afterglow
{
Change changeOf(const Judged& standing, const Judged& changed)
{
    Change change{.error = changed.error};
    for (const auto& [name, pass] : standing.look.passes) {
        const auto found = changed.look.passes.find(name);
        if (found == changed.look.passes.end())
            change.times[name] = 0.0;
        else if (pass.ms > 0.0 && pass.work != found->second.work)
            change.times[name] = found->second.ms / pass.ms;
    }
    for (const auto& [name, pass] : changed.look.passes)
        if (!standing.look.passes.contains(name)) change.added += pass.ms / standing.look.ms;
    return change;
}

double addedMs(const Change& change, const Look& small, const Look& large, double pixels)
{
    double ms = change.added * small.ms * pixels;
    for (const auto& [name, times] : change.times)
        if (const auto found = large.passes.find(name); found != large.passes.end()) ms += found->second.ms * (times - 1.0);
    return ms;
}
}
