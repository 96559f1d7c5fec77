#include "baker/texture.hpp"
#include "shaders/color.h"
#include "shaders/texture_ref.h"
#include <array>
#include <cmath>

namespace afterglow
{
static std::array<float, 256> decodeTable()
{
    std::array<float, 256> table;
    for (int i = 0; i < 256; i++) table[std::size_t(i)] = srgbDecode(float(i) / 255.0f);
    return table;
}

static int wrapped(int i, int size, Wrap wrap)
{
    if (i >= 0 && i < size) return i;
    if (wrap == Wrap::clamp) return clamp(i, 0, size - 1);
    int period = wrap == Wrap::repeat ? size : 2 * size;
    i %= period;
    if (i < 0) i += period;
    return i < size ? i : period - 1 - i;
}

static vec4 texelAt(const SceneTexture& texture, int x, int y)
{
    static const std::array<float, 256> kDecode = decodeTable();
    x = wrapped(x, texture.image.width, texture.wrapU);
    y = wrapped(y, texture.image.height, texture.wrapV);
    const std::uint8_t* p = &texture.image.pixels[(std::size_t(y) * std::size_t(texture.image.width) + std::size_t(x)) * 4];
    if (texture.srgb) return vec4(kDecode[p[0]], kDecode[p[1]], kDecode[p[2]], float(p[3]) / 255.0f);
    return vec4(float(p[0]), float(p[1]), float(p[2]), float(p[3])) / 255.0f;
}

vec4 sampleTexture(const Scene& scene, const TextureRef& ref, vec2 uv0, vec2 uv1)
{
    if (ref.texture < 0) return vec4(1.0f);
    const SceneTexture& texture = scene.textures[std::size_t(ref.texture)];
    if (texture.image.width == 0) return vec4(1.0f);
    vec2 uv = textureUv(ref, uv0, uv1);
    if (texture.wrapU == Wrap::repeat) uv.x -= floor(uv.x); // spares texelAt a division
    if (texture.wrapV == Wrap::repeat) uv.y -= floor(uv.y);
    // Far-away texture coordinates lose their fraction in float: keep the integer part small enough for int
    vec2 p = clamp(uv, vec2(-1e4f), vec2(1e4f)) * vec2(float(texture.image.width), float(texture.image.height));
    if (texture.nearest) return texelAt(texture, int(std::floor(p.x)), int(std::floor(p.y)));
    p -= vec2(0.5f);
    vec2 cell = floor(p);
    vec2 f = p - cell;
    int x = int(cell.x), y = int(cell.y);
    vec4 upper = mix(texelAt(texture, x, y), texelAt(texture, x + 1, y), f.x);
    vec4 lower = mix(texelAt(texture, x, y + 1), texelAt(texture, x + 1, y + 1), f.x);
    return mix(upper, lower, f.y);
}
}
