// The level's textures: which image a material's slot shows, how it wraps and turns, and what stands in for one that cannot be read.
#pragma once
#include "engine/scene/document.hpp"
#include "engine/scene/scene.hpp"
#include <array>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace afterglow
{
enum class Slot { baseColor, metallicRoughness, normal, emissive, transmission };

// What stands in for an image that cannot be read, as the file would store it: rough dielectric grey that emits nothing and lets nothing
// through. It cannot make light, and it is seen to be wrong.
std::array<std::uint8_t, 4> neutralTexel(Slot slot);

// No texture: the factor stands alone.
TextureRef noTexture();

// Textures asked for so far: what they show and how -> index in the level. Exporters repeat the same image under many texture numbers.
struct TextureKey {
    std::optional<std::size_t> image, sampler; // in the file
    Slot slot;
    auto operator<=>(const TextureKey&) const = default;
};
using TextureIndex = std::map<TextureKey, int>;

// What a glTF textureInfo means. Adds the texture to the level, not yet decoded, when it is asked for the first time in that slot.
TextureRef readTextureRef(const Document& document, const nlohmann::json& info, Slot slot, TextureIndex& known, Scene& scene);

// Decodes them all, on all cores. One that is missing, broken or too large becomes one neutral texel of its slot, counted and told.
void decodeTextures(const Document& document, const TextureIndex& known, Scene& scene);
}
