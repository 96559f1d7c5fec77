#include "baker/tile.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace afterglow
{
void Tile::measure(const std::vector<TexelLight>& of)
{
    noise.texels = 0;
    noise.variance = squares = total = 0.0;
    double left = 0.0;
    for (const TexelLight& texel : of) {
        if (!texel.valid()) continue;
        const dvec3 mean = texel.mean(), difference = texel.halfDifference();
        noise.texels++;
        noise.variance += texel.variance();
        squares += dot(difference, difference) / 3.0;
        total += (mean.x + mean.y + mean.z) / 3.0;
        const double bright = double(luminance(vec3(difference)));
        left += bright * bright;
    }
    if (noise.variance > 0.0) share = std::min(left * double(noise.samples) / noise.variance, 1.0);
    if (noise.texels > 0) noise.variance /= double(noise.texels);
}

void ErrorSum::add(const Tile& tile)
{
    squares += tile.squares;
    told += grey(tile.told);
    total += tile.total;
    texels += double(tile.noise.texels);
}

double ErrorSum::relative() const { return total > 0.0 ? std::sqrt((squares + told) / texels) / (total / texels) : 0.0; }

std::vector<TexelLight> takeLight(const BakeContext& context, std::size_t number, Tile& tile)
{
    if (!tile.light.empty()) return std::exchange(tile.light, {});
    std::vector<TexelLight> light(kTileTexels);
    if (tile.noise.samples > 0) readBack(context, unitOf(number, tile.noise.samples, tile.layer), {bytesOf(std::span(light))});
    return light;
}

void giveLight(const BakeContext& context, Tile& tile, std::vector<TexelLight> light)
{
    tile.measure(light);
    if (!context.streamed) tile.light = std::move(light);
}
}
