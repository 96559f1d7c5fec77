// Henyey-Greenstein: how a medium turns light. cosTheta is between PROPAGATION directions, +1 = straight on: with both directions pointing
// away from the point (wo to the eye, wi to the light) it is -dot(wi, wo). g > 0 scatters forward: fog is brighter toward the light.
// Based on: Henyey & Greenstein 1941; the forms below keep their digits for every g in [-1, 1] (1 - cos is passed where it is known).
#ifndef AFTERGLOW_PHASE_H
#define AFTERGLOW_PHASE_H
#include "shaders/constants.h"
SHARED_BEGIN

// 1/sr. (1 - g^2) / (4 pi (1 + g^2 - 2 g cos)^1.5), with 1 + g^2 - 2 g cos = (1-g)^2 + 2 g (1-cos). g = +-1 is a delta: 0 here.
FN float phaseHgFromOneMinusCos(float g, float oneMinusCos)
{
    // For g < 0, the same from the other side: p(-g, cos) = p(g, -cos)
    float a = abs(g);
    float k = g < 0.0f ? 2.0f - oneMinusCos : oneMinusCos;
    if (a >= 1.0f) return 0.0f;
    float q = (1.0f - a) * (1.0f - a) + 2.0f * a * max(k, 0.0f);
    return kInvFourPi * (1.0f - a) * (1.0f + a) / (q * sqrt(q));
}
FN float phaseHg(float g, float cosTheta) { return phaseHgFromOneMinusCos(g, 1.0f - cosTheta); }

// 1 - cos of the angle drawn by xi (xi -> 1 is forward): no division by g, no difference of near-equals.
FN float sampleHgOneMinusCos(float g, float xi)
{
    float a = abs(g);
    float u = g < 0.0f ? 1.0f - xi : xi;
    if (a >= 1.0f) return g < 0.0f ? 2.0f : 0.0f;
    float q = (1.0f - a) + 2.0f * a * u;
    float k = 2.0f * (1.0f - a) * (1.0f - a) * (1.0f - u) * (1.0f + a * u) / (q * q);
    k = min(k, 2.0f);
    return g < 0.0f ? 2.0f - k : k;
}
FN float sampleHgCos(float g, float xi) { return 1.0f - sampleHgOneMinusCos(g, xi); }

// New propagation direction in the local frame whose +z is the old one, and its density (= the phase function; for g = +-1 a delta, pdf 0).
struct PhaseSample {
    vec3 direction;
    float pdf;
};
FN PhaseSample samplePhaseHg(float g, vec2 u)
{
    float k = sampleHgOneMinusCos(g, u.x);
    float r = sqrt(max(k * (2.0f - k), 0.0f));
    PhaseSample s;
    s.direction = vec3(r * cos(kTwoPi * u.y), r * sin(kTwoPi * u.y), 1.0f - k);
    s.pdf = phaseHgFromOneMinusCos(g, k);
    return s;
}

// Probability of scattering into the forward half.
// (1-g^2)/(2g) (1/(1-g) - 1/r), r = sqrt(1+g^2). The bracket is (r - 1 + g) / ((1-g) r), and r - 1 = g^2 / (r + 1): g cancels.
FN float phaseHgForward(float g)
{
    float r = sqrt(1.0f + g * g);
    return 0.5f * (1.0f + g) * (1.0f + g / (r + 1.0f)) / r;
}

SHARED_END
#endif
