// The light of lightmaps on their way. Once some paths have told what falls on the level's texels, later ones need not be traced to their
// end: where they meet a matte surface, its texel says what its base sends on, and costs no ray. Paths go on by the surface's other lobes.
// What that is off by: a texel's light stands for all of its area, and the cache has the noise of the paths that filled it, which all who
// look it up share. What one path in many has found is not looked up, or it would glow on all that sees it: paths go on there, and of light
// as rare as that, later bounces miss a part. Of light that rays find, other than that of light samples, a surface's layer lets in its mean
// over the hemisphere. Each half of a bake looks up what that half alone has found, so that halves stay independent and what they differ by,
// the stated error, holds the cache's noise, too. Where a normal map bends the surface, the light is what a directional lightmap would say.
// This work is based on: Reichert 1992 (final gathering), Ward et al. 1988 (irradiance caching).
#pragma once
#include "baker/islands.hpp"
#include "baker/lanes.hpp"
#include "engine/baked/baked.hpp"
#include "shaders/ray.h"
#include <array>

namespace afterglow
{
class World;
struct TexelLight;

class LightCache
{
public:
    // Of lightmaps with these places, which outlive it; knows nothing yet. `directional`: it is to know what normal maps do, too.
    LightCache(const std::vector<LightmapPlace>& places, const std::vector<ivec2>& pageSizes, bool directional);

    // What a texel's paths have told; from any thread, of each texel once.
    void keep(std::uint32_t page, ivec2 texel, const TexelLight& light);

    // Once all is kept: forgets texels beside others of quite another light that do not see one another. A wall parts them, and what a
    // texel holds may be of its other side. And those that hold rare light (fireflies.hpp): paths that meet them are traced on.
    void settle(const Sight& sight, int threads);

    // Light / pi about the surface's `normal`, unit, that falls on its base where a ray hit it, times the base's gain; false: it is not
    // known.
    bool find(const World& world, const Hit& hit, vec3 normal, int half, vec3& light) const;

private:
    const std::vector<LightmapPlace>& places_;
    struct Page {
        ivec2 size;
        std::vector<std::array<vec3, 2>> texels;    // of each half; negative: not known
        std::vector<std::array<vec4, 2>> direction; // of shaders/lightmap.h; empty: it is not to know
        std::vector<vec3> position, normal;         // until it has settled; world, m
        bool isKnown(ivec2 at) const;
        std::size_t numberOf(ivec2 at) const { return std::size_t(at.y) * std::size_t(size.x) + std::size_t(at.x); }
        bool isParted(ivec2 at, const Sight& sight) const;
        std::vector<std::size_t> rare() const; // texels
    };
    std::vector<Page> pages_;
};

// Paths of every texel that fill the cache for the rest of `samples`; 0: too few to be worth it.
constexpr int pilotOf(int samples) { return samples < 4 ? 0 : max(samples / 16 * 2, 2); }
constexpr double kPilotCost = 2.3; // times a later path, which ends sooner: 1.5 to 3.1 in six levels

// The same where it is known how many rays follow the first one of a path that is traced to its end: each costs as much as .6 of a later path,
// up to where most end in glass and metal, which no cache answers. To look whether a texel is open costs as much as ten later paths, less where
// those are dear, shared by its `paths`. Off by 20 % at most in the six levels.
inline double pilotCost(double raysAfter, int paths) { return min(1.3 + 0.6 * raysAfter, 2.8) + 10.0 / (1.0 + raysAfter) / paths; }
}
