// `afterglow plan`: what a frame of the level would run, and why; or what of it fits a time.
#include "engine/frame/plan.hpp"
#include "engine/app/budget/budget.hpp"
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
    Settings settings = adoptLevel(command.settings, target.scene());
    std::optional<Fitted> fitted;
    if (command.milliseconds) {
        Gpu gpu(deviceOptions(command.device));
        Executor executor(gpu);
        const Camera camera = findCamera(target.scene(), command.camera);
        fitted = fitBudget({target, command.target, settings, camera, executor}, *command.milliseconds, command.progress);
        settings = fitted->settings;
    }
    const Evidence evidence = evidenceOf(target.scene(), bake, settings); // of a device that can what is asked for
    Plan planned = plan(needs(target.scene(), bake && bake->directAll), evidence, settings.effects);
    noteIdleKnobs(planned, settings);
    if (fitted) tellGivenUp(planned, command.settings, *fitted);
    for (const std::string& line : planned.notes) note(line);
    nlohmann::json lines = nlohmann::json::array();
    for (const PlannedEffect& effect : planned.effects) {
        if (command.json)
            lines.push_back({{"effect", effect.effect}, {"on", effect.on}, {"reason", effect.reason}});
        else
            std::printf("%s: %s, %s\n", effect.effect.c_str(), effect.on ? "on" : "off", effect.reason.c_str());
    }
    if (fitted && !command.json)
        for (const std::string& line : spoken(*fitted)) std::printf("%s\n", line.c_str());
    if (fitted) lines = {{"plan", lines}, {"budget", jsonOf(*fitted)}};
    if (command.json) std::printf("%s\n", lines.dump(2).c_str());
}
}
