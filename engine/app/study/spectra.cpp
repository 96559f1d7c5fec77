#include "engine/app/study/spectra.hpp"
#include "engine/app/study/studio.hpp"
#include "shaders/spectrum.h"
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kBands = 24, kHues[] = {450, 550, 620}; // columns of each hue, nm
constexpr int kMostBounces = 8;
constexpr int kWide = 4, kHigh = 12;                  // px of a patch
constexpr float kNarrowest = 10.0f, kWidest = 160.0f; // nm, of the standard deviation
constexpr float kLeast = 0.02f, kBand = 0.9f;         // what is reflected everywhere, and in the band besides
constexpr float kSun = 5778.0f;                       // K

// A patch of the chart: what reflects, how often, and what is known of both before any light is followed.
struct Patch {
    float hue, width; // nm
    int bounces;
    vec3 tint;    // the surface's channels: what it shows in equal energy
    float bright; // luminance that is left of the sunlight
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

// Row by row.
std::vector<Patch> patchesOfChart()
{
    const vec3 white = xyzToRec709(xyzOf([](float) { return 1.0f; }, kEveryWavelength));
    std::vector<Patch> patches;
    for (int bounces = 1; bounces <= kMostBounces; ++bounces)
        for (const int hue : kHues)
            for (int band = 0; band < kBands; ++band) {
                Patch p{float(hue), kNarrowest * std::pow(kWidest / kNarrowest, float(band) / (kBands - 1)), bounces, {}, {}};
                const vec3 shown = xyzToRec709(xyzOf([&](float nm) { return reflectance(p, nm); }, kEveryWavelength));
                p.tint = max(shown / white, vec3(0.0f)); // as a level's file can say it
                p.bright = luminance(bySpectrum(p, kEveryWavelength));
                patches.push_back(p);
            }
    return patches;
}

float meanOf(const Image& image)
{
    double sum = 0.0;
    for (const float value : image.pixels) sum += double(value);
    return float(sum / double(image.pixels.size()));
}
}

Image reflectedLight(const Studio& studio, double wavelengths)
{
    static const std::vector<Patch> patches = patchesOfChart();
    static const vec3 sunlight = xyzToRec709(blackbodyXyz(kSun));
    const float bright = meanOf(studio.picture.mean);
    const int columns = int(std::size(kHues)) * kBands;
    Image image(columns * kWide, kMostBounces * kHigh, 3);
    for (int i = 0; i < int(patches.size()); ++i) {
        const Patch& patch = patches[std::size_t(i)];
        const vec3 left = wavelengths == kThreeChannels ? byChannels(patch, sunlight) : bySpectrum(patch, wavelengths);
        for (int y = 0; y < kHigh; ++y)
            for (int x = 0; x < kWide; ++x)
                for (int c = 0; c < 3; ++c) image.at(i % columns * kWide + x, i / columns * kHigh + y)[c] = left[c] * bright / patch.bright;
    }
    return image;
}
}
