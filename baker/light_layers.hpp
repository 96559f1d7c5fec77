// The light of a level, taken apart (--light-layers): lightmaps of each lamp, each material and medium that glows, and the sky are traced
// for themselves, white and of strength 1. What reaches a texel goes as a light's strength in each of the three channels, so that a
// lightmap is the sum of its layers, each times its strength and colour: after a change of those alone they are summed anew, and no path is
// traced. Each layer has random numbers of its own, so that their errors are independent: where each is within a relative error, so is
// their sum, whatever the strengths.
#pragma once
#include "baker/context.hpp"

namespace afterglow
{
// All that shines in a level, and how bright.
struct Glow {
    std::vector<Light> lights;
    std::vector<vec3> materials, media; // emission of each
    vec3 sky{0.0f};
};
Glow glowOf(const Scene& scene);
void setGlow(Scene& scene, const Glow& glow); // whoever traces meanwhile meets it at once
Glow white(Glow glow);                        // what shines at all, with strength 1

struct LightLayer {
    std::string name;
    Glow glow;
    vec3 strength{1.0f}; // by which its light is multiplied
    LayerKey key;
    std::uint32_t seed = 0;
};

constexpr std::size_t kMostLayers = 32; // each takes as long as a bake of all light: what is beyond them shines together

struct LightLayers {
    Scene& scene;
    bool directAll = false;
    std::vector<LightLayer> all;
};

// What shines on the level's static objects, apart; lights of one shape and place are one layer. One that is dark where nothing does.
std::vector<LightLayer> lightLayers(const Scene& scene, bool directAll);

// Those that a bake does not ignore, and of those the ones whose direct part it holds.
struct BakedLights {
    std::vector<Light> seen, direct;
};
BakedLights bakedLights(const std::vector<Light>& lights, bool directAll);

// A stage for each layer of a bake, while nothing else shines; once, with strength 1, for a bake whose light is one.
using LayerStage = std::function<void(BakeContext& layer, vec3 strength)>;
void eachLayer(BakeContext& whole, const LayerStage& stage);
std::size_t layerCount(const BakeContext& whole);
}
