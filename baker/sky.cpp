#include "baker/sky.hpp"

namespace shared
{
struct SkyMap {
    ivec2 size;
    vec3 tint;
    float rotation;
    uint sampled;
    const afterglow::Image& image;
    const afterglow::SkyTable& table;
};
FN vec3 skyTexel(const SkyMap& sky, ivec2 texel)
{
    const float* p = sky.image.at(texel.x, texel.y);
    return vec3(p[0], p[1], p[2]);
}
FN float skyRow(const SkyMap& sky, int y) { return sky.table.rows[std::size_t(y)]; }
FN float skyColumn(const SkyMap& sky, ivec2 texel)
{
    return sky.table.columns[std::size_t(texel.y) * std::size_t(sky.size.x) + std::size_t(texel.x)];
}
}

#include "shaders/sky_light.h"

namespace afterglow
{
static SkyMap mapOf(const Sky& sky, const SkyTable& table)
{
    return {{sky.image.width, sky.image.height}, sky.radiance, sky.rotation, uint(!table.rows.empty()), sky.image, table};
}

SkyLight::SkyLight(const Sky& sky) : sky_(sky), table_(skyTable(sky.image)) {}

vec3 SkyLight::radiance(vec3 direction) const { return skyMapRadiance(mapOf(sky_, table_), direction); }

LightSample SkyLight::sample(vec2 u) const { return sampleSkyMap(mapOf(sky_, table_), u); }

float SkyLight::pdf(vec3 direction) const { return skyMapPdf(mapOf(sky_, table_), direction); }
}
