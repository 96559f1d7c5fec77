// Light through a homogeneous medium: what is left, what is added, where it is met. Lengths in m, coefficients in 1/m.
// Every 1 - exp(-x) is computed without cancellation: a thin medium dims by 1e-12 rather than by nothing.
#ifndef AFTERGLOW_MEDIUM_H
#define AFTERGLOW_MEDIUM_H
#include "shaders/constants.h"
#include "shaders/scene.h"
SHARED_BEGIN

// 1 - exp(-x), x >= 0; relative error below 2e-7 everywhere. Below 0.1 the series x (1 - x/2 (1 - x/3 (...))), whose first dropped term is
// x^6/5040.
FN float opacityOf(float x)
{
    if (!(x > 0.0f)) return 0.0f;
    if (x > 0.1f) return 1.0f - exp(-x);
    return x *
           (1.0f - x * (1.0f / 2.0f) *
                       (1.0f - x * (1.0f / 3.0f) * (1.0f - x * (1.0f / 4.0f) * (1.0f - x * (1.0f / 5.0f) * (1.0f - x * (1.0f / 6.0f))))));
}
FN vec3 opacityOf(vec3 x) { return vec3(opacityOf(x.x), opacityOf(x.y), opacityOf(x.z)); }

// (1 - exp(-x)) / x, 1 at 0; any sign.
FN float meanTransmittance(float x)
{
    if (x < 0.0f) return exp(-x) * (x > -1e-30f ? 1.0f : opacityOf(-x) / -x);
    return x > 1e-30f ? opacityOf(x) / x : 1.0f;
}

// exp(-sigma d); sigma = 0 is no medium even at infinite distance.
FN float transmittance(float sigmaT, float distance_) { return sigmaT > 0.0f ? exp(-sigmaT * distance_) : 1.0f; }
FN vec3 transmittance(vec3 sigmaT, float distance_)
{
    return vec3(transmittance(sigmaT.x, distance_), transmittance(sigmaT.y, distance_), transmittance(sigmaT.z, distance_));
}

// The stretch of a ray that lies in something.
struct Span {
    float begin; // m along the ray; begin >= end: empty
    float end;
};
FN float spanLength(Span s) { return max(s.end - s.begin, 0.0f); }

// Where the ray o + t d, 0 <= t <= limit, runs inside the box. Bounds may be infinite. Slabs that the ray runs along neither cut nor admit
// it: a start exactly on a face counts as inside.
FN Span boxSpan(vec3 o, vec3 d, vec3 lower, vec3 upper, float limit)
{
    Span s = Span(0.0f, limit);
    for (int a = 0; a < 3; ++a) {
        if (d[a] == 0.0f) {
            if (o[a] < lower[a] || o[a] > upper[a]) return Span(0.0f, 0.0f);
            continue;
        }
        float t0 = (lower[a] - o[a]) / d[a], t1 = (upper[a] - o[a]) / d[a];
        s.begin = max(s.begin, min(t0, t1));
        s.end = min(s.end, max(t0, t1));
    }
    return s;
}

// What is left of a span on the inner side of a plane (xyz unit normal outwards, w its distance); on the plane counts as inside.
FN Span planeSpan(Span s, vec3 o, vec3 d, vec4 plane)
{
    float outside = dot(vec3(plane), o) - plane.w, along = dot(vec3(plane), d);
    if (along == 0.0f) return Span(s.begin, outside > 0.0f ? s.begin : s.end);
    float t = -outside / along;
    return along > 0.0f ? Span(s.begin, min(s.end, t)) : Span(max(s.begin, t), s.end);
}

FN vec3 extinctionOf(Medium m) { return m.scattering + m.absorption; }

// What one step of length d adds, for a source that is constant along it: scattering * integral of exp(-sigma x) over the step, so that a
// march of any step count gives (sigma_s/sigma_t)(1 - exp(-sigma_t D)) for a constant source (Hillaire 2015). Multiply by phase * light.
FN float stepInscatter(float sigmaS, float sigmaT, float d) { return sigmaS * d * meanTransmittance(sigmaT * d); }
FN vec3 stepInscatter(vec3 sigmaS, vec3 sigmaT, float d)
{
    return vec3(stepInscatter(sigmaS.x, sigmaT.x, d), stepInscatter(sigmaS.y, sigmaT.y, d), stepInscatter(sigmaS.z, sigmaT.z, d));
}

