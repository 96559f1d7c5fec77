#include "engine/core/stb.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stb_image.h>
#include <stb_image_write.h>

namespace afterglow
{
struct Free {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};
template <class T>
using Pixels = std::unique_ptr<T[], Free>;

namespace
{
// Size and channels, refused before anything is decoded.
struct Shape {
    int width = 0, height = 0, channels = 0;
};
}

static Shape shapeOf(const std::uint8_t* data, std::size_t size, const std::string& what)
{
    Shape shape;
    if (size > std::size_t(std::numeric_limits<int>::max())) throw Error("cannot read " + what + ": it is larger than 2 GiB");
    if (stbi_info_from_memory(data, int(size), &shape.width, &shape.height, &shape.channels) == 0)
        throw Error("cannot read " + what + ": it is not a PNG, JPEG or HDR picture");
    if (shape.width > kLargestSide || shape.height > kLargestSide)
        throw Error("cannot read " + what + ": it is larger than " + std::to_string(kLargestSide) + " on a side");
    return shape;
}

template <class T>
static void demand(const Pixels<T>& pixels, const std::string& what)
{
    if (!pixels) throw Error("cannot read " + what + ": it is damaged (" + stbi_failure_reason() + ")");
}

Image readHdr(const std::vector<std::uint8_t>& bytes, const std::string& what)
{
    const Shape shape = shapeOf(bytes.data(), bytes.size(), what);
    int width, height, stored;
    const Pixels<float> pixels(stbi_loadf_from_memory(bytes.data(), int(bytes.size()), &width, &height, &stored, 3));
    demand(pixels, what);
    Image image(shape.width, shape.height, 3);
    std::copy_n(pixels.get(), image.pixels.size(), image.pixels.data());
    return image;
}

Image readDisplayed(const std::vector<std::uint8_t>& bytes, const std::string& what)
{
    const Shape shape = shapeOf(bytes.data(), bytes.size(), what);
    const bool alpha = shape.channels == 2 || shape.channels == 4;
    Image image(shape.width, shape.height, alpha ? 4 : 3);
    int width, height, stored;
    if (stbi_is_16_bit_from_memory(bytes.data(), int(bytes.size())) != 0) {
        const Pixels<stbi_us> pixels(stbi_load_16_from_memory(bytes.data(), int(bytes.size()), &width, &height, &stored, image.channels));
        demand(pixels, what);
        std::transform(pixels.get(), pixels.get() + image.pixels.size(), image.pixels.begin(),
                       [](stbi_us v) { return float(v) / 65535.0f; });
    } else {
        const Pixels<stbi_uc> pixels(stbi_load_from_memory(bytes.data(), int(bytes.size()), &width, &height, &stored, image.channels));
        demand(pixels, what);
        std::transform(pixels.get(), pixels.get() + image.pixels.size(), image.pixels.begin(), [](stbi_uc v) { return float(v) / 255.0f; });
    }
    return image;
}

Image8 decodeImage8(const std::uint8_t* data, std::size_t size, const std::string& what)
{
    const Shape shape = shapeOf(data, size, what);
    int width, height, stored;
    const Pixels<stbi_uc> pixels(stbi_load_from_memory(data, int(size), &width, &height, &stored, 4));
    demand(pixels, what);
    Image8 image;
    image.width = shape.width, image.height = shape.height, image.channels = 4;
    image.pixels.assign(pixels.get(), pixels.get() + std::size_t(shape.width) * std::size_t(shape.height) * 4);
    return image;
}

static void append(void* bytes, void* data, int size)
{
    const auto* first = static_cast<const std::uint8_t*>(data);
    auto* all = static_cast<std::vector<std::uint8_t>*>(bytes);
    all->insert(all->end(), first, first + size);
}

// `write`: one of stb's, told of whatever its format asks for.
template <class Write>
static std::vector<std::uint8_t> encoded(const Image8& image, const char* format, Write write)
{
    check(image.pixels.size() == std::size_t(image.width) * std::size_t(image.height) * std::size_t(image.channels), "an image is whole");
    std::vector<std::uint8_t> bytes;
    if (write(bytes) == 0)
        throw Error("cannot encode a picture of " + std::to_string(image.width) + " x " + std::to_string(image.height) + " as " + format);
    return bytes;
}

std::vector<std::uint8_t> encodePng(const Image8& image)
{
    return encoded(image, "PNG", [&](auto& bytes) {
        return stbi_write_png_to_func(append, &bytes, image.width, image.height, image.channels, image.pixels.data(),
                                      image.width * image.channels);
    });
}

std::vector<std::uint8_t> encodeJpeg(const Image8& image, int quality)
{
    return encoded(image, "JPEG", [&](auto& bytes) {
        return stbi_write_jpg_to_func(append, &bytes, image.width, image.height, image.channels, image.pixels.data(), quality);
    });
}

void writePng(const std::filesystem::path& path, const Image8& image)
{
    const std::vector<std::uint8_t> bytes = encodePng(image);
    writeFile(path, bytes.data(), bytes.size());
}

void writeHdr(const std::filesystem::path& path, const Image& image)
{
    std::vector<std::uint8_t> bytes;
    if (stbi_write_hdr_to_func(append, &bytes, image.width, image.height, image.channels, image.pixels.data()) == 0)
        throw Error("cannot write " + path.string() + ": the picture cannot be encoded as HDR");
    writeFile(path, bytes.data(), bytes.size());
}
}
