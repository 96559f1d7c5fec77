// What a lightmap texel means, and how it is packed.
// A stored value is irradiance / pi, linear Rec.709: the radiance that a white Lambertian surface would send out. Multiply by the albedo
// and the surface is lit; multiply by pi and it is irradiance. Probes store the same quantity (shaders/probe.h).
#ifndef AFTERGLOW_LIGHTMAP_H
#define AFTERGLOW_LIGHTMAP_H
#include "shaders/constants.h"
SHARED_BEGIN

// E5B9G9R9: 9 bits a channel under one 5-bit exponent, bias 15. Value = mantissa * 2^(exponent - 24).
const float kSharedExponentMax = 65408.0f; // 511/512 * 2^16

// NaN and negatives become 0, anything above the largest value is the largest value. Error <= 2^-10 of the largest channel.
FN float sharedExponentInput(float x) { return x > 0.0f ? min(x, kSharedExponentMax) : 0.0f; }

FN uint encodeSharedExponent(vec3 rgb)
{
    vec3 c = vec3(sharedExponentInput(rgb.x), sharedExponentInput(rgb.y), sharedExponentInput(rgb.z));
    float largest = max(max(c.x, c.y), c.z);
    // Exponent of the largest channel from its bits: floor(log2) without a logarithm's rounding
    int exponent = max(int(floatBitsToUint(largest) >> 23u) - 127, -16) + 16;
    float scale = exp2(float(24 - exponent));
    if (floor(largest * scale + 0.5f) >= 512.0f) { // Rounded up to a tenth bit
        exponent += 1;
        scale *= 0.5f;
    }
    uint r = uint(c.x * scale + 0.5f), g = uint(c.y * scale + 0.5f), b = uint(c.z * scale + 0.5f);
    return r | (g << 9u) | (b << 18u) | (uint(exponent) << 27u);
}

FN vec3 decodeSharedExponent(uint packed_)
{
    float scale = exp2(float(int(packed_ >> 27u) - 24));
    return vec3(float(packed_ & 511u), float((packed_ >> 9u) & 511u), float((packed_ >> 18u) & 511u)) * scale;
}

// Finite and non-negative, in the range of a half: what may be stored as one.
FN vec3 clampToHalf(vec3 c)
{
    return vec3(c.x > 0.0f ? min(c.x, kHalfMax) : 0.0f, c.y > 0.0f ? min(c.y, kHalfMax) : 0.0f, c.z > 0.0f ? min(c.z, kHalfMax) : 0.0f);
}

// Binary16 of a value that clampToHalf has seen, to nearest, ties to even (what packHalf2x16 does with ties is the implementation's).
FN uint encodeHalf(float x)
{
    if (x < 6.103515625e-5f) return uint(roundEven(x * 16777216.0f)); // subnormal: units of 2^-24
    uint bits = floatBitsToUint(x);
    return (bits + 0xfffu + ((bits >> 13u) & 1u) - (112u << 23u)) >> 13u;
}
FN float decodeHalf(uint half_) { return unpackHalf2x16(half_ & 0xffffu).x; }

// ---- Directional
// Beside the flat value F, irradiance about the surface's own normal N, a texel may hold (d, a): light about a normal n that a normal map
// bends is F max(a + d.n, 0), order 1 in n. a + d.N = 1, so that what is not bent is what the flat value says; d is weighed by luminance;
// where F is 0 it stays 0, whichever way the normal turns. In spherical harmonics: F (a / Y00, d.y / Y1, d.z / Y1, d.x / Y1) of shBasis.
FN vec4 directionUnbent() { return vec4(0.0f, 0.0f, 0.0f, 1.0f); }
FN vec4 directionAbout(vec3 d, vec3 normal) { return vec4(d, 1.0f - dot(d, normal)); }
FN float directionShare(vec4 direction, vec3 normal) { return max(direction.w + dot(vec3(direction), normal), 0.0f); }

// d is fitted on the ring of normals that lean by 40 degrees: for each light alone, the mean around the ring and its slope across it are
// those of the truth. Of the angles tried it is the best from 0 to 45 degrees together: relative RMSE over skies of one to three lights of
// any size, at 10, 20, 30, 45 degrees: flat 9, 17, 24, 34 %; this 1.8, 2.8, 3.2, 4.7 %; the projection on the whole sphere 4.7, 8.6, 11, 14
// %.
const float kLeanCosine = 0.76604444f;
const float kLeanSine = 0.64278761f;
const float kLeastCosine = 1.0f / 64.0f; // of light that is told by its irradiance: the slope of what grazes has no bound

// d of light from unit `direction` alone, for each unit of what it gives to a surface of that unit normal.
FN vec3 directionOf(vec3 direction, vec3 normal)
{
    float c = dot(direction, normal);
    if (!(c > 0.0f)) return vec3(0.0f, 0.0f, 0.0f);
    vec3 across = direction - c * normal;
    float s = length(across);
    float up = c * kLeanCosine, out_ = s * kLeanSine; // irradiance on the ring: max(up + out cos(azimuth), 0)
    float slope = s, fall = c;                        // across the normal, and along it
    if (up < out_) {                                  // Part of the ring is turned away from the light
        float edge = acos(-up / out_), sine = sin(edge);
        float mean = (up * edge + out_ * sine) * kInvPi;
        float first = (up * sine + 0.5f * out_ * (edge + sine * cos(edge))) * (2.0f * kInvPi);
        slope = first / kLeanSine;
        fall = (c - mean) / (1.0f - kLeanCosine);
    }
    vec3 d = fall * normal;
    if (s > 0.0f) d += (slope / s) * across;
    return d / max(c, kLeastCosine);
}

FN vec3 irradianceToStored(vec3 irradiance) { return irradiance * kInvPi; }
FN vec3 storedToIrradiance(vec3 stored) { return stored * kPi; }

SHARED_END
#endif
