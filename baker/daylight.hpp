// The light of the sky by wavelength: the CIE's D illuminants.
#pragma once

namespace afterglow
{
constexpr float kD65 = 6503.6f; // K: 6500 when hc/k was taken for 14380 um K, now 14388

// Relative spectral power, 1 at 560 nm; wavelength in nm, temperature in K, 4000 to 25000.
float daylight(float wavelength, float temperature);
}
