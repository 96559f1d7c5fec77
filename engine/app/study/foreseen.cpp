#include "engine/app/study/foreseen.hpp"

namespace afterglow
{
// A bake without its light: which products there are, and which objects have a place in a lightmap.
static Baked hollowBake(const Scene& level, const std::vector<Need>& called)
{
    Baked bake;
    bake.scene = level;
    const bool lightmaps = need(called, "lightmaps").on;
    for (const Object& object : level.objects) bake.places.push_back({.page = lightmaps && object.isStatic ? 0 : -1});
    if (lightmaps) bake.lightmaps.resize(1);
    if (need(called, "directional").on) bake.lightmaps[0].direction.resize(1);
    if (need(called, "probes").on) bake.probes.probes.resize(1);
    if (need(called, "reflections").on) bake.reflections.resize(1);
    if (need(called, "lods").on) bake.lods = {{.primitives = {{LodLevel{}}}}};
    return bake;
}

Plan foreseenPlan(const Scene& level, const Settings& settings)
{
    const std::vector<Need> called = needs(level);
    const Baked bake = hollowBake(level, called);
    Plan foreseen = plan(called, evidenceOf(bake.scene, &bake, settings), {});
    for (PlannedEffect& effect : foreseen.effects) // no bake is there yet to hold none
        for (const char* product : {"lightmaps", "probes", "reflections", "lods"})
            if (effect.effect == product && !need(called, product).on) effect.reason = need(called, product).reason;
    return foreseen;
}
}
