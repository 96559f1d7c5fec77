#include "baker/waves.hpp"
#include "engine/core/interrupt.hpp"

namespace afterglow
{
// Closest hits of the living. Rays that were scattered go everywhere: a packet of them is as fast as one after the other, or faster.
static void extend(Tracer tracer, bool coherent, Wave& wave)
{
    Ray rays[kPacket];
    Hit hits[kPacket];
    uint asked[kPacket];
    int filled = 0;
    for (std::size_t i = 0; i <= wave.living.size(); i++) {
        if (i < wave.living.size() && wave.hits[wave.living[i]].distance < 0.0f) {
            asked[filled] = wave.living[i];
            rays[filled++] = wave.paths[wave.living[i]].ray;
        }
        if (filled == 0 || (filled < kPacket && i < wave.living.size())) continue;
        tracer.transport->world.closestHits(rays, hits, filled, coherent);
        tracer.rays->closestPacked += std::uint64_t(filled);
        for (int k = 0; k < filled; k++) wave.hits[asked[k]] = hits[k];
        filled = 0;
    }
}

// Asks for all shadow rays, and adds what arrives.
static void connect(Tracer tracer, Wave& wave)
{
    Ray rays[kPacket];
    vec3 passed[kPacket];
    const std::vector<ShadowRays::Sent>& sent = wave.shadows.sent;
    for (std::size_t begin = 0; begin < sent.size(); begin += kPacket) {
        const int count = int(std::min(sent.size() - begin, std::size_t(kPacket)));
        for (int k = 0; k < count; k++) rays[k] = sent[begin + std::size_t(k)].ray;
        tracer.transport->world.transmittances(rays, passed, count);
        for (int k = 0; k < count; k++) {
            const ShadowRays::Sent& one = sent[begin + std::size_t(k)];
            wave.paths[one.path].radiance += one.carried * passed[k];
        }
    }
    tracer.rays->shadowPacked += sent.size();
    wave.shadows.sent.clear();
}

void followAll(Tracer first, Tracer tracer, Wave& wave)
{
    first.later = tracer.later = &wave.shadows;
    for (bool begun = false; !wave.living.empty(); begun = true) {
        stopIfInterrupted();
        extend(tracer, !begun, wave);
        std::size_t kept = 0;
        for (uint i : wave.living) {
            wave.shadows.path = i;
            if (advance(first, tracer, wave.hits[i], wave.paths[i])) wave.living[kept++] = i;
            wave.hits[i] = unknownHit();
        }
        wave.living.resize(kept);
        connect(tracer, wave);
    }
}
}
