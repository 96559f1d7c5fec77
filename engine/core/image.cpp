#include "engine/core/image.hpp"
#include "engine/core/error.hpp"
#include "engine/core/exr.hpp"
#include "engine/core/file.hpp"
#include "engine/core/stb.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace afterglow
{
Image channels(const Image& image, int first, int count)
{
    Image part(image.width, image.height, count);
    for (std::size_t i = 0; i < std::size_t(image.width) * image.height; ++i)
        for (int c = 0; c < count; ++c) part.pixels[i * count + c] = image.pixels[i * image.channels + first + c];
    return part;
}

bool isDisplayed(const std::filesystem::path& path)
{
    const std::string kind = suffix(path);
    return kind == ".png" || kind == ".jpg" || kind == ".jpeg";
}

Image readImage(const std::filesystem::path& path)
{
    const std::string kind = suffix(path);
    if (kind == ".exr") {
        if (!std::filesystem::exists(path)) throw Error("cannot read " + path.string() + ": there is no such file; check the name");
        return readExr(path);
    }
    if (kind == ".hdr") return readHdr(readFile(path), path.string());
    if (!isDisplayed(path)) throw Error("cannot read " + path.string() + ": a picture is an .exr, .hdr, .png or .jpg");

    Image image = readDisplayed(readFile(path), path.string());
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (image.channels == 3 || i % 4 != 3) image.pixels[i] = shared::srgbDecode(image.pixels[i]); // alpha is linear already
    return image;
}

void writeExr(const std::filesystem::path& path, const Image& image)
{
    if (suffix(path) != ".hdr") return writeLayers(path, {{"", image}});
    Image finite = image;
    for (float& v : finite.pixels) v = std::isnan(v) ? 0.0f : std::min(std::max(v, 0.0f), 1e38f); // RGBE has neither sign nor Inf
    writeHdr(path, finite);
}

Image8 encodeSrgb(const Image& image)
{
    Image8 shown;
    shown.width = image.width, shown.height = image.height, shown.channels = image.channels;
    shown.pixels.resize(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const float value = image.pixels[i] > 0.0f ? std::min(image.pixels[i], 1.0f) : 0.0f; // the comparison sends NaN to 0
        const bool alpha = image.channels == 4 && i % 4 == 3;
        shown.pixels[i] = std::uint8_t((alpha ? value : shared::srgbEncode(value)) * 255.0f + 0.5f);
    }
    return shown;
}
}
