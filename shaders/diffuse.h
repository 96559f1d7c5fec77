// Matte surfaces, in 1/sr without the cosine; local frame, both directions on the +z side.
// Based on: Oren & Nayar 1994 (as printed: its qualitative form), Fujii 2012 and Portsmouth, Kutz & Hill 2025 (energy preserving).
#ifndef AFTERGLOW_DIFFUSE_H
#define AFTERGLOW_DIFFUSE_H
#include "shaders/constants.h"
SHARED_BEGIN

// sin(theta_i) sin(theta_o) cos(phi_i - phi_o), the shape that both models share.
FN float orenNayarShape(vec3 wo, vec3 wi) { return wo.x * wi.x + wo.y * wi.y; }

// --- As printed; sigma in radians. Loses energy: on average 14 % at sigma = 0.5, albedo 1.
FN float orenNayarA(float sigma) { return 1.0f - 0.5f * sigma * sigma / (sigma * sigma + 0.33f); }
FN float orenNayarB(float sigma) { return 0.45f * sigma * sigma / (sigma * sigma + 0.09f); }
FN float orenNayar(float sigma, vec3 wo, vec3 wi)
{
    float below = max(wo.z, wi.z);
    if (!(min(wo.z, wi.z) > 0.0f)) return 0.0f;
    return kInvPi * (orenNayarA(sigma) + orenNayarB(sigma) * max(orenNayarShape(wo, wi), 0.0f) / below);
}
// Directional albedo at cosine mu: A + (2B/pi) [sin t (t/2 - sin 2t / 4) + tan t (1 - sin^3 t) / 3], the last term by
// tan t (1 - sin^3 t) = mu s (1 + s + s^2) / (1 + s), which has no 0/0 at the horizon.
FN float orenNayarAlbedo(float sigma, float mu)
{
    float t = acos(clamp(mu, 0.0f, 1.0f));
    float s = sin(t);
    float lobe = s * (0.5f * t - 0.5f * s * mu) + mu * s * (1.0f + s + s * s) / (3.0f * (1.0f + s));
    return orenNayarA(sigma) + 2.0f * kInvPi * orenNayarB(sigma) * lobe;
}

// --- Energy preserving (EON): Fujii's lobe, plus what it loses, returned as multiple scattering. Roughness r in [0, 1]; r = 0 is Lambert.
// The printed model's B/A at the same sigma: equal shape, without its loss.
FN float eonRoughness(float sigma) { return clamp(orenNayarB(sigma) / orenNayarA(sigma), 0.0f, 1.0f); }

const float kFonLoss = 0.287793409f; // 1/2 - 2/(3 pi)
FN float fonA(float r) { return 1.0f / (1.0f + kFonLoss * r); }
// Directional albedo of the single-scattering lobe at albedo 1, and its cosine average.
FN float fonAlbedo(float r, float mu)
{
    float t = acos(clamp(mu, 0.0f, 1.0f));
    float s = sin(t);
    float lobe = s * (t - s * mu) + (2.0f / 3.0f) * (mu * s * (1.0f + s + s * s) / (1.0f + s) - s);
    return fonA(r) * (1.0f + r * kInvPi * lobe);
}
FN float fonAverage(float r) { return fonA(r) * (1.0f + r * 0.0724882124f); } // 2/3 - 28/(15 pi)

// Strength of the multiple-scattering part for a colour: what comes back after any number of bounces within the grooves.
FN vec3 eonMultiple(vec3 albedo, float average) { return albedo * albedo * average / (vec3(1.0f, 1.0f, 1.0f) - albedo * (1.0f - average)); }

FN vec3 eon(vec3 albedo, float r, vec3 wo, vec3 wi)
{
    if (!(min(wo.z, wi.z) > 0.0f)) return vec3(0.0f, 0.0f, 0.0f);
    if (r <= 0.0f) return albedo * kInvPi;
    float s = orenNayarShape(wo, wi);
    float single = kInvPi * fonA(r) * (1.0f + r * (s > 0.0f ? s / max(wo.z, wi.z) : s));
    float average = fonAverage(r);
    float loss = (1.0f - fonAlbedo(r, wo.z)) * (1.0f - fonAlbedo(r, wi.z)) / max(1.0f - average, 1e-6f);
    return albedo * single + eonMultiple(albedo, average) * (kInvPi * loss);
}
FN vec3 eonAlbedo(vec3 albedo, float r, float mu)
{
    float e = fonAlbedo(r, mu);
    return albedo * e + eonMultiple(albedo, fonAverage(r)) * (1.0f - e);
}

SHARED_END
#endif
