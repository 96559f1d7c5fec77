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

Choice shadow(const Needs& needs, const Evidence& e)
{
    std::string how;
    if (e.tracedShadows) how = ", by ray query";
    if (e.tracedShadows && (e.clear || need(needs, "fog").on)) how += "; by maps in the air and on clear surfaces";
    return choose(e.runtimeLights > 0, several(e.runtimeLights, "light") + " whose direct part is drawn here" + how,
                  e.lights > 0 ? "the bake holds the direct part of every light" : "no punctual light");
}

Choice cascades(const Needs&, const Evidence& e)
{
    if (!(e.sunTexel > 0.0f)) return {false, "no directional light is drawn here"};
    return choose(e.sunTexel > kCoarseTexel, "one map of the level resolves no more than " + millimetres(e.sunTexel),
                  "one map of the level resolves " + millimetres(e.sunTexel));
}

Choice occlusion(const Needs& needs, const Evidence& e)
{
    if (!e.contactless) return {false, "lightmaps hold the contact of everything opaque"};
    if (!e.surrounded) return {false, "no light from everywhere to dim"};
    if (!e.baked) return {true, "the level is not baked, so no lightmap holds the contact"};
    return {true,
            wanted(needs, "occlusion").on ? wanted(needs, "occlusion").reason : "something drawn has no lightmap to hold the contact"};
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

Choice planar(const Needs& needs, const Evidence&) { return wanted(needs, "planar"); }

Choice portal(const Needs& needs, const Evidence&) { return wanted(needs, "portal"); }

Choice fog(const Needs& needs, const Evidence&) { return wanted(needs, "fog"); }

Choice toon(const Needs& needs, const Evidence&) { return wanted(needs, "toon"); }

Choice outline(const Needs& needs, const Evidence&) { return wanted(needs, "outline"); }

Choice antialias(const Needs& needs, const Evidence&)
{
    const Need& drawn = need(needs, "geometry");
    return choose(drawn.on, drawn.reason + ", with edges finer than a pixel", drawn.reason);
}

Choice upscale(const Needs&, const Evidence& e)
{
    return choose(e.renderScale < 1.0f, "drawn at " + std::to_string(std::lround(100.0f * e.renderScale)) + " % of its size",
                  "drawn at its own size");
}

Choice bloom(const Needs& needs, const Evidence&) { return wanted(needs, "bloom"); }

constexpr std::array kRules = {
    Rule{"geometry", everyPicture, /* always= */ true},
    Rule{"masked", masked},
    Rule{"shadow", shadow},
    Rule{"shadow.cascades", cascades},
    Rule{"occlusion", occlusion},
    Rule{"lighting", everyPicture, /* always= */ true},
    Rule{"lightmaps", lightmaps},
    Rule{"probes", probes},
    Rule{"reflections", reflections},
    Rule{"toon", toon},
    Rule{"reflection", reflection},
    Rule{"clear", clear},
    Rule{"planar", planar},
    Rule{"portal", portal},
    Rule{"fog", fog},
    Rule{"outline", outline},
    Rule{"antialias", antialias},
    Rule{"upscale", upscale},
    Rule{"bloom", bloom},
    Rule{"display", everyPicture, /* always= */ true},
};
}

std::span<const Rule> rules() { return kRules; }
}