// A step along which the optical depth to the eye plus that to the light runs linearly from tau0 to tau1: the mean of exp(-tau) over it,
// from both ends' exponentials. Exact for parallel light inside a convex body until the face changes by which the light came in.
// Below 0.01 the series, whose first dropped term is x^3/24.
FN float meanOfExponentials(float tau0, float tau1, float e0, float e1)
{
    float x = tau1 - tau0;
    if (abs(x) < 0.01f) return e0 * (1.0f - x * 0.5f * (1.0f - x * (1.0f / 3.0f)));
    return (e0 - e1) / x;
}
FN vec3 meanOfExponentials(vec3 tau0, vec3 tau1, vec3 e0, vec3 e1)
{
    return vec3(meanOfExponentials(tau0.x, tau1.x, e0.x, e1.x), meanOfExponentials(tau0.y, tau1.y, e0.y, e1.y),
                meanOfExponentials(tau0.z, tau1.z, e0.z, e1.z));
}

// Free flight: distance to the next collision, u in [0,1); kFloatMax in a void. Density sigma exp(-sigma t).
FN float sampleDistance(float sigmaT, float u)
{
    if (!(sigmaT > 0.0f)) return kFloatMax;
    float tau =
        u < 0.1f
            ? u * (1.0f + u * (1.0f / 2.0f + u * (1.0f / 3.0f + u * (1.0f / 4.0f + u * (1.0f / 5.0f + u * (1.0f / 6.0f)))))) // -log(1-u)
            : -log(1.0f - u);
    return min(tau / sigmaT, kFloatMax);
}
FN float distancePdf(float sigmaT, float t) { return sigmaT * exp(-sigmaT * t); }
FN float sampleDistanceInverse(float sigmaT, float t) { return opacityOf(sigmaT * t); }

// Equiangular sampling of [0, D] about a point light at distance s along the ray and h beside it: density ~ 1/r^2 (Kulla & Fajardo 2012).
FN float sampleEquiangular(float s, float h, float d, float u)
{
    float width = max(h, 1e-6f);
    float a = atan(-s / width), b = atan((d - s) / width);
    return clamp(s + width * tan(mix(a, b, u)), 0.0f, d);
}
FN float equiangularPdf(float s, float h, float d, float t)
{
    float width = max(h, 1e-6f);
    float a = atan(-s / width), b = atan((d - s) / width);
    return width / ((b - a) * (width * width + (t - s) * (t - s)));
}

// Optical depth through an exponential atmosphere sigma0 exp(-y/H): start height oy, slope dy of the unit direction, distance d. Clamped at
// 100.
FN float heightFogDepth(float sigma0, float scaleHeight, float oy, float dy, float d)
{
    const float kOpaque = 100.0f; // exp(-100) is 0 in every format that we store
    float k = dy * d / scaleHeight;
    float start = sigma0 * d;
    if (!(start > 0.0f)) return 0.0f;
    // The exponents are joined before exp: high above the fog exp(-oy/H) underflows while the looked-through layer does not
    float density = k < 0.0f ? exp(min(-oy / scaleHeight - k, 88.0f)) : exp(min(-oy / scaleHeight, 88.0f));
    return min(start * density * meanTransmittance(abs(k)), kOpaque);
}

// In-scattered radiance along a ray of length d from a parallel beam of irradiance e0, not dimmed on its way in.
FN float airlightDirectional(float sigmaS, float sigmaT, float phase, float e0, float d)
{
    return stepInscatter(sigmaS, sigmaT, d) * phase * e0;
}

// Single scattering of a plane-parallel slab: albedo w, phase value p, beam of normal irradiance e0 at cosine mu0, seen at cosine mu.
FN float slabReflected(float w, float p, float e0, float tau, float mu, float mu0)
{
    return w * p * e0 * mu0 / (mu + mu0) * opacityOf(tau * (1.0f / mu + 1.0f / mu0));
}
// exp(-tau/mu) (tau/mu) (1 - exp(-z))/z with z = tau (1/mu0 - 1/mu): continuous through mu = mu0.
FN float slabTransmitted(float w, float p, float e0, float tau, float mu, float mu0)
{
    float z = tau * (mu - mu0) / (mu * mu0);
    return w * p * e0 * exp(-tau / mu) * (tau / mu) * meanTransmittance(z);
}

SHARED_END
#endif
