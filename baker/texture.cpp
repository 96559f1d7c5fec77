#include "baker/texture.hpp"
#include "engine/scene/texel_range.hpp"
#include "shaders/color.h"
#include "shaders/texture_ref.h"
#include <array>

namespace shared
{
static std::array<float, 256> decodeTable()
{
    std::array<float, 256> table;
    for (int i = 0; i < 256; i++) table[std::size_t(i)] = srgbDecode(float(i) / 255.0f);
    return table;
}

struct TexelSource {
    const std::uint8_t* texels; // RGBA8
};
static vec4 texelAt(TexelSource source, const TexelRange& t, int x, int y)
{
    static const std::array<float, 256> kDecode = decodeTable();
    const std::uint8_t* p = source.texels + (std::size_t(y) * std::size_t(t.size.x) + std::size_t(x)) * 4;
    if (t.srgb != 0) return vec4(kDecode[p[0]], kDecode[p[1]], kDecode[p[2]], float(p[3]) / 255.0f);
    return vec4(float(p[0]), float(p[1]), float(p[2]), float(p[3])) / 255.0f;
}
}
#include "shaders/texel_filter.h"

namespace afterglow
{
vec4 sampleTexture(const Scene& scene, const TextureRef& ref, vec2 uv0, vec2 uv1)
{
    if (ref.texture < 0) return vec4(1.0f);
    const SceneTexture& texture = scene.textures[std::size_t(ref.texture)];
    if (texture.image.width == 0) return vec4(1.0f);
    return filteredTexel({texture.image.pixels.data()}, texelRange(texture), textureUv(ref, uv0, uv1));
}
}
