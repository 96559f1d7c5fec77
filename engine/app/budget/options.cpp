#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/budget/options.hpp"
#include "engine/app/study/sweeps.hpp"
#include <algorithm>
#include <tuple>

namespace afterglow
{
namespace
{
// No shortcut lies there: styles and the glare of a lens have no truth among paths, and a leaf that is not cut out is another shape.
bool staysAsItIs(const std::string& effect) { return effect == "toon" || effect == "outline" || effect == "bloom" || effect == "masked"; }

// As the program has it when nobody says otherwise.
double standing(const Sweep& sweep) { return sweep.turn.get(Setup{}); }

Option optionOf(const Sweep& sweep, std::size_t index)
{
    const double value = sweep.values[index];
    Option option{.name = fmt::format("{} {}", sweep.knob, index < sweep.names.size() ? sweep.names[index] : fmt::format("{:.3g}", value))};
    if (sweep.names.empty()) option.name += fmt::format(" instead of {:.3g}", standing(sweep));
    option.choose = [sweep, value](Settings& settings) {
        Setup setup{.settings = settings};
        if (sweep.given) sweep.given(setup);
        sweep.turn.set(setup, value);
        settings = setup.settings;
    };
    option.staged = sweep.staged;
    if (sweep.subject == "upscale") option.scale = value;
    return option;
}

// Whether the sweep is of another method than the settings', so that its default is another option, too.
bool ofAnotherMethod(const Sweep& sweep, const Settings& settings)
{
    Setup setup{.settings = settings};
    if (sweep.given) sweep.given(setup);
    const auto methods = [](const Settings& s) { return std::tuple(s.shadowMethod, s.occlusionMethod, s.reflectionMethod); };
    return methods(setup.settings) != methods(settings);
}

bool timesFrames(const Sweep& sweep) { return sweep.clock == Clock::passes || sweep.clock == Clock::frame; }
}

std::vector<Group> optionsFor(const Plan& plan, const Settings& settings, bool rayQuery)
{
    const std::vector<Sweep> all = knobs();
    std::vector<Group> groups;
    for (const std::string& effect : subjectNames({})) {
        const auto ofEffect = [&](const Sweep& sweep) { return sweep.subject == effect; };
        const bool drawn =
            std::any_of(plan.effects.begin(), plan.effects.end(), [&](const PlannedEffect& e) { return e.effect == effect && e.on; });
        const bool isProduct = std::any_of(all.begin(), all.end(), [&](const Sweep& s) { return ofEffect(s) && s.clock == Clock::bake; });
        if ((!drawn && effect != "upscale") || staysAsItIs(effect) || isProduct || settings.effects.forced.contains(effect)) continue;
        Group group{effect, {{.name = "as it is"}}};
        bool turned = false;
        for (const Sweep& sweep : all) {
            if (!ofEffect(sweep) || !timesFrames(sweep) || (sweep.rays && !rayQuery)) continue;
            const double now = sweep.turn.get(Setup{.settings = settings});
            turned |= now != standing(sweep);
            for (std::size_t i = 0; i < sweep.values.size(); ++i)
                if (sweep.values[i] != now || ofAnotherMethod(sweep, settings)) group.options.push_back(optionOf(sweep, i));
        }
        if (turned) continue;
        if (drawn) group.options.push_back({.name = "left out", .choose = [effect](Settings& s) { s.effects.forced[effect] = false; }});
        groups.insert(effect == "upscale" ? groups.begin() : groups.end(), std::move(group)); // what fits every time is measured first
    }
    return groups;
}
}
