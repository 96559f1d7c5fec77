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

// The command line speaks of it: it stays as it is.
bool isSaid(const Settings& settings, const std::string& effect)
{
    const auto ofIt = [&](const auto& knob) { return knob.second == effect; };
    return std::any_of(settings.said.begin(), settings.said.end(), ofIt) || settings.effects.forced.contains(effect);
}

// Whether the sweep is of another method than the settings', so that its default is another option, too.
bool ofAnotherMethod(const Sweep& sweep, const Settings& settings)
{
    Setup setup{.settings = settings};
    if (sweep.given) sweep.given(setup);
    const auto methods = [](const Settings& s) { return std::tuple(s.shadowMethod, s.occlusionMethod, s.reflectionMethod); };
    return methods(setup.settings) != methods(settings);
}

Option optionOf(const Sweep& sweep, std::size_t index, std::optional<std::size_t> standing)
{
    const double value = sweep.values[index], usual = sweep.turn.get(Setup{});
    Option option{.name = fmt::format("{} {}", sweep.knob, index < sweep.names.size() ? sweep.names[index] : fmt::format("{:.3g}", value))};
    if (sweep.names.empty() && value != usual) option.name += fmt::format(" instead of {:.3g}", usual);
    option.choose = [sweep, value](Settings& settings) {
        Setup setup{.settings = settings};
        if (sweep.given) sweep.given(setup);
        sweep.turn.set(setup, value);
        settings = setup.settings;
    };
    option.staged = sweep.staged && standing; // a stage is made for a method
    option.knob = sweep.knob, option.place = int(index), option.last = int(sweep.values.size()) - 1;
    if (standing) option.standing = int(*standing);
    return option;
}

void addKnob(Group& group, const Sweep& sweep, const Settings& settings)
{
    std::optional<std::size_t> standing;
    if (!ofAnotherMethod(sweep, settings)) {
        const double now = sweep.turn.get(Setup{.settings = settings});
        const auto found = std::find(sweep.values.begin(), sweep.values.end(), now);
        standing = std::size_t(found - sweep.values.begin()); // one beyond the last: the default is dearer than all of them
    }
    for (std::size_t i = 0; i < sweep.values.size(); ++i)
        if (i != standing) group.options.push_back(optionOf(sweep, i, standing));
}

bool timesFrames(const Sweep& sweep) { return sweep.clock == Clock::passes || sweep.clock == Clock::frame; }
}

bool mayBeScaled(const Settings& settings) { return !isSaid(settings, kScaled); }

std::vector<Group> optionsFor(const Plan& plan, const Settings& settings, bool rayQuery)
{
    const std::vector<Sweep> all = knobs();
    std::vector<Group> groups;
    for (const std::string& effect : subjectNames({})) {
        const auto ofEffect = [&](const Sweep& sweep) { return sweep.subject == effect; };
        const bool isProduct = std::any_of(all.begin(), all.end(), [&](const Sweep& s) { return ofEffect(s) && s.clock == Clock::bake; });
        const bool drawn =
            std::any_of(plan.effects.begin(), plan.effects.end(), [&](const PlannedEffect& e) { return e.effect == effect && e.on; });
        if (!drawn || effect == kScaled || staysAsItIs(effect) || isProduct || isSaid(settings, effect)) continue;
        Group group{effect, {{.name = "as it is"}}};
        for (const Sweep& sweep : all)
            if (ofEffect(sweep) && timesFrames(sweep) && (!sweep.rays || rayQuery)) addKnob(group, sweep, settings);
        group.options.push_back({.name = "left out", .choose = [effect](Settings& s) { s.effects.forced[effect] = false; }});
        groups.push_back(std::move(group));
    }
    return groups;
}
}
