// From the unit square to shapes and back: every sampler with its density and its inverse, and how two densities share one estimate.
// Local frames have +z up. Based on: Shirley & Chiu 1997 (disc), Heitz 2019 (triangle), Veach 1997 (multiple importance sampling).
#ifndef AFTERGLOW_SAMPLING_H
#define AFTERGLOW_SAMPLING_H
#include "shaders/constants.h"
SHARED_BEGIN

// Unit disc, concentric: squares become rings. Density 1/pi.
FN vec2 sampleDisc(vec2 u)
{
    vec2 p = u * 2.0f - 1.0f;
    if (p.x == 0.0f && p.y == 0.0f) return vec2(0.0f, 0.0f);
    bool wide = abs(p.x) > abs(p.y);
    float r = wide ? p.x : p.y;
    float angle = wide ? (kPi / 4.0f) * (p.y / p.x) : kHalfPi - (kPi / 4.0f) * (p.x / p.y);
    return vec2(cos(angle), sin(angle)) * r;
}
FN vec2 sampleDiscInverse(vec2 p)
{
    float r = length(p);
    if (r == 0.0f) return vec2(0.5f, 0.5f);
    float angle = atan(p.y, p.x); // (-pi, pi]
    if (angle < -kPi / 4.0f) angle += kTwoPi;
    vec2 q;
    if (angle < kPi / 4.0f)
        q = vec2(r, angle * r / (kPi / 4.0f));
    else if (angle < 3.0f * kPi / 4.0f)
        q = vec2(-(angle - kHalfPi) * r / (kPi / 4.0f), r);
    else if (angle < 5.0f * kPi / 4.0f)
        q = vec2(-r, -(angle - kPi) * r / (kPi / 4.0f));
    else
        q = vec2((angle - 3.0f * kHalfPi) * r / (kPi / 4.0f), -r);
    return clamp(q * 0.5f + 0.5f, 0.0f, 1.0f);
}

// Hemisphere with density cos / pi. The cosine is at least 2^-13: the horizon itself carries no light and would divide by zero.
FN vec3 sampleCosineHemisphere(vec2 u)
{
    vec2 p = sampleDisc(u);
    return vec3(p, sqrt(max(1.0f - p.x * p.x - p.y * p.y, 1.4901161e-8f)));
}
FN float cosineHemispherePdf(float cosTheta) { return max(cosTheta, 0.0f) * kInvPi; }
FN vec2 sampleCosineHemisphereInverse(vec3 d) { return sampleDiscInverse(vec2(d.x, d.y)); }

// A direction by 1 - cos theta and the azimuth in turns; exact near the pole, where cos theta itself has no digits left.
FN vec3 directionFromOneMinusCos(float oneMinusCos, float turns)
{
    float r = sqrt(max(oneMinusCos * (2.0f - oneMinusCos), 0.0f));
    return vec3(r * cos(kTwoPi * turns), r * sin(kTwoPi * turns), 1.0f - oneMinusCos);
}
FN float turnsOf(vec3 d)
{
    float turns = atan(d.y, d.x) * kInvTwoPi;
    return turns < 0.0f ? turns + 1.0f : turns;
}

FN vec3 sampleUniformHemisphere(vec2 u) { return directionFromOneMinusCos(1.0f - u.x, u.y); }
FN float uniformHemispherePdf() { return kInvTwoPi; }
FN vec2 sampleUniformHemisphereInverse(vec3 d) { return vec2(d.z, turnsOf(d)); }

FN vec3 sampleUniformSphere(vec2 u) { return directionFromOneMinusCos(2.0f * u.x, u.y); }
FN float uniformSpherePdf() { return kInvFourPi; }
FN vec2 sampleUniformSphereInverse(vec3 d) { return vec2(0.5f - 0.5f * d.z, turnsOf(d)); }

// 1 - cos of the angle whose sine is given (angle <= pi/2), without the cancellation.
FN float oneMinusCosFromSin(float sine)
{
    float s2 = min(sine * sine, 1.0f);
    return s2 / (1.0f + sqrt(1.0f - s2));
}

// Cone about +z, uniform in solid angle; the half-angle is given by its sine (at most a hemisphere), the form that lights have: R / d.
FN vec3 sampleUniformCone(float sinHalfAngle, vec2 u) { return directionFromOneMinusCos(u.x * oneMinusCosFromSin(sinHalfAngle), u.y); }
FN float coneSolidAngle(float sinHalfAngle) { return kTwoPi * oneMinusCosFromSin(sinHalfAngle); }
FN float uniformConePdf(float sinHalfAngle) { return 1.0f / coneSolidAngle(sinHalfAngle); }
FN vec2 sampleUniformConeInverse(float sinHalfAngle, vec3 d)
{
    float sine2 = d.x * d.x + d.y * d.y;
    float oneMinusCos = d.z > 0.0f ? sine2 / (1.0f + d.z) : 1.0f - d.z;
    return vec2(oneMinusCos / oneMinusCosFromSin(sinHalfAngle), turnsOf(d));
}

// Barycentric weights of vertices 0, 1, 2, uniform over a triangle, folded with low distortion. Density 1 / area.
FN vec3 sampleTriangle(vec2 u)
{
    bool first = u.x < u.y;
    float low = 0.5f * min(u.x, u.y), high = max(u.x, u.y) - low;
    float b0 = first ? low : high, b1 = first ? high : low;
    return vec3(b0, b1, 1.0f - b0 - b1);
}
FN vec2 sampleTriangleInverse(vec3 b)
{
    if (b.x > b.y) return vec2(b.x + b.y, 2.0f * b.y);
    return vec2(2.0f * b.x, b.y + b.x);
}
// Density per area -> density per solid angle, seen from `distance` with the emitter's cosine. 0 edge-on.
FN float areaPdfToSolidAngle(float pdfArea, float distanceSquared, float cosEmitter)
{
    return cosEmitter > 0.0f ? pdfArea * distanceSquared / cosEmitter : 0.0f;
}

// Multiple importance sampling, one sample of each density: the weight of the sample drawn from `pdf`. The ratio is what is squared, so
// that neither 1e20 nor a denormal overflows: the two weights of a pair always sum to 1. A density of 0 has weight 0.
FN float balanceHeuristic(float pdf, float other)
{
    if (!(pdf > 0.0f)) return 0.0f;
    return pdf >= other ? 1.0f / (1.0f + other / pdf) : (pdf / other) / (1.0f + pdf / other);
}
FN float powerHeuristic(float pdf, float other)
{
    float r = min(pdf, other) / max(pdf, other);
    float weight = (pdf >= other ? 1.0f : r * r) / (1.0f + r * r);
    return pdf > 0.0f ? weight : 0.0f;
}

SHARED_END
#endif
