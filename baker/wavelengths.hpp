// A path of light of three wavelengths: the channels of shaders/transport.h carry these in place of red, green and blue. Materials and
// lights say Rec.709; what stands for it at a wavelength is written in shaders/spectrum.h. Light of colour (1, 1, 1) is D65.
// This work is based on: Wilkie et al. 2014 (hero wavelength spectral sampling).
#pragma once
#include "engine/scene/scene.hpp"
#include "shaders/light.h"
#include "shaders/ray.h"

namespace afterglow
{
struct Wavelengths {
    vec3 nm;
    mat3 reflectance; // of what reflects, absorbs or scatters: Rec.709 -> by wavelength
    mat3 power;       // of what shines, times D65
    mat3 seen;        // what a path found -> its share of the picture, Rec.709

    Surface of(Surface surface) const;
    Medium of(Medium medium) const;
    LightSample of(LightSample light) const;
    // The punctual lights of the scene: those that say ag_kelvin by their own spectrum. `lights` is filled anew for every path, and keeps
    // its memory.
    void lightsOf(const Scene& scene, std::vector<Light>& lights) const;
};

// What a path of those wavelengths meets; of Rec.709 where there are none.
template <class Thing>
Thing seenAt(const Wavelengths* at, const Thing& thing)
{
    return at ? at->of(thing) : thing;
}

// Three that lie a third of all light apart, u in [0, 1): each is as likely as it matters to the colour of white.
Wavelengths drawWavelengths(float u);

// The share of the picture of a path of white light that nothing dims; its mean over u is 1.
inline vec3 whiteSeen(const Wavelengths& w) { return w.seen * (w.power * vec3(1.0f)); }
}
