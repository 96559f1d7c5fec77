#include "engine/frame/plan.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/lighting/lighting.hpp"
#include "engine/frame/plan_rules.hpp"
#include <algorithm>
#include <sstream>

namespace afterglow
{
namespace
{
// What the level calls for.
PlannedEffect called(const Rule& rule, const std::vector<Need>& needs, const Evidence& evidence)
{
    const Choice choice = rule.called(needs, evidence);
    return {rule.effect, choice.on, choice.reason};
}

// What the command line says, as far as it can be had; why not where it cannot.
void overrule(PlannedEffect& planned, const Rule& rule, const Overrides& overrides, std::vector<std::string>& notes)
{
    const auto forced = overrides.forced.find(planned.effect);
    bool wanted = planned.on;
    if (overrides.base != Overrides::Base::automatic) wanted = overrides.base == Overrides::Base::all;
    if (forced != overrides.forced.end()) wanted = forced->second;
    if (wanted == planned.on) return;
    if (rule.always) {
        if (forced == overrides.forced.end()) return; // `none` leaves what there must be
        const std::string why = planned.effect + " cannot be off";
        notes.push_back("--effects: " + why);
        planned.reason = why + ", although the command line asks; the plan: " + planned.reason;
        return;
    }
    planned.on = wanted;
    planned.reason = "asked for on the command line; the plan: " + planned.reason;
}
}

bool Plan::on(std::string_view effect) const
{
    for (const PlannedEffect& planned : effects)
        if (planned.effect == effect) return planned.on;
    check(false, "no effect is called " + std::string(effect));
    return false;
}

Evidence evidenceOf(const Scene& scene, const Baked* baked, float renderScale)
{
    Evidence e;
    e.renderScale = renderScale;
    e.lights = scene.lights.size();
    const std::vector<Light> lights = runtimeLights(scene, baked != nullptr, baked && baked->directAll);
    e.runtimeLights = lights.size();
    for (const Light& light : lights)
        if (light.type == kLightDirectional) e.sunTexel = distance(scene.lower, scene.upper) / float(defaultShadowParameters().sunTexels);
    if (baked) {
        e.baked = true;
        e.lightmaps = baked->lightmaps.size();
        e.probes = baked->probes.size();
        e.reflections = baked->reflections.size();
    }
    e.surrounded = e.probes > 0 || e.reflections > 0 || meanSky(scene.sky) != vec3(0.0f);
    for (const Instance& instance : baked ? placedInstances(*baked) : instances(scene)) {
        const Material& material = scene.materials[instance.material];
        e.unmapped |= instance.lightmap < 0;
        e.twoSided |= (material.flags & kMaterialDoubleSided) != 0;
        e.masked |= (material.flags & kMaterialAlphaMask) != 0;
        e.clear |= isClear(material);
        e.contactless |= instance.lightmap < 0 && !isClear(material) && (material.flags & kMaterialUnlit) == 0;
    }
    return e;
}

Plan plan(const std::vector<Need>& needs, const Evidence& evidence, const Overrides& overrides)
{
    Plan result;
    for (const Rule& rule : rules()) {
        result.effects.push_back(called(rule, needs, evidence));
        overrule(result.effects.back(), rule, overrides, result.notes);
    }
    return result;
}

Overrides parseOverrides(const std::string& text)
{
    Overrides overrides;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        if (word.empty()) throw Error("--effects " + text + ": a word between its commas is missing", Exit::usage);
        if (word == "auto")
            overrides.base = Overrides::Base::automatic;
        else if (word == "all")
            overrides.base = Overrides::Base::all;
        else if (word == "none")
            overrides.base = Overrides::Base::none;
        else {
            const std::string name = word.substr(word[0] == '+' || word[0] == '-' ? 1 : 0);
            if (std::none_of(rules().begin(), rules().end(), [&](const Rule& rule) { return rule.effect == name; })) {
                std::string known;
                for (const Rule& rule : rules()) known += std::string(known.empty() ? "" : ", ") + rule.effect;
                throw Error("--effects " + text + ": there is no effect '" + name + "'; there are " + known, Exit::usage);
            }
            overrides.forced[name] = word[0] != '-';
        }
    }
    return overrides;
}
}
