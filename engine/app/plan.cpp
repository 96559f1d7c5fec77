// `afterglow plan`: what a frame of the level would run, and why.
#include "engine/frame/plan.hpp"
#include "engine/app/level.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/core/log.hpp"
#include <cstdio>
#include <nlohmann/json.hpp>

namespace afterglow
{
void planVerb(const PlanCommand& command)
{
    const Target target = loadTarget(command.target);
    const Baked* bake = target.bake();
    const Settings settings = adoptLevel(command.settings, target.scene());
    const Evidence evidence = evidenceOf(target.scene(), bake, settings); // of a device that can what is asked for
    const Plan planned = plan(needs(target.scene(), bake && bake->directAll), evidence, settings.effects);
    for (const std::string& line : planned.notes) note(line);
    nlohmann::json lines = nlohmann::json::array();
    for (const PlannedEffect& effect : planned.effects) {
        if (command.json)
            lines.push_back({{"effect", effect.effect}, {"on", effect.on}, {"reason", effect.reason}});
        else
            std::printf("%s: %s, %s\n", effect.effect.c_str(), effect.on ? "on" : "off", effect.reason.c_str());
    }
    if (command.json) std::printf("%s\n", lines.dump(2).c_str());
}
}
