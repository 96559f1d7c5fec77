#include "baker/wavelengths.hpp"
#include "baker/daylight.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kAnywhere = 0.2; // share that is drawn evenly: what is no daylight may shine anywhere

// The spectrum in bins of 1 nm, each by what it matters.
struct Bins {
    Daylight daylight{kD65};
    dvec3 white{0.0};            // what the eye makes of D65, Rec.709: shown as (1, 1, 1)
    std::vector<double> density; // of the choice, 1/nm
    std::vector<double> below;   // chance of a wavelength below the bin

    Bins()
    {
        std::vector<dvec3> seen;
        for (float nm = kViolet + 0.5f; nm < kDeepRed; nm += 1.0f) {
            seen.push_back(dvec3(xyzToRec709(colorMatching(nm)) * daylight.at(nm)));
            white += seen.back();
        }
        double whole = 0.0;
        for (dvec3 color : seen) density.push_back(dot(abs(color / white), dvec3(1.0))), whole += density.back();
        double sum = 0.0;
        for (double& d : density) {
            d = (1.0 - kAnywhere) * d / whole + kAnywhere / double(density.size());
            below.push_back(sum);
            sum += d;
        }
    }
};

const Bins& bins()
{
    static const Bins made;
    return made;
}
}

Wavelengths drawWavelengths(float u)
{
    Wavelengths w;
    for (int c = 0; c < 3; c++) {
        const double place = std::fmod(double(u) + c / 3.0, 1.0);
        const std::size_t bin = std::size_t(std::upper_bound(bins().below.begin(), bins().below.end(), place) - bins().below.begin()) - 1;
        const double density = bins().density[bin];
        const float nm = kViolet + float(double(bin) + std::min((place - bins().below[bin]) / density, 1.0));
        const vec3 primaries = primarySpectra(nm), shining = primaries * bins().daylight.at(nm);
        for (int primary = 0; primary < 3; primary++) {
            w.reflectance[primary][c] = primaries[primary];
            w.power[primary][c] = shining[primary];
        }
        w.seen[c] = vec3(dvec3(xyzToRec709(colorMatching(nm))) / (bins().white * (3.0 * density)));
        w.nm[c] = nm;
    }
    return w;
}

Surface Wavelengths::of(Surface surface) const
{
    for (vec3 Bsdf::*color : {&Bsdf::diffuse, &Bsdf::metal, &Bsdf::layer, &Bsdf::transmission})
        surface.bsdf.*color = reflectance * (surface.bsdf.*color);
    surface.absorption = reflectance * surface.absorption;
    surface.emission = power * surface.emission;
    surface.unlit = power * surface.unlit;
    return surface;
}

Medium Wavelengths::of(Medium medium) const
{
    medium.scattering = reflectance * medium.scattering;
    medium.absorption = reflectance * medium.absorption;
    medium.emission = power * medium.emission;
    return medium;
}

LightSample Wavelengths::of(LightSample light) const
{
    light.radiance = power * light.radiance;
    return light;
}

void Wavelengths::lightsOf(const Scene& scene, std::vector<Light>& lights) const
{
    lights = scene.lights;
    for (Light& light : lights) light.intensity = power * light.intensity;
    const float unit = luminance(vec3(bins().white)); // of luminance, as D65 has it
    for (const auto& [index, hot] : scene.hotLights)
        for (int c = 0; c < 3; c++) lights[index].intensity[c] = (reflectance * hot.tint)[c] * planck(nm[c], hot.temperature) * unit;
}
}
