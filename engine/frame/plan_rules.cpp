#include "engine/frame/plan_rules.hpp"
#include <array>
#include <cmath>

namespace afterglow
{
namespace
{
std::string several(std::size_t count, const std::string& one) { return count == 1 ? "1 " + one : std::to_string(count) + " " + one + "s"; }

std::string millimetres(float metres) { return std::to_string(std::lround(1000.0f * metres)) + " mm"; }

Ruling choose(bool on, std::string because, std::string otherwise) { return {on, std::move(on ? because : otherwise)}; }

Ruling wanted(const Question& q, const char* effect) { return {need(q.needs, effect).on, need(q.needs, effect).reason}; }

std::string missing(const Evidence& e) { return e.baked ? "the bake holds none" : "the level is not baked"; }

Ruling everyPicture(const Question&) { return {true, "every picture needs it"}; }

Ruling masked(const Question& q) { return choose(q.level.masked, "a material has an alpha mask", "no alpha mask"); }

// Coarser where nobody sees it; what rays and lines meet is the finest.
Ruling lods(const Question& q)
{
    if (q.level.coarser == 0) return {false, missing(q.level)};
    const bool traced = (q.level.tracedShadows && q.on("shadow")) || (q.level.tracedContact && q.on("occlusion")) ||
                        (q.level.tracedMirrors && q.on("reflection"));
    if (traced) return {false, "rays meet the surfaces at their finest"};
    if (q.on("outline")) return {false, "lines are drawn along the finest edges"};
    return {true, several(q.level.coarser, "surface") + " of the bake in levels of detail"};
}

Ruling shadow(const Question& q)
{
    std::string how, maps = keptMaps(q);
    if (q.level.tracedShadows) how = ", by ray query" + (maps.empty() ? "" : "; by maps" + maps);
    return choose(q.level.runtimeLights > 0, several(q.level.runtimeLights, "light") + " whose direct part is drawn here" + how,
                  q.level.lights > 0 ? "the bake holds the direct part of every light" : "no punctual light");
}

Ruling cascades(const Question& q)
{
    if (!(q.level.sunTexel > 0.0f)) return {false, "no directional light is drawn here"};
    return choose(q.level.sunTexel > kCoarseTexel, "one map of the level resolves no more than " + millimetres(q.level.sunTexel),
                  "one map of the level resolves " + millimetres(q.level.sunTexel));
}

// Rays to a point agree, and so do those of a light whose shadows are mapped.
Ruling shadowDenoise(const Question& q)
{
    if (!q.on("shadow") || !q.level.tracedShadows) return {false, "no shadow is traced"};
    return choose(q.level.sized > 0, "few rays to " + several(q.level.sized, "light") + " of a size scatter", "every light is a point");
}

// It dims what no lightmap lights, and what is not in steps. Backs alone do not call for it: exporters say of everything that it has two
// sides, and a quarter of the frame would be paid for what hardly anyone sees.
Ruling occlusion(const Question& q)
{
    const bool held = q.on("lightmaps"), toon = q.on("toon");
    const auto dims = [&](const OpaqueSurfaces& s) { return s.unmapped || (s.mapped && !held); };
    const bool smooth = dims(q.level.smooth), stepped = dims(q.level.stepped);
    if (!smooth && (toon || !stepped))
        return {false, stepped ? "surfaces in steps show no contact" : "lightmaps hold the contact of everything opaque"};
    if (!q.level.surrounded) return {false, "no light from everywhere to dim"};
    if (!q.level.baked) return {true, "the level is not baked, so no lightmap holds the contact"};
    if (!held) return {true, "no lightmap is drawn that holds the contact"};
    const Ruling moving = wanted(q, "occlusion");
    if (moving.on) return moving;
    return {true, "something drawn has no lightmap to hold the contact"};
}

Ruling occlusionDenoise(const Question& q)
{
    return choose(q.on("occlusion") && q.level.tracedContact, "few rays over a hemisphere scatter", "no contact is traced");
}

Ruling lightmaps(const Question& q)
{
    return choose(q.level.lightmaps > 0, several(q.level.lightmaps, "page") + " in the bake", missing(q.level));
}

// Lightmaps that tell normals apart.
Ruling directional(const Question& q)
{
    if (!q.on("lightmaps")) return {false, "no lightmap is drawn"};
    if (!q.level.bent) return {false, "nothing that has a lightmap has a normal map"};
    return choose(q.level.directions, "something that has a lightmap has a normal map", "the bake holds no directions");
}

Ruling probes(const Question& q)
{
    if (q.level.probes == 0) return {false, missing(q.level)};
    if (q.level.unmapped) return {true, "something is drawn that has no lightmap"};
    if (!q.on("lightmaps") && q.level.lightmaps > 0) return {true, "no lightmap is drawn"};
    if (q.level.twoSided) return {true, "a material has two sides, and lightmaps know the front"};
    return choose(q.on("fog"), "they light the fog", "everything drawn has a lightmap");
}

Ruling reflections(const Question& q)
{
    if (q.level.reflections == 0) return {false, missing(q.level)};
    const Ruling called = wanted(q, "reflections");
    return choose(called.on, several(q.level.reflections, "cubemap") + " in the bake, " + called.reason, called.reason);
}

Ruling reflection(const Question& q) { return wanted(q, "reflection"); }

Ruling clear(const Question& q) { return choose(q.level.clear, "a material is blended or lets light through", "every surface is opaque"); }

Ruling planar(const Question& q) { return wanted(q, "planar"); }

Ruling portal(const Question& q) { return wanted(q, "portal"); }

Ruling fog(const Question& q) { return wanted(q, "fog"); }

Ruling toon(const Question& q) { return wanted(q, "toon"); }

Ruling outline(const Question& q) { return wanted(q, "outline"); }

Ruling antialias(const Question& q)
{
    const Need& drawn = need(q.needs, "geometry");
    return choose(drawn.on, drawn.reason + ", with edges finer than a pixel", drawn.reason);
}

Ruling upscale(const Question& q)
{
    return choose(q.level.renderScale < 1.0f, "drawn at " + std::to_string(std::lround(100.0f * q.level.renderScale)) + " % of its size",
                  "drawn at its own size");
}

Ruling bloom(const Question& q) { return wanted(q, "bloom"); }

constexpr std::array kRules = {
    Rule{"geometry", everyPicture, /* always= */ true},
    Rule{"masked", masked},
    Rule{"lods", lods},
    Rule{"shadow", shadow},
    Rule{"shadow.cascades", cascades},
    Rule{"shadow.denoise", shadowDenoise},
    Rule{"occlusion", occlusion},
    Rule{"occlusion.denoise", occlusionDenoise},
    Rule{"lighting", everyPicture, /* always= */ true},
    Rule{"lightmaps", lightmaps},
    Rule{"directional", directional},
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
