#include "engine/frame/plan_rules.hpp"
#include <array>
#include <cmath>

namespace afterglow
{
namespace
{
using Needs = std::vector<Need>;

std::string several(std::size_t count, const std::string& one) { return count == 1 ? "1 " + one : std::to_string(count) + " " + one + "s"; }

std::string millimetres(float metres) { return std::to_string(std::lround(1000.0f * metres)) + " mm"; }

Choice choose(bool on, std::string because, std::string otherwise) { return {on, std::move(on ? because : otherwise)}; }

Choice wanted(const Needs& needs, const char* effect) { return {need(needs, effect).on, need(needs, effect).reason}; }

std::string missing(const Evidence& e) { return e.baked ? "the bake holds none" : "the level is not baked"; }

Choice everyPicture(const Needs&, const Evidence&) { return {true, "every picture needs it"}; }

Choice masked(const Needs&, const Evidence& e) { return choose(e.masked, "a material has an alpha mask", "no alpha mask"); }

Choice shadow(const Needs&, const Evidence& e)
{
    return choose(e.runtimeLights > 0, several(e.runtimeLights, "light") + " whose direct part is drawn here",
                  e.lights > 0 ? "the bake holds the direct part of every light" : "no punctual light");
}

Choice cascades(const Needs&, const Evidence& e)
{
    if (!(e.sunTexel > 0.0f)) return {false, "no directional light is drawn here"};
    return choose(e.sunTexel > kCoarseTexel, "one map of the level resolves no more than " + millimetres(e.sunTexel),
                  "one map of the level resolves " + millimetres(e.sunTexel));
}

Choice lightmaps(const Needs&, const Evidence& e)
{
    return choose(e.lightmaps > 0, several(e.lightmaps, "page") + " in the bake", missing(e));
}

Choice probes(const Needs& needs, const Evidence& e)
{
    if (e.probes == 0) return {false, missing(e)};
    if (e.unmapped) return {true, "something is drawn that has no lightmap"};
    if (e.twoSided) return {true, "a material has two sides, and lightmaps know the front"};
    return choose(need(needs, "fog").on, "they light the fog", "everything drawn has a lightmap");
}

Choice reflections(const Needs& needs, const Evidence& e)
{
    if (e.reflections == 0) return {false, missing(e)};
    const Choice called = wanted(needs, "reflections");
    return choose(called.on, several(e.reflections, "cubemap") + " in the bake, " + called.reason, called.reason);
}

Choice reflection(const Needs& needs, const Evidence&) { return wanted(needs, "reflection"); }

Choice clear(const Needs&, const Evidence& e)
{
    return choose(e.clear, "a material is blended or lets light through", "every surface is opaque");
}

Choice fog(const Needs& needs, const Evidence&) { return wanted(needs, "fog"); }

constexpr std::array kRules = {
    Rule{"geometry", everyPicture, /* always= */ true},
    Rule{"masked", masked},
    Rule{"shadow", shadow},
    Rule{"shadow.cascades", cascades},
    Rule{"lighting", everyPicture, /* always= */ true},
    Rule{"lightmaps", lightmaps},
    Rule{"probes", probes},
    Rule{"reflections", reflections},
    Rule{"reflection", reflection},
    Rule{"clear", clear},
    Rule{"fog", fog},
    Rule{"display", everyPicture, /* always= */ true},
    Rule{"occlusion", nullptr},
    Rule{"planar", nullptr},
    Rule{"toon", nullptr},
    Rule{"outline", nullptr},
    Rule{"bloom", nullptr},
};
}

std::span<const Rule> rules() { return kRules; }
}
