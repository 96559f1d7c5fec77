// The light of the sky by wavelength: the CIE's D illuminants.
#pragma once
#include "shaders/spectrum.h"

namespace afterglow
{
struct Daylight {
    explicit Daylight(float temperature) : shares(shared::daylightShares(temperature)) {}

    // Relative spectral power, 1 at 560 nm; wavelength in nm.
    float at(float wavelength) const;

    shared::vec2 shares;
};
}
