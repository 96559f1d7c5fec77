// How much light an interface reflects. Cosines are of the angle to the (micro)facet normal; eta = n_transmitted / n_incident.
#ifndef AFTERGLOW_FRESNEL_H
#define AFTERGLOW_FRESNEL_H
#include "shaders/constants.h"
SHARED_BEGIN

// Schlick's weight (1 - cos)^5: reflectance = f0 + (1 - f0) * weight.
FN float schlickWeight(float cosTheta)
{
    float m = clamp(1.0f - cosTheta, 0.0f, 1.0f);
    float m2 = m * m;
    return m2 * m2 * m;
}

FN float dielectricF0(float eta)
{
    float r = (eta - 1.0f) / (eta + 1.0f);
    return r * r;
}

// Unpolarised dielectric, exact. With g = eta cos(theta_t) = sqrt((eta-1)(eta+1) + c^2), no cancellation near eta = 1 or c = 0:
// r_s = (c - g)/(c + g), r_p = (eta^2 c - g)/(eta^2 c + g). g^2 <= 0 is total reflection.
FN float fresnelDielectric(float cosTheta, float eta)
{
    if (eta == 1.0f) return 0.0f;
    float c = clamp(cosTheta, 0.0f, 1.0f);
    float g2 = (eta - 1.0f) * (eta + 1.0f) + c * c;
    if (!(g2 > 0.0f)) return 1.0f;
    float g = sqrt(g2);
    float s = (c - g) / (c + g);
    float p = (eta * eta * c - g) / (eta * eta * c + g);
    return 0.5f * (s * s + p * p);
}

// Unpolarised conductor of complex index eta + i k (Born & Wolf).
FN float fresnelConductor(float cosTheta, float eta, float k)
{
    float c2 = cosTheta * cosTheta, s2 = 1.0f - c2;
    float t0 = eta * eta - k * k - s2;
    float ab = sqrt(t0 * t0 + 4.0f * eta * eta * k * k); // a^2 + b^2
    float a = sqrt(max(0.5f * (ab + t0), 0.0f));
    float t1 = ab + c2, t2 = 2.0f * a * cosTheta;
    float rs = (t1 - t2) / (t1 + t2);
    float t3 = c2 * ab + s2 * s2, t4 = t2 * s2;
    return 0.5f * rs * (1.0f + (t3 - t4) / (t3 + t4));
}

// Cosine-weighted mean 2 int F mu dmu from the thin side, eta >= 1: what a smooth surface sends back of a diffuse sky. Walsh 1926:
// 1/2 + (n-1)(3n+1)/(6(n+1)^2) + n^2 (n^2-1)^2/(n^2+1)^3 ln((n-1)/(n+1)) - 2 n^3 (n^2+2n-1)/((n^2+1)(n^4-1)) + 8 n^4
// (n^4+1)/((n^2+1)(n^4-1)^2) ln n. The last two terms cancel toward n = 1: below 1.05 the chord to 0, which lies under the (concave) mean.
FN float fresnelAverage(float eta)
{
    const float kChord = 1.05f;
    float n = max(eta, kChord);
    float n2 = n * n, n4 = n2 * n2, p = n2 + 1.0f, m = (n - 1.0f) * (n + 1.0f), m4 = m * p;
    float sum = 0.5f + (n - 1.0f) * (3.0f * n + 1.0f) / (6.0f * (n + 1.0f) * (n + 1.0f)) +
                n2 * m * m / (p * p * p) * log((n - 1.0f) / (n + 1.0f)) +
                (2.0f * n2 * n / (p * m4)) * (4.0f * n * (n4 + 1.0f) / m4 * log(n) - (n2 + 2.0f * n - 1.0f));
    return eta < kChord ? sum * max(eta - 1.0f, 0.0f) / (kChord - 1.0f) : sum;
}
// The same from the dense side (eta = n of the dense / n of the thin): 1 - (1 - mean) / eta^2.
FN float fresnelAverageInside(float eta) { return 1.0f - (1.0f - fresnelAverage(eta)) / (eta * eta); }

// Refracted direction. wo points away from the surface on the +n side, eta = n_other / n_wo's side. False: total reflection.
FN bool refractDirection(vec3 wo, vec3 n, float eta, OUT(vec3) wi)
{
    float c = dot(wo, n);
    float cosT2 = 1.0f - (1.0f - c * c) / (eta * eta);
    wi = vec3(0.0f, 0.0f, 0.0f);
    if (!(cosT2 > 0.0f)) return false;
    wi = n * (c / eta - sqrt(cosT2)) - wo * (1.0f / eta);
    return true;
}

SHARED_END
#endif
