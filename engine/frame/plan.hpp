// What a frame of this level will run, and why, in words: `afterglow plan`. What is off has no pass, no pipeline and no memory.
#pragma once
#include "engine/baked/baked.hpp"
#include "engine/frame/settings.hpp"
#include "engine/scene/needs.hpp"
#include <span>

namespace afterglow
{
// `reason` reads after "fog: on, " or "fog: off, ".
struct PlannedEffect {
    std::string effect;
    bool on = false;
    std::string reason;
};

// What the plan knows of the level beside its needs: what the bake holds and what the device can do.
struct OpaqueSurfaces {
    bool mapped = false, unmapped = false; // some is drawn that has a lightmap; that has none
};
struct Evidence {
    bool baked = false;
    std::size_t lightmaps = 0, probes = 0, reflections = 0; // pages, boxes, cubemaps
    bool directions = false, bent = false;                  // the lightmaps know them; something that has a lightmap has a normal map
    std::size_t runtimeLights = 0;                          // whose direct part the bake does not hold
    std::size_t lights = 0;                                 // all of them
    std::size_t sized = 0;                                  // of runtimeLights, those that have a size
    float sunTexel = 0.0f;                   // m, of one shadow map of the whole level; 0: the runtime adds no sun, or there is no level
    bool unmapped = false, twoSided = false; // something is drawn that has no lightmap, or none on its back
    OpaqueSurfaces smooth, stepped;          // that light shines on; stepped: those that toon, where it is on, draws in steps
    bool masked = false, clear = false;      // alpha masks; blended or transmissive surfaces
    bool tracedShadows = false, tracedContact = false, tracedMirrors = false; // by ray query, where shadow, occlusion, reflection are drawn
    bool surrounded = false;  // light comes from everywhere: probes, reflections, or a sky where nothing baked says better
    std::size_t coarser = 0;  // primitives of which the bake holds coarser levels of detail
    float renderScale = 1.0f; // as asked for
};
// `settings`: with methods that the device can.
Evidence evidenceOf(const Scene& scene, const Baked* baked, const Settings& settings = {});

struct Plan {
    std::vector<PlannedEffect> effects; // in the order of the frame
    std::vector<std::string> notes;     // what was asked for and cannot be had, in sentences
    bool on(std::string_view effect) const;
};

// Rays that shadows are traced by know the surfaces in the G-buffer alone. What keeps the maps, in words after "by maps"; empty: nothing
// does. `effects`: on(name) says which are.
template <typename Effects>
std::string keptMaps(const Effects& effects)
{
    std::string where = effects.on("fog") ? " in the air" : "";
    const auto also = [&](const char* effect, const char* place) {
        if (effects.on(effect)) where += (where.empty() ? " " : ", ") + std::string(place);
    };
    also("clear", "on clear surfaces");
    also("planar", "in mirrors");
    also("portal", "beyond portals");
    return where;
}

// How a camera shows radiance, wherever that comes from.
bool isOfTheCamera(const std::string& effect);

// Of a path-traced picture: that alone is left.
void leaveToPaths(Plan& plan);

Plan plan(const std::vector<Need>& needs, const Evidence& evidence, const Overrides& overrides);

// Into its notes: knobs that were turned of effects that are off.
void noteIdleKnobs(Plan& plan, const Settings& settings);
}
