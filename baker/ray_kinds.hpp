// The rays that a bake is made of, drawn on a level's surfaces before anything is timed.
#pragma once
#include "baker/area.hpp"
#include "baker/tracer.hpp"

namespace afterglow
{
class RayKinds
{
public:
    explicit RayKinds(const LightTransport& transport);

    // From a random point of the surfaces, in a cosine-distributed direction: the later bounces of a path.
    std::vector<Ray> incoherent(std::size_t count) const;

    // In packets of kPacket: from points in a square of lightmap texels, each in a direction of its own, and to a point that one of these
    // met (or along it, where it met nothing): the first bounces of neighbours, and what they ask of one another's (baker/gather.hpp).
    std::vector<Ray> packets(std::size_t count) const;
    std::vector<Ray> shadowPackets(std::size_t count) const;

    // From a random point to a light that it faces, chosen as the bake chooses; to another random point where no light is found.
    std::vector<Ray> shadow(std::size_t count) const;

private:
    Surface point(Sampler& random) const; // uniform over the area
    std::vector<Surface> square(Sampler& random) const;
    Ray towardsLight(const Surface& from, Sampler& random) const;
    const LightTransport& transport_;
    Area area_;
    float texel_; // m
};
}
