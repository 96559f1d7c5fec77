#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/choice.hpp"
#include "engine/app/study/sweeps.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
const PlannedEffect& callerOf(const std::string& subject, const Plan& planned)
{
    const std::string caller = calledBy(subject);
    return *std::find_if(planned.effects.begin(), planned.effects.end(), [&](const PlannedEffect& e) { return e.effect == caller; });
}

std::vector<std::string> studied(const StudyCommand& command, const Plan& planned, std::vector<std::string>& absent)
{
    std::vector<std::string> names;
    for (const std::string& name : subjectNames(command.effects)) {
        const PlannedEffect& caller = callerOf(name, planned);
        // What is for whoever asks, and what can be held against the light in any level
        if (caller.on || name == "upscale" || (name == "probes" && !command.effects.empty()))
            names.push_back(name);
        else
            absent.push_back(name + ": off, " + caller.reason);
    }
    if (names.empty()) throw Error("there is nothing to study: " + absent.front(), Exit::usage);
    return names;
}

// Without the values that the device cannot, which are told.
static Sweep ableOn(const Device& device, Sweep sweep, std::vector<std::string>& absent)
{
    for (std::size_t i = sweep.values.size(); sweep.able && i-- > 0;) {
        if (sweep.able(device, sweep.values[i])) continue;
        absent.push_back(fmt::format("{} by {} {}: {} cannot", sweep.subject, sweep.knob, sweep.names[i], device.deviceName));
        sweep.values.erase(sweep.values.begin() + std::ptrdiff_t(i));
        sweep.names.erase(sweep.names.begin() + std::ptrdiff_t(i));
    }
    return sweep;
}

std::vector<Sweep> sweepsOf(const std::string& subject, const Device& device, bool drawn, const StudyCommand& command,
                            std::vector<std::string>& absent)
{
    const bool quick = command.quick, all = command.effects.empty();
    std::vector<Sweep> sweeps;
    if (drawn) sweeps.push_back(drawnOrNot(subject));
    for (Sweep& sweep : knobs()) {
        if (sweep.subject != subject) continue;
        if (sweep.rays && !device.rayQuery) {
            absent.push_back(fmt::format("{} by {}: {} has no ray queries", subject, sweep.knob, device.deviceName));
            continue;
        }
        if (quick && all && sweep.slow) {
            absent.push_back(fmt::format("{} by {}: each compiles for a minute; a quick study asks for it by --effects {}", subject,
                                         sweep.knob, subject));
            continue;
        }
        if (quick) std::erase_if(sweep.values, [&](double value) { return value < sweep.least || value > sweep.quickly; });
        sweep = ableOn(device, std::move(sweep), absent);
        if (!sweep.values.empty()) sweeps.push_back(std::move(sweep));
    }
    return sweeps;
}
}
