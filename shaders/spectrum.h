// Spectra: what the eye and a hot body do by wavelength, and which smooth spectrum stands for a colour of three channels.
// Wavelengths in nm, temperatures in K.
// Based on: Wyman, Sloan & Shirley 2013 (multi-lobe fit of the CIE 1931 2-degree functions), SI 2019 (exact h, c, k).
#ifndef AFTERGLOW_SPECTRUM_H
#define AFTERGLOW_SPECTRUM_H
#include "shaders/color.h"
#include "shaders/constants.h"
SHARED_BEGIN

const float kViolet = 360.0f; // nm, between which there is light
const float kDeepRed = 830.0f;
const float kLuminousEfficacy = 683.0f;         // lm/W at 540 THz
const float kStefanBoltzmann = 5.670374419e-8f; // W m^-2 K^-4
const float kPlanckFirst = 1.191042972e8f;      // 2 h c^2, W m^-2 sr^-1 um^4
const float kPlanckSecond = 14387.76877f;       // h c / k, um K
const float kWienWavelength = 2.897771955e6f;   // nm K: peak per wavelength
const float kWienFrequency = 5.099442e6f;       // nm K: peak per frequency, as a wavelength

FN float cmfLobe(float wavelength, float centre, float below, float above)
{
    float t = (wavelength - centre) * (wavelength < centre ? below : above);
    return exp(-0.5f * t * t);
}
// xbar, ybar, zbar. The fit strays from the table by at most 0.0138, 0.0073, 0.0221.
FN vec3 colorMatching(float wavelength)
{
    float x = 0.362f * cmfLobe(wavelength, 442.0f, 0.0624f, 0.0374f) + 1.056f * cmfLobe(wavelength, 599.8f, 0.0264f, 0.0323f) -
              0.065f * cmfLobe(wavelength, 501.1f, 0.0490f, 0.0382f);
    float y = 0.821f * cmfLobe(wavelength, 568.8f, 0.0213f, 0.0247f) + 0.286f * cmfLobe(wavelength, 530.9f, 0.0613f, 0.0322f);
    float z = 1.217f * cmfLobe(wavelength, 437.0f, 0.0845f, 0.0278f) + 0.681f * cmfLobe(wavelength, 459.0f, 0.0385f, 0.0725f);
    return vec3(x, y, z);
}

// Spectral radiance of a black body, W m^-2 sr^-1 per micrometre (SI units would overflow at short wavelengths). 0 at wavelength 0 and
// where exp overflows.
FN float planck(float wavelength, float temperature)
{
    float um = wavelength * 1e-3f;
    if (!(um > 0.0f && temperature > 0.0f)) return 0.0f;
    float x = kPlanckSecond / (um * temperature);
    if (x > 87.0f) return 0.0f;
    // exp(x) - 1, by the series where it cancels
    float below = x < 0.01f ? x * (1.0f + 0.5f * x * (1.0f + x * (1.0f / 3.0f))) : exp(x) - 1.0f;
    float um2 = um * um;
    return kPlanckFirst / (um2 * um2 * um * below);
}
FN float blackbodyExitance(float temperature)
{
    float t2 = temperature * temperature;
    return kStefanBoltzmann * t2 * t2;
}

// x and y of XYZ; of black, those of equal energy.
FN vec2 chromaticity(vec3 xyz)
{
    float sum = xyz.x + xyz.y + xyz.z;
    return sum > 0.0f ? vec2(xyz.x, xyz.y) / sum : vec2(1.0f / 3.0f);
}

// A colour that no display of Rec.709 shows has a channel below 0: the way to the grey of its luminance, as far as the gamut's border.
FN vec3 intoGamut(vec3 color)
{
    float y = luminance(color), least = min(min(color.x, color.y), color.z);
    if (!(y > 0.0f)) return vec3(0.0f);
    return least < 0.0f ? (color - vec3(least)) * (y / (y - least)) : color; // mix(grey, color, y / (y - least)), 0 exactly
}

// XYZ of a black body: planck() by the matching functions, nm.
FN vec3 blackbodyXyz(float temperature)
{
    const float kStep = 1.0f; // nm: twice that is 1e-5 off in the blue of a bulb
    vec3 xyz = vec3(0.0f);
    for (float w = kViolet + 0.5f * kStep; w < kDeepRed; w += kStep) xyz += kStep * planck(w, temperature) * colorMatching(w);
    return xyz;
}
// Its colour, linear Rec.709 of luminance 1; below 1909 K that lies outside the gamut, its blue below 0.
FN vec3 blackbodyColor(float temperature)
{
    vec3 xyz = blackbodyXyz(temperature);
    return xyz.y > 0.0f ? xyzToRec709(xyz / xyz.y) : vec3(0.0f);
}

const float kD65 = 6503.6f; // K: 6500 when hc/k was taken for 14380 um K, now 14388

// Of daylight at a temperature, 4000 to 25000 K: how much of its two main deviations, blue to yellow and green to purple, are added to its
// mean (CIE 15). They make its chromaticity; to three decimals, as the CIE's tables are made.
FN vec2 daylightShares(float temperature)
{
    float k = 1e3f / temperature;
    float x = temperature <= 7000.0f ? 0.244063f + k * (0.09911f + k * (2.9678f - k * 4.6070f))
                                     : 0.237040f + k * (0.24748f + k * (1.9018f - k * 2.0064f));
    float y = -0.275f + x * (2.870f - 3.000f * x);
    float whole = 0.0241f + 0.2562f * x - 0.7341f * y;
    vec2 shares = vec2(-1.3515f - 1.7703f * x + 5.9114f * y, 0.0300f - 31.4424f * x + 30.0717f * y) / whole;
    return floor(shares * 1e3f + vec2(0.5f)) * 1e-3f;
}

// Three smooth spectra between 0 and 1 that stand for red, green and blue, and add up to 1 at every wavelength. Lit by D65, each has
// exactly the colour of its primary, so that r x + g y + b z has the colour (r, g, b), lies between its smallest and its largest channel,
// and is flat where they are equal. Shares of three exponentials of parabolas, of which one may be 1: six numbers, six equations, one
// solution.
FN vec3 primarySpectra(float wavelength)
{
    float t = (wavelength - 560.0f) * 0.01f;
    float red = -4.410273f + t * (9.607316f + t * 13.66995f), blue = -4.042284f + t * (0.775212f + t * 8.786431f);
    float most = max(max(red, blue), 0.0f); // no exponential overflows
    vec3 shares = vec3(exp(red - most), exp(-most), exp(blue - most));
    return shares / (shares.x + shares.y + shares.z);
}

SHARED_END
#endif
