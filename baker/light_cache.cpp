#include "baker/light_cache.hpp"
#include "baker/fireflies.hpp"
#include "baker/tile_light.hpp"
#include "baker/world.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/color.h"
#include "shaders/lightmap.h"

namespace afterglow
{
// Texels, within which light is not looked up: there the mean over a texel is not what a ray meets. Experiment, still life at 12 texels a
// metre and 768 paths, stated to be 0.50 % off: 0.65 % with 0, 0.50 % with 1, 2 and 4, at 0.95 of the speed.
static constexpr float kNear = 1.0f;

LightCache::LightCache(const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, bool directional) : places_(places)
{
    for (ivec2 size : pageSizes) {
        const std::size_t texels = std::size_t(size.x) * std::size_t(size.y);
        pages_.push_back({.size = size,
                          .texels = std::vector(texels, std::array{vec3(-1.0f), vec3(-1.0f)}),
                          .direction = std::vector(directional ? texels : 0, std::array{directionUnbent(), directionUnbent()}),
                          .position = std::vector<vec3>(texels),
                          .normal = std::vector<vec3>(texels)});
    }
}

void LightCache::keep(std::uint32_t page, ivec2 texel, const TexelLight& light)
{
    Page& into = pages_[page];
    if (texel.x >= into.size.x || texel.y >= into.size.y || light.points == 0) return;
    const std::size_t number = into.numberOf(texel);
    for (int half = 0; half < 2; half++) {
        if (light.count[half] == 0 || light.told[half] == 0) continue;
        into.texels[number][std::size_t(half)] =
            max(vec3(light.half[half] / double(light.count[half])) + light.more[half] / float(light.told[half]), vec3(0.0f));
        if (!into.direction.empty()) into.direction[number][std::size_t(half)] = light.direction(half);
    }
    into.position[number] = vec3(light.position / double(light.points)), into.normal[number] = light.ownNormal();
}

bool LightCache::Page::isKnown(ivec2 at) const
{
    return at == clamp(at, ivec2(0), size - 1) && texels[numberOf(at)][0].x >= 0.0f && texels[numberOf(at)][1].x >= 0.0f;
}

// Rays are asked only where the light of some neighbour is quite another: noise alone makes it so, too.
bool LightCache::Page::isParted(ivec2 at, const Sight& sight) const
{
    const auto light = [&](ivec2 p) { return luminance(texels[numberOf(p)][0] + texels[numberOf(p)][1]); };
    bool differs = false, seesAll = true;
    const auto eachNeighbour = [&](const auto& visit) {
        for (int step = 0; step < 9; step++)
            if (const ivec2 there = at + ivec2(step % 3, step / 3) - 1; there != at && isKnown(there)) visit(there);
    };
    eachNeighbour([&](ivec2 there) { differs = differs || max(light(at), light(there)) > kMuch * min(light(at), light(there)); });
    if (!differs) return false;
    const vec3 from = position[numberOf(at)];
    eachNeighbour([&](ivec2 there) {
        const vec3 to = position[numberOf(there)];
        seesAll = seesAll && (from == to || sight(from, to, kSightHeight * distance(from, to) * normal[numberOf(at)]));
    });
    return !seesAll;
}

// What one path in many has found here: whoever looked it up would carry it on as if it were there for all, and brighten all that sees it.
std::vector<std::size_t> LightCache::Page::rare() const
{
    Lightmap light{size.x, size.y, std::vector<vec3>(texels.size()), std::vector<std::uint8_t>(texels.size(), 0), {}};
    TexelGuides guides{{}, {}, std::vector<vec3>(texels.size()), std::vector<float>(texels.size())};
    for (int y = 0; y < size.y; y++)
        for (int x = 0; x < size.x; x++) {
            if (!isKnown(ivec2(x, y))) continue;
            const std::size_t i = numberOf(ivec2(x, y));
            light.texels[i] = 0.5f * (texels[i][0] + texels[i][1]), guides.half[i] = 0.5f * (texels[i][0] - texels[i][1]);
            light.valid[i] = 1;
        }
    return rareTexels(light, guides, islandsOf(light, [](std::size_t, std::size_t) { return true; }));
}

void LightCache::settle(const Sight& sight, int threads)
{
    for (Page& page : pages_) {
        for (const std::size_t texel : page.rare()) page.texels[texel].fill(vec3(-1.0f));
        std::vector<std::uint8_t> parted(page.texels.size(), 0);
        parallelFor(std::size_t(page.size.y), threads, [&](std::size_t y) {
            for (int x = 0; x < page.size.x; x++)
                if (const ivec2 at(x, int(y)); page.isKnown(at)) parted[page.numberOf(at)] = page.isParted(at, sight) ? 1 : 0;
        });
        for (std::size_t i = 0; i < parted.size(); i++)
            if (parted[i] != 0) page.texels[i].fill(vec3(-1.0f));
        page.position = {}, page.normal = {};
    }
}

// Of a triangle.
static float texelsPerSquareMetre(const World& world, uint triangle, const LightmapPlace& place, ivec2 size)
{
    const std::vector<Vertex>& v = world.vertices();
    const uint* corner = world.triangles()[triangle].vertex;
    const vec2 side = v[corner[1]].uv1 - v[corner[0]].uv1, other = v[corner[2]].uv1 - v[corner[0]].uv1;
    const vec2 texels = place.scale * vec2(size);
    return std::abs((side.x * other.y - side.y * other.x) * texels.x * texels.y) / length(world.front(triangle));
}

bool LightCache::find(const World& world, const Hit& hit, vec3 normal, int half, vec3& light) const
{
    const World::Triangle& t = world.triangles()[hit.triangle];
    const LightmapPlace& place = places_[t.object];
    if (place.page < 0) return false;
    const Page& page = pages_[std::size_t(place.page)];
    const bool bent = world.scene().materials[t.material].normalTexture.texture >= 0;
    if (bent && page.direction.empty()) return false;
    if (!(hit.distance * hit.distance * texelsPerSquareMetre(world, hit.triangle, place, page.size) > kNear * kNear)) return false;
    const std::vector<Vertex>& v = world.vertices();
    const float b = hit.barycentric.x, c = hit.barycentric.y, a = 1.0f - b - c;
    const vec2 uv = a * v[t.vertex[0]].uv1 + b * v[t.vertex[1]].uv1 + c * v[t.vertex[2]].uv1;
    const ivec2 texel = clamp(ivec2((uv * place.scale + place.offset) * vec2(page.size)), ivec2(0), page.size - 1);
    light = page.texels[page.numberOf(texel)][std::size_t(half)];
    if (!(light.x >= 0.0f)) return false;
    if (bent) light *= directionShare(page.direction[page.numberOf(texel)][std::size_t(half)], normal);
    return true;
}
}
