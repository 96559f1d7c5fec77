#include "baker/emitters.hpp"

namespace shared
{
struct EmitterSet {
    const afterglow::World& world;
    const afterglow::EmitterTable& table;
};
FN uint emitterCount(EmitterSet all) { return uint(all.table.emitters.size()); }
FN const Emitter& emitterAt(EmitterSet all, uint i) { return all.table.emitters[i]; }
FN float emitterDensity(EmitterSet all, uint triangle) { return all.table.density[triangle]; }
FN vec3 emissionAt(EmitterSet all, uint triangle, vec2 barycentric) { return all.world.emissionAt(triangle, barycentric); }
}

#include "shaders/emitter_choice.h"

namespace afterglow
{
Emitters::Emitters(const World& world) : world_(world), table_(emitterTable(world.scene(), world.placed(), world.order())) {}

Emitters::Point Emitters::point(float choice, vec2 u) const
{
    const Emitter& emitter = table_.emitters[chooseEmitter({world_, table_}, choice)];
    vec3 b = sampleTriangle(u);
    return {emitter.corner + b.y * emitter.edge1 + b.z * emitter.edge2, emitter.normal};
}

LightSample Emitters::sample(vec3 from, float choice, vec2 u) const { return sampleEmitters({world_, table_}, from, choice, u); }

float Emitters::pdf(const Ray& ray, const Hit& hit, const Surface& surface) const
{
    return emittersPdf({world_, table_}, ray, hit, surface);
}
}
