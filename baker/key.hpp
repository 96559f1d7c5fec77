// What a bake's result depends on, as one text: two bakes of the same key are the same bits.
#pragma once
#include "baker/atlas.hpp"
#include "baker/baker.hpp"
#include "baker/light_layers.hpp"

namespace afterglow
{
// SHA-256, over the level's bytes and those of every file that it names, every option but those that only say how the work is done, and the
// program. Throws Error when the level cannot be read.
std::string bakeKey(const std::filesystem::path& level, const BakeOptions& options);

// The same of a layer of light: the level where nothing shines, its texels and solids, and of the options those that its lightmaps follow;
// and the layer's own light. A family is of all levels that differ by nothing but where their objects stand, if --incremental asks.
class LayerKeys
{
public:
    LayerKeys(const Scene& scene, const Atlas& atlas, const Solids& solids, const BakeOptions& resolved, bool directional);
    LayerKey of(const Glow& glow) const;

private:
    const Scene& scene_;
    std::string level_, family_;
};

// The random numbers of a layer follow from its light alone: another light has others, the same always the same.
std::uint32_t layerSeed(const Glow& glow, std::uint32_t seed);

// Whether the bake of that key stands there already, with every file as it was written.
bool holdsBake(const std::filesystem::path& directory, const std::string& key);
}
