// The rays that a bake is made of, drawn on a level's surfaces before anything is timed.
#pragma once
#include "baker/tracer.hpp"

namespace afterglow
{

class RayKinds
{
public:
    explicit RayKinds(const LightTransport& transport);

    // From a random point of the surfaces, in a cosine-distributed direction: the later bounces of a path.
    std::vector<Ray> incoherent(std::size_t count) const;

    // The same, in packets: points in a square of lightmap texels and one direction, the first bounce of neighbours.
    std::vector<Ray> packets(std::size_t count) const;

    // From a random point to a light that it faces, chosen as the bake chooses; to another random point where no light is found.
    std::vector<Ray> shadow(std::size_t count) const;

private:
    Surface point(Sampler& random) const; // uniform over the area
    Ray towardsLight(const Surface& from, Sampler& random) const;
    const LightTransport& transport_;
    std::vector<double> area_; // cumulative over the world's triangles, m2
    float texel_;              // m
};
}
