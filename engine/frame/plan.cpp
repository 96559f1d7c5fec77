#include "engine/frame/plan.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace afterglow
{
namespace
{
// In the order of the frame. The last five are called for by levels, but no pass draws them yet.
constexpr std::array<const char*, 16> kNames = {"geometry",    "masked", "shadow", "shadow.cascades", "lighting",  "lightmaps", "probes",
                                                "reflections", "clear",  "fog",    "display",         "occlusion", "planar",    "toon",
                                                "outline",     "bloom"};
constexpr std::size_t kDrawn = 11;

// Without these there is no picture; no option turns them off.
bool always(std::string_view effect) { return effect == "geometry" || effect == "lighting" || effect == "display"; }
bool drawn(std::string_view effect) { return std::find(kNames.begin(), kNames.begin() + kDrawn, effect) != kNames.begin() + kDrawn; }

std::string several(std::size_t count, const std::string& one) { return count == 1 ? "1 " + one : std::to_string(count) + " " + one + "s"; }

std::string millimetres(float metres) { return std::to_string(std::lround(1000.0f * metres)) + " mm"; }

PlannedEffect choose(const char* effect, bool on, std::string because, std::string otherwise)
{
    return {effect, on, on ? std::move(because) : std::move(otherwise)};
}

// What the level calls for, before anybody overrules it.
PlannedEffect called(std::string_view effect, const std::vector<Need>& needs, const Evidence& e)
{
    const std::string unbaked = "the level is not baked";
    if (effect == "geometry") return {"geometry", true, "every picture needs it"};
    if (effect == "masked") return choose("masked", e.masked, "a material has an alpha mask", "no alpha mask");
    if (effect == "shadow")
        return choose("shadow", e.runtimeLights > 0, several(e.runtimeLights, "light") + " whose direct part is drawn here",
                      e.lights > 0 ? "the bake holds the direct part of every light" : "no punctual light");
    if (effect == "shadow.cascades") {
        if (!(e.sunTexel > 0.0f)) return {"shadow.cascades", false, "no directional light is drawn here"};
        return choose("shadow.cascades", e.sunTexel > kCoarseTexel, "one map of the level resolves no more than " + millimetres(e.sunTexel),
                      "one map of the level resolves " + millimetres(e.sunTexel));
    }
    if (effect == "lighting") return {"lighting", true, "every picture needs it"};
    if (effect == "lightmaps")
        return choose("lightmaps", e.lightmaps > 0, several(e.lightmaps, "page") + " in the bake",
                      e.baked ? "the bake holds none" : unbaked);
    if (effect == "probes") {
        if (e.probes == 0) return {"probes", false, e.baked ? "the bake holds none" : unbaked};
        if (e.unmapped) return {"probes", true, "something is drawn that has no lightmap"};
        if (e.twoSided) return {"probes", true, "a material has two sides, and lightmaps know the front"};
        const bool fog = need(needs, "fog").on;
        return choose("probes", fog, "they light the fog", "everything drawn has a lightmap");
    }
    if (effect == "reflections")
        return choose("reflections", e.reflections > 0 && need(needs, "reflections").on,
                      several(e.reflections, "cubemap") + " in the bake, " + need(needs, "reflections").reason,
                      !e.baked            ? unbaked
                      : e.reflections > 0 ? need(needs, "reflections").reason
                                          : "the bake holds none");
    if (effect == "clear") return choose("clear", e.clear, "a material is blended or lets light through", "every surface is opaque");
    const Need& wanted = need(needs, effect);
    if (drawn(effect) || !wanted.on) return {wanted.effect, wanted.on, wanted.reason};
    return {wanted.effect, false, "no pass draws it yet, although " + wanted.reason};
}

// What the command line says, as far as it can be had; why not where it cannot.
void overrule(PlannedEffect& planned, const Overrides& overrides, std::vector<std::string>& notes)
{
    const auto forced = overrides.forced.find(planned.effect);
    bool wanted = planned.on;
    if (overrides.base != Overrides::Base::automatic) wanted = overrides.base == Overrides::Base::all;
    if (forced != overrides.forced.end()) wanted = forced->second;
    if (wanted == planned.on) return;
    if (always(planned.effect) || !drawn(planned.effect)) {
        if (forced == overrides.forced.end()) return; // of `all` and `none`, as much as there is
        const std::string why = drawn(planned.effect) ? planned.effect + " cannot be off" : "no pass draws " + planned.effect + " yet";
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

std::span<const char* const> effectNames() { return kNames; }

Evidence evidenceOf(const Scene& scene, const Baked* baked)
{
    Evidence e;
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
    for (const Instance& instance : baked ? placedInstances(*baked) : instances(scene)) {
        const Material& material = scene.materials[instance.material];
        e.unmapped |= instance.lightmap < 0;
        e.twoSided |= (material.flags & kMaterialDoubleSided) != 0;
        e.masked |= (material.flags & kMaterialAlphaMask) != 0;
        e.clear |= isClear(material);
    }
    return e;
}

Plan plan(const std::vector<Need>& needs, const Evidence& evidence, const Overrides& overrides)
{
    Plan result;
    for (const char* name : kNames) {
        result.effects.push_back(called(name, needs, evidence));
        overrule(result.effects.back(), overrides, result.notes);
    }
    return result;
}

Overrides parseOverrides(const std::string& text)
{
    Overrides overrides;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        if (word == "auto" || word.empty())
            overrides.base = Overrides::Base::automatic;
        else if (word == "all")
            overrides.base = Overrides::Base::all;
        else if (word == "none")
            overrides.base = Overrides::Base::none;
        else {
            const std::string name = word.substr(word[0] == '+' || word[0] == '-' ? 1 : 0);
            if (std::find(kNames.begin(), kNames.end(), name) == kNames.end()) {
                std::string known;
                for (const char* effect : kNames) known += std::string(known.empty() ? "" : ", ") + effect;
                throw Error("--effects " + text + ": there is no effect '" + name + "'; there are " + known, Exit::usage);
            }
            overrides.forced[name] = word[0] != '-';
        }
    }
    return overrides;
}
}
