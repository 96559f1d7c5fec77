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

// What emitterLight() asks of emitters, side by side.
struct EmitterLanes {
    Lanes3 corner, edge1, edge2, normal, emission;
    Lanes density;
    alignas(64) uint flags[kPacket];

    void set(int i, const Emitter& of)
    {
        corner.set(i, of.corner), edge1.set(i, of.edge1), edge2.set(i, of.edge2), normal.set(i, of.normal), emission.set(i, of.emission);
        density[i] = of.density, flags[i] = of.flags;
    }
    Emitter operator[](int i) const { return {corner[i], density[i], edge1[i], 0.0f, edge2[i], 0u, normal[i], flags[i], emission[i], 0u}; }
};

void Emitters::sample(const Lanes3& from, const DrawLanes& draws, LightLanes& light) const
{
    const EmitterSet all{world_, table_};
    uint chosen[kPacket];
    for (int i = 0; i < kPacket; i++) chosen[i] = chooseEmitter(all, draws.choice[i]);
    EmitterLanes emitters;
    for (int i = 0; i < kPacket; i++) emitters.set(i, table_.emitters[chosen[i]]);
    Lanes3 weights;
    for (int i = 0; i < kPacket; i++) weights.set(i, sampleTriangle(vec2(draws.x[i], draws.y[i])));
    for (int i = 0; i < kPacket; i++) light.set(i, emitterLight(emitters[i], weights[i], from[i]));
    for (int i = 0; i < kPacket; i++)
        if (light.pdf[i] > 0.0f && (emitters.flags[i] & kEmitterVaries) != 0u)
            light.radiance.set(i, emissionAt(all, table_.emitters[chosen[i]].triangle, vec2(weights.y[i], weights.z[i])));
}

float Emitters::pdf(const Ray& ray, const Hit& hit, const Surface& surface) const
{
    return emittersPdf({world_, table_}, ray, hit, surface);
}
}
