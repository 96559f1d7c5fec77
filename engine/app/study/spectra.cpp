#include "engine/app/study/spectra.hpp"
#include "engine/app/study/studio.hpp"
#include "shaders/spectrum.h"
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

namespace afterglow
{
namespace
{
constexpr int kBands = 24, kHues[] = {450, 550, 620}; // columns of each hue, nm
constexpr int kMostBounces = 8;
constexpr int kWide = 288, kHigh = 96;                // px of the chart
constexpr float kNarrowest = 10.0f, kWidest = 160.0f; // nm, of the standard deviation
constexpr float kLeast = 0.02f, kBand = 0.9f;         // what is reflected everywhere, and in the band besides
constexpr float kSun = 5778.0f;                       // K

// A patch of the chart: what reflects, how often, and what is known of both before any light is followed.
struct Patch {
    float hue, width; // nm
    int bounces;
    vec3 tint{0.0f};     // the surface's channels: what it shows in equal energy
    float bright = 0.0f; // luminance that is left of the sunlight
};

float reflectance(const Patch& patch, float nm)
{
    const float away = (nm - patch.hue) / patch.width;
    return kLeast + kBand * std::exp(-0.5f * away * away);
}

// XYZ of what is left of light of a spectrum, by so many wavelengths.
template <class Power>
vec3 xyzOf(Power power, double wavelengths)
{
    const double step = double(kDeepRed - kViolet) / wavelengths;
    vec3 sum(0.0f);
    for (int i = 0; i < int(wavelengths); ++i) {
        const float nm = float(double(kViolet) + (i + 0.5) * step);
        sum += colorMatching(nm) * (power(nm) * float(step));
    }
    return sum;
}

// Rec.709 of sunlight after its bounces.
vec3 bySpectrum(const Patch& patch, double wavelengths)
{
    const auto left = [&](float nm) { return planck(nm, kSun) * std::pow(reflectance(patch, nm), float(patch.bounces)); };
    return xyzToRec709(xyzOf(left, wavelengths));
}
vec3 byChannels(const Patch& patch, vec3 sunlight)
{
    vec3 color = sunlight;
    for (int i = 0; i < patch.bounces; ++i) color *= patch.tint;
    return color;
}

float meanOf(const Image& image)
{
    double sum = 0.0;
    for (const float value : image.pixels) sum += double(value);
    return float(sum / double(image.pixels.size()));
}

// Known from the second time on, so that only light is timed.
const Patch& patchOf(int hue, float width, int bounces)
{
    static const vec3 white = xyzToRec709(xyzOf([](float) { return 1.0f; }, kEveryWavelength));
    static std::map<std::tuple<int, float, int>, Patch> known;
    const auto [place, isNew] = known.try_emplace({hue, width, bounces}, Patch{float(hue), width, bounces});
    Patch& patch = place->second;
    if (!isNew) return patch;
    const vec3 shown = xyzToRec709(xyzOf([&](float nm) { return reflectance(patch, nm); }, kEveryWavelength));
    patch.tint = max(shown / white, vec3(0.0f)); // as a level's file can say it
    patch.bright = luminance(bySpectrum(patch, kEveryWavelength));
    return patch;
}

// Row by row, so many bounces each, and in a row every hue in bands of each width.
Image chartOf(const Studio& studio, double wavelengths, const std::vector<int>& rows, const std::vector<float>& widths)
{
    static const vec3 sunlight = xyzToRec709(blackbodyXyz(kSun));
    const float bright = meanOf(studio.picture.mean);
    Image image(kWide, kHigh, 3);
    const int columns = int(std::size(kHues) * widths.size()), wide = kWide / columns, high = kHigh / int(rows.size());
    for (int row = 0; row < int(rows.size()); ++row)
        for (int column = 0; column < columns; ++column) {
            const std::size_t hue = std::size_t(column) / widths.size(), width = std::size_t(column) % widths.size();
            const Patch& patch = patchOf(kHues[hue], widths[width], rows[std::size_t(row)]);
            const vec3 left = wavelengths == kThreeChannels ? byChannels(patch, sunlight) : bySpectrum(patch, wavelengths);
            const vec3 adapted = left * (bright / patch.bright);
            for (int y = row * high; y < (row + 1) * high; ++y)
                for (int x = column * wide; x < (column + 1) * wide; ++x)
                    for (int c = 0; c < 3; ++c) image.at(x, y)[c] = adapted[c];
        }
    return image;
}

std::vector<float> everyWidth()
{
    std::vector<float> widths;
    for (int band = 0; band < kBands; ++band) widths.push_back(kNarrowest * std::pow(kWidest / kNarrowest, float(band) / (kBands - 1)));
    return widths;
}

std::vector<int> everyBounce()
{
    std::vector<int> bounces(kMostBounces);
    std::iota(bounces.begin(), bounces.end(), 1);
    return bounces;
}
}

Image reflectedLight(const Studio& studio, double wavelengths) { return chartOf(studio, wavelengths, everyBounce(), everyWidth()); }

Image reflectedBy(const Studio& studio, double wavelengths, int bounces) { return chartOf(studio, wavelengths, {bounces}, everyWidth()); }

Image reflectedOff(const Studio& studio, double wavelengths, double nanometres)
{
    return chartOf(studio, wavelengths, everyBounce(), {float(nanometres)});
}
}
