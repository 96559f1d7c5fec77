#include "baker/reflection_places.hpp"
#include "baker/reflection_box.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/sampling.h"
#include <algorithm>

namespace afterglow
{
namespace
{
constexpr uint kSeed = 0x3177045u;       // whatever that of the bake
constexpr std::size_t kRays = 2048;      // mirrored, of the level
constexpr std::size_t kCandidates = 256; // places on their ways: boxes are fitted about them
constexpr int kLooks = 32;               // around a place
constexpr float kClear = 0.2f;           // of the way to a place from what mirrors: nothing is nearer
constexpr double kLeastGain = 0.005;     // of what all rays together are off by at most: a cubemap is not had for less

struct Candidate {
    ReflectionBox box{};
    std::optional<float> boxError; // of what it covers and sees
    std::vector<float> errors;     // of every ray, if it stood alone
};

// What the runtime's blend makes of a ray, as probes are added to it.
struct Blend {
    float weights = 0.0f, errors = 0.0f, covered = 0.0f;
    float error() const { return weights > 0.0f ? mix(kUncovered, errors / weights, covered) : kUncovered; }
    Blend with(vec2 influence, float error) const
    {
        return {weights + influence.y, errors + influence.y * error, max(covered, influence.x)};
    }
};

float nearestAbout(const World& world, vec3 place)
{
    float nearest = kRayFar;
    for (int i = 0; i < kLooks; i++) {
        Sampler random = makeSampler(0u, uint(i));
        nearest = min(nearest, world.closestHit({place, sampleUniformSphere(next2(random)), kRayFar}).distance);
    }
    return nearest;
}

// Places on the ways of mirrored rays, as many wherever as much is mirrored: in the open, for nothing stands in a ray's way.
std::vector<vec3> openPlaces(const World& world, const std::vector<MirrorRay>& rays)
{
    const float reach = distance(world.scene().lower, world.scene().upper);
    std::vector<vec3> places;
    for (std::size_t k = 0; k < rays.size() && places.size() < kCandidates; k++) {
        const std::size_t i = k % 2 == 0 ? k / 2 : rays.size() - 1 - k / 2; // from both ends: what moves comes last
        const float way = mix(0.1f, 0.5f, hashFloat(uint(i))) * min(rays[i].distance, reach);
        const vec3 place = rays[i].from + way * rays[i].direction;
        if (nearestAbout(world, place) > kClear * way) places.push_back(place);
    }
    return places;
}

Candidate judged(const ReflectionBox& box, const std::vector<MirrorRay>& rays, const std::vector<bool>& seen)
{
    Candidate candidate{box, {}, {}};
    double sum = 0.0, weights = 0.0;
    for (std::size_t i = 0; i < rays.size(); i++) {
        candidate.errors.push_back(lookupError(box, rays[i], seen[i]));
        const float weight = seen[i] ? rays[i].weight * reflectionInfluence(box, rays[i].from).x : 0.0f;
        sum += double(weight * candidate.errors.back()), weights += double(weight);
    }
    if (weights > 0.0) candidate.boxError = float(sum / weights);
    return candidate;
}

Candidate fittedAt(const World& world, vec3 place, const std::vector<MirrorRay>& rays)
{
    const std::vector<bool> seen = seenFrom(world, place, rays);
    return judged(fitBox(world, place, rays, seen), rays, seen);
}

// Probes that stand, and what the rays are off by as the runtime blends them.
struct Standing {
    const std::vector<MirrorRay>& rays;
    std::vector<Blend> blends = std::vector<Blend>(rays.size());
    PlacedReflections placed{.error = rays.empty() ? std::optional<float>() : kUncovered};

    Blend with(const Candidate& candidate, std::size_t i) const
    {
        return blends[i].with(reflectionInfluence(candidate.box, rays[i].from), candidate.errors[i]);
    }
    double errorWith(const Candidate& candidate) const
    {
        double sum = 0.0, weights = 0.0;
        for (std::size_t i = 0; i < rays.size(); i++)
            sum += double(rays[i].weight * with(candidate, i).error()), weights += double(rays[i].weight);
        return sum / weights;
    }
    void add(const Candidate& candidate, const std::string& name)
    {
        if (!rays.empty()) placed.error = float(errorWith(candidate));
        for (std::size_t i = 0; i < rays.size(); i++) blends[i] = with(candidate, i);
        placed.boxErrors.push_back(candidate.boxError);
        const ReflectionBox& box = candidate.box;
        placed.probes.push_back({.name = name, .position = box.position, .boxLower = box.lower, .boxUpper = box.upper});
    }
};

// One by one, each time that which betters most what the runtime will show.
void choose(Standing& standing, const std::vector<Candidate>& candidates, int most)
{
    while (int(standing.placed.probes.size()) < most) {
        const Candidate* best = nullptr;
        double least = double(*standing.placed.error) - kLeastGain;
        for (const Candidate& candidate : candidates)
            if (const double error = standing.errorWith(candidate); error < least) best = &candidate, least = error;
        if (!best) return;
        standing.add(*best, "automatic " + std::to_string(standing.placed.probes.size()));
    }
}
}

PlacedReflections placeReflections(const BakeContext& context, int most)
{
    const World& world = context.transport.world;
    const std::vector<MirrorRay> rays = mirrorRays(world, context.solids, kRays, kSeed);
    Standing standing{rays};
    for (const ReflectionProbeRequest& asked : world.scene().reflectionProbes) {
        const ReflectionBox box{asked.position, 1.0f, asked.position - asked.halfExtents, asked.position + asked.halfExtents};
        standing.add(judged(box, rays, seenFrom(world, box.position, rays)), asked.name);
    }
    if (standing.placed.probes.empty() && !rays.empty()) {
        const std::vector<vec3> places = openPlaces(world, rays);
        std::vector<Candidate> candidates(places.size());
        context.progress.begin("places", places.size(), "places");
        parallelFor(places.size(), context.threads, [&](std::size_t i) {
            candidates[i] = fittedAt(world, places[i], rays);
            context.progress.advance(1);
        });
        context.progress.end();
        choose(standing, candidates, most);
    }
    return std::move(standing.placed);
}
}
