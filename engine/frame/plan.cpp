#include "engine/frame/plan.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/lighting/lighting.hpp"
#include "engine/effects/toon/toon.hpp"
#include "engine/frame/plan_rules.hpp"
#include "shaders/light.h"
#include <algorithm>
#include <sstream>

namespace afterglow
{
namespace
{
// What the level calls for, unless the command line says something else that can be had; in `notes`, if there are any, what cannot.
PlannedEffect decided(const Rule& rule, const Question& question, std::vector<std::string>* notes)
{
    const Ruling choice = rule.called(question);
    PlannedEffect planned{rule.effect, choice.on, choice.reason};
    const Overrides& overrides = question.overrides;
    const auto forced = overrides.forced.find(planned.effect);
    bool wanted = planned.on;
    if (overrides.base != Overrides::Base::automatic) wanted = overrides.base == Overrides::Base::all;
    if (forced != overrides.forced.end()) wanted = forced->second;
    if (wanted == planned.on) return planned;
    if (rule.always) {
        if (forced == overrides.forced.end()) return planned; // `none` leaves what there must be
        const std::string why = planned.effect + " cannot be off";
        if (notes) notes->push_back("--effects: " + why);
        planned.reason = why + ", although the command line asks; the plan: " + planned.reason;
        return planned;
    }
    planned.on = wanted;
    planned.reason = "asked for on the command line; the plan: " + planned.reason;
    return planned;
}
}

bool Question::on(std::string_view effect) const
{
    const auto rule = std::find_if(rules().begin(), rules().end(), [&](const Rule& r) { return r.effect == effect; });
    check(rule != rules().end(), "no effect is called " + std::string(effect));
    return decided(*rule, *this, nullptr).on;
}

bool Plan::on(std::string_view effect) const
{
    for (const PlannedEffect& planned : effects)
        if (planned.effect == effect) return planned.on;
    check(false, "no effect is called " + std::string(effect));
    return false;
}

Evidence evidenceOf(const Scene& scene, const Baked* baked, const Settings& settings)
{
    Evidence e;
    e.renderScale = settings.renderScale;
    e.tracedShadows = settings.shadowMethod == ShadowMethod::ray;
    e.tracedContact = settings.occlusionMethod == OcclusionMethod::ray;
    e.tracedMirrors = settings.reflectionMethod == ReflectionMethod::ray;
    e.lights = scene.lights.size();
    const std::vector<Light> lights = runtimeLights(scene, baked != nullptr, baked && baked->directAll);
    e.runtimeLights = lights.size();
    for (const Light& light : lights) e.sized += !isDeltaLight(light);
    for (const Light& light : lights)
        if (light.type == kLightDirectional) e.sunTexel = distance(scene.lower, scene.upper) / float(defaultShadowParameters().sunTexels);
    if (baked) {
        e.baked = true;
        e.lightmaps = baked->lightmaps.size();
        e.directions = !baked->lightmaps.empty() && !baked->lightmaps[0].direction.empty();
        e.probes = baked->probes.probes.size();
        e.reflections = baked->reflections.size();
        for (const MeshLods& mesh : baked->lods)
            for (const std::vector<LodLevel>& levels : mesh.primitives) e.coarser += !levels.empty();
    }
    e.surrounded = e.probes > 0 || e.reflections > 0 || meanSky(scene.sky) != vec3(0.0f);
    const ToonRamps ramps = toonRamps(scene, settings.toon);
    for (const Instance& instance : baked ? placedInstances(*baked) : instances(scene)) {
        const Material& material = scene.materials[instance.material];
        e.unmapped |= instance.lightmap < 0;
        e.bent |= instance.lightmap >= 0 && isBent(material);
        e.twoSided |= (material.flags & kMaterialDoubleSided) != 0;
        e.masked |= (material.flags & kMaterialAlphaMask) != 0;
        e.clear |= isClear(material);
        if (isClear(material) || (material.flags & kMaterialUnlit) != 0) continue;
        OpaqueSurfaces& surfaces = ramps.ofMaterial[instance.material].steps > 0 ? e.stepped : e.smooth;
        surfaces.mapped |= instance.lightmap >= 0;
        surfaces.unmapped |= instance.lightmap < 0;
    }
    return e;
}

Plan plan(const std::vector<Need>& needs, const Evidence& evidence, const Overrides& overrides)
{
    Plan result;
    const Question question{needs, evidence, overrides};
    for (const Rule& rule : rules()) result.effects.push_back(decided(rule, question, &result.notes));
    return result;
}

void noteIdleKnobs(Plan& plan, const Settings& settings)
{
    for (const auto& [knob, effect] : settings.said)
        for (const PlannedEffect& planned : plan.effects)
            if (planned.effect == effect && !planned.on && !(effect == "upscale" && settings.renderScale == 1.0f)) // which is how it is off
                plan.notes.push_back(knob + " does nothing here: " + effect + " is off, " + planned.reason);
}

bool isOfTheCamera(const std::string& effect) { return effect == "bloom" || effect == "display"; }

void leaveToPaths(Plan& plan)
{
    for (PlannedEffect& planned : plan.effects)
        if (!isOfTheCamera(planned.effect)) planned = {planned.effect, false, "the picture is path traced"};
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
            const auto [said, isNew] = overrides.forced.emplace(name, word[0] != '-');
            if (!isNew && said->second != (word[0] != '-'))
                throw Error("--effects " + text + ": " + name + " is named both on and off; leave one of them", Exit::usage);
        }
    }
    return overrides;
}
}
