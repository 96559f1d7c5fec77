#include "engine/core/exr.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/log.hpp"
#include "engine/core/scaffold.hpp"
#include <algorithm>
#include <cmath>
#include <half.h>
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <limits>

namespace afterglow
{
// The channels that make a picture: R G B (A), else the first layer's, else the only channel as grey.
static std::vector<std::string> pictureChannels(const Imf::ChannelList& channels, const std::string& path)
{
    std::string prefix;
    if (channels.findChannel("R") == nullptr) {
        for (auto it = channels.begin(); it != channels.end(); ++it) {
            const std::string name = it.name();
            if (name.size() > 2 && name.ends_with(".R")) {
                prefix = name.substr(0, name.size() - 1);
                break;
            }
        }
    }
    std::vector<std::string> names;
    for (const char* name : {"R", "G", "B", "A"})
        if (channels.findChannel(prefix + name) != nullptr) names.push_back(prefix + name);
    if (names.size() >= 3) return names;
    const auto first = channels.begin();
    if (names.empty() && first != channels.end()) return {first.name(), first.name(), first.name()};
    throw Error("cannot read " + path + ": it has no R, G and B channels");
}

static Image readPicture(const std::string& path)
{
    Imf::InputFile file(path.c_str());
    const Imath::Box2i shown = file.header().displayWindow(), stored = file.header().dataWindow();
    for (const Imath::Box2i& window : {shown, stored})
        if (window.max.x - std::int64_t(window.min.x) >= kLargestSide || window.max.y - std::int64_t(window.min.y) >= kLargestSide)
            throw Error("cannot read " + path + ": it is larger than " + std::to_string(kLargestSide) + " on a side");
    if (Imf::hasChromaticities(file.header())) {
        const Imf::Chromaticities& c = Imf::chromaticities(file.header());
        if (!c.red.equalWithAbsError({0.64f, 0.33f}, 1e-3f) || !c.green.equalWithAbsError({0.30f, 0.60f}, 1e-3f))
            warning(path + " says that its primaries are not Rec.709; they are read as if they were");
    }

    const std::vector<std::string> names = pictureChannels(file.header().channels(), path);
    const int count = int(names.size());
    Image data(stored.max.x - stored.min.x + 1, stored.max.y - stored.min.y + 1, count);
    const std::size_t pixel = sizeof(float) * std::size_t(count), row = pixel * std::size_t(data.width);
    Imf::FrameBuffer target;
    const bool grey = names.front() == names.back();
    for (int c = 0; c < (grey ? 1 : count); ++c) {
        // OpenEXR addresses pixels from the origin of the plane, not of the window.
        char* origin = reinterpret_cast<char*>(&data.pixels[std::size_t(c)]) - std::ptrdiff_t(stored.min.x) * std::ptrdiff_t(pixel) -
                       std::ptrdiff_t(stored.min.y) * std::ptrdiff_t(row);
        target.insert(names[std::size_t(c)], Imf::Slice(Imf::FLOAT, origin, pixel, row));
    }
    file.setFrameBuffer(target);
    file.readPixels(stored.min.y, stored.max.y);
    if (grey)
        for (std::size_t i = 0; i < data.pixels.size(); i += 3) data.pixels[i + 1] = data.pixels[i + 2] = data.pixels[i];
    if (stored == shown) return data;

    // A cropped render: what lies outside the stored window is black.
    Image image(shown.max.x - shown.min.x + 1, shown.max.y - shown.min.y + 1, count);
    for (int y = std::max(shown.min.y, stored.min.y); y <= std::min(shown.max.y, stored.max.y); ++y)
        for (int x = std::max(shown.min.x, stored.min.x); x <= std::min(shown.max.x, stored.max.x); ++x)
            std::copy_n(data.at(x - stored.min.x, y - stored.min.y), count, image.at(x - shown.min.x, y - shown.min.y));
    return image;
}

Image readExr(const std::filesystem::path& path)
{
    try {
        return readPicture(path.string());
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) { // Imf and Iex throw their own, all of them std::exception
        throw Error("cannot read " + path.string() + ": it is not a whole OpenEXR picture (" + failure.what() + ")");
    }
}

static std::string channelName(const Layer& layer, int channel)
{
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    const std::string usual = layer.image.channels < 3 ? "YA" : "RGBA";
    return prefix + (layer.letters.empty() ? usual : layer.letters)[std::size_t(channel)];
}

constexpr float kLargestHalf = 65504.0f;

// NaN becomes 0 and Inf the largest value that the channel holds.
static std::vector<float> finite(const Image& image, float largest)
{
    std::vector<float> values = image.pixels;
    for (float& v : values) v = std::isnan(v) ? 0.0f : std::clamp(v, -largest, largest);
    return values;
}

static bool fitsHalf(const Image& image)
{
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float v) { return !std::isfinite(v) || std::abs(v) <= kLargestHalf; });
}

constexpr int kRowsAtOnce = 128; // between two looks at Ctrl-C; a multiple of the 16 that ZIP packs together

void writeLayers(const std::filesystem::path& path, const std::vector<Layer>& layers)
{
    check(!layers.empty(), "a picture has at least one layer");
    const int width = layers[0].image.width, height = layers[0].image.height;
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::addChromaticities(header, Imf::Chromaticities()); // the default of OpenEXR is Rec.709 with D65

    Imf::FrameBuffer source;
    std::vector<std::vector<float>> floats;
    std::vector<std::vector<half>> halves;
    for (const Layer& layer : layers) {
        check(layer.image.width == width && layer.image.height == height, "layers of one file have one size");
        const std::size_t channels = std::size_t(layer.image.channels);
        const bool exact = layer.exact || !fitsHalf(layer.image);
        const std::vector<float>& values =
            floats.emplace_back(finite(layer.image, exact ? std::numeric_limits<float>::max() : kLargestHalf));
        const std::size_t size = exact ? sizeof(float) : sizeof(half);
        const char* base = reinterpret_cast<const char*>(values.data());
        if (!exact) base = reinterpret_cast<const char*>(halves.emplace_back(values.begin(), values.end()).data());
        const Imf::PixelType type = exact ? Imf::FLOAT : Imf::HALF;
        for (std::size_t c = 0; c < channels; ++c) {
            const std::string name = channelName(layer, int(c));
            header.channels().insert(name, Imf::Channel(type));
            source.insert(name,
                          Imf::Slice(type, const_cast<char*>(base + c * size), channels * size, channels * size * std::size_t(width)));
        }
    }

    Scaffold beside(path, Scaffold::Kind::file);
    try {
        Imf::OutputFile file(beside.path().c_str(), header);
        file.setFrameBuffer(source);
        for (int row = 0; row < height; row += kRowsAtOnce) {
            stopIfInterrupted();
            file.writePixels(std::min(kRowsAtOnce, height - row));
        }
    } catch (const Error&) {
        throw;
    } catch (const std::exception& failure) {
        throw Error("cannot write " + path.string() + ": " + beside.told(failure.what()));
    }
    beside.takePlace();
}
}
