// Pictures in memory and on disk. A float image is scene-linear Rec.709; an 8-bit one is as displayed (or as a glTF texture stores it).
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace afterglow
{
// Row 0 is the top; pixel (x, y) channel c at (y * width + x) * channels + c.
struct Image {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<float> pixels;

    Image() = default;
    Image(int w, int h, int c) : width(w), height(h), channels(c), pixels(std::size_t(w) * h * c) {}
    float* at(int x, int y) { return &pixels[(std::size_t(y) * width + x) * channels]; }
    const float* at(int x, int y) const { return &pixels[(std::size_t(y) * width + x) * channels]; }
};

// `count` channels from `first` on.
Image channels(const Image& image, int first, int count);

struct Image8 {
    int width = 0;
    int height = 0;
    int channels = 4;
    std::vector<std::uint8_t> pixels;
};

// Reads .exr, .hdr (linear) or .png, .jpg (decoded from sRGB to linear), three channels (four when the file holds alpha).
// Throws Error when the file is missing, unreadable, or larger than 16384 on a side.
Image readImage(const std::filesystem::path& path);

// Writes .exr, scene-linear Rec.709, ZIP: half floats, or floats where a value leaves half's range; channels R G B (A), or Y for one.
// With the suffix .hdr: Radiance RGBE. NaN becomes 0 and Inf the largest value. Written to a temporary name and renamed.
void writeExr(const std::filesystem::path& path, const Image& image);

// Several images of one size in one .exr: channels `name.R name.G name.B (name.A)`, `name.Y` for one, or the letters of the layer; the
// layer "" has no prefix.
struct Layer {
    std::string name;
    Image image;
    bool exact = false;  // float rather than half: depth, ids
    std::string letters; // of its channels
};
void writeLayers(const std::filesystem::path& path, const std::vector<Layer>& layers);

// Writes an 8-bit .png of values that are display-referred already (0..1, sRGB encoded).
void writePng(const std::filesystem::path& path, const Image8& image);
std::vector<std::uint8_t> encodePng(const Image8& image);               // the same, in memory
std::vector<std::uint8_t> encodeJpeg(const Image8& image, int quality); // 1..100; above 90 colour is as fine as light

// Encodes linear 0..1 (clamped, NaN becomes 0) as sRGB 8 bit.
Image8 encodeSrgb(const Image& image);

// True when readImage decodes this file from sRGB (.png, .jpg): a displayed picture rather than scene-linear radiance.
bool isDisplayed(const std::filesystem::path& path);

// Decodes .png or .jpg from memory as 8-bit RGBA; what names the source in errors.
Image8 decodeImage8(const std::uint8_t* data, std::size_t size, const std::string& what);

// No picture is larger than this on a side: what a GPU can hold, and a bound before anything is allocated.
constexpr int kLargestSide = 16384;
}
