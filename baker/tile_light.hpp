// The light of a lightmap tile: what the paths of its texels have brought so far.
#pragma once
#include "baker/lightmap.hpp"
#include "baker/texels.hpp"
#include <vector>

namespace afterglow
{
// A texel, in two independent halves of its samples.
struct TexelLight {
    dvec3 half[2] = {dvec3(0.0), dvec3(0.0)}; // sums of irradiance / pi
    double squares = 0.0;                     // of luminance
    int count[2] = {0, 0};
    dvec3 position{0.0}, normal{0.0}; // sums over `points`
    vec3 turn[2] = {vec3(0.0f),
                    vec3(0.0f)}; // sums of what directionOf() says of the paths, times their luminance; of few rounds: floats hold them
    int points = 0;
    int told[2] = {0, 0};                    // paths of each half that told of the surface's base
    vec3 more[2] = {vec3(0.0f), vec3(0.0f)}; // and what falls on that beyond the irradiance / pi (light_cache.hpp): sums over them

    // False: the texel has no points (openPoints() of texels.hpp): the dilation fills it.
    bool valid() const;
    dvec3 mean() const { return (half[0] + half[1]) / double(count[0] + count[1]); }
    vec3 ownNormal() const;       // unit, world
    vec4 direction() const;       // (shaders/lightmap.h)
    vec4 direction(int of) const; // what a half alone says
    double variance() const;      // of a path's luminance
    dvec3 halfDifference() const; // its square is what the square of the mean's error is expected to be; 0 with a single half

    // Adds what another layer of light brought to the same points by random numbers of its own, times its strength; variance and direction
    // go as its luminance does. As if it had as many paths as this has.
    void add(const TexelLight& layer, vec3 strength);
};

// Traces samples [first, last) of every texel of a tile, and adds what they bring; where it comes from, too, if context.directional.
void sampleTile(BakeContext& context, const TilePoints& texels, uint tileSeed, int first, int last, std::vector<TexelLight>& light,
                RayCount& rays);
}
