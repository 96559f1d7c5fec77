#include "engine/baked/lightmap.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
constexpr std::uint8_t kBakedCode = 255, kDilatedCode = 128;

static Ktx2 pageTexture(const Lightmap& page, Ktx2Format format)
{
    Ktx2 texture;
    texture.format = format;
    texture.width = page.width;
    texture.height = page.height;
    texture.keys["KTXorientation"] = "rd"; // rows from the top, as glTF's v grows downwards
    return texture;
}

Ktx2 lightmapTexture(const Lightmap& page)
{
    std::vector<vec4> texels;
    for (const vec3& texel : page.texels) texels.push_back(vec4(max(texel, vec3(0.0f)), 1.0f));
    Ktx2 texture = pageTexture(page, holding(texels, Ktx2Format::rgb9e5));
    texture.keys["ag_quantity"] = "irradiance / pi, linear Rec.709";
    texture.levels = {packTexels(texels, texture.format)};
    return texture;
}

Ktx2 directionTexture(const Lightmap& page)
{
    Ktx2 texture = pageTexture(page, holding(page.direction, Ktx2Format::rgba16f));
    texture.keys["ag_quantity"] = "irradiance about a bent normal n: times max(a + dot(rgb, n), 0), world space";
    texture.levels = {packTexels(page.direction, texture.format)};
    return texture;
}

Ktx2 coverageTexture(const Lightmap& page)
{
    Ktx2 texture = pageTexture(page, Ktx2Format::r8);
    texture.keys["ag_quantity"] = "coverage: 255 baked, 128 dilated, 0 outside every chart";
    std::vector<std::uint8_t>& codes = texture.levels.emplace_back();
    for (std::uint8_t valid : page.valid) codes.push_back(valid == 1 ? kBakedCode : valid == 2 ? kDilatedCode : 0);
    return texture;
}

static bool isPage(const Ktx2& texture) { return texture.depth == 0 && texture.layers == 0 && texture.faces == 1; }

Lightmap readLightmap(const Ktx2& texture, const Ktx2& coverage, const std::string& what)
{
    const auto demand = [&](bool holds, const char* sentence) {
        if (!holds) throw Error("cannot read " + what + ": " + sentence);
    };
    demand(isPage(texture) &&
               (texture.format == Ktx2Format::rgb9e5 || texture.format == Ktx2Format::rgba16f || texture.format == Ktx2Format::rgba32f),
           "it is not a lightmap page");
    demand(isPage(coverage) && coverage.format == Ktx2Format::r8 && coverage.width == texture.width && coverage.height == texture.height,
           "its coverage has another size or format");

    Lightmap page;
    page.width = texture.width;
    page.height = texture.height;
    for (const vec4& texel : unpackTexels(texture.levels[0], texture.format)) page.texels.push_back(vec3(texel));
    for (std::uint8_t code : coverage.levels[0]) {
        demand(code == kBakedCode || code == kDilatedCode || code == 0, "its coverage holds a code that means nothing");
        page.valid.push_back(code == kBakedCode ? 1 : code == kDilatedCode ? 2 : 0);
    }
    return page;
}

void readDirection(const Ktx2& texture, Lightmap& page, const std::string& what)
{
    if (!isPage(texture) || texture.width != page.width || texture.height != page.height ||
        (texture.format != Ktx2Format::rgba16f && texture.format != Ktx2Format::rgba32f))
        throw Error("cannot read " + what + ": it is not the direction of its lightmap page; bake the level again");
    page.direction = unpackTexels(texture.levels[0], texture.format);
}

Image lightmapImage(const Lightmap& page)
{
    Image image(page.width, page.height, 3);
    for (std::size_t i = 0; i < page.texels.size(); ++i)
        for (int c = 0; c < 3; ++c) image.pixels[3 * i + std::size_t(c)] = page.texels[i][c];
    return image;
}
}
