// GGX (Trowbridge-Reitz) with Smith's height-correlated shadowing, anisotropic. Local frame, +z = normal; directions point away.
// Everything is written with S(v) = sqrt(ax^2 x^2 + ay^2 y^2 + z^2), for then no cosine ever divides: Lambda = (S/z - 1)/2.
// Based on: Walter et al. 2007, Heitz 2014 (Smith), Dupuy & Benyoub 2023 (sampling of visible normals by spherical caps).
#ifndef AFTERGLOW_MICROFACET_H
#define AFTERGLOW_MICROFACET_H
#include "shaders/constants.h"
SHARED_BEGIN

// Below it a surface is an ideal mirror. At 0.001 the lobe loses 3e-5 of its energy by shadowing, and its peak, 3e5/sr, keeps its digits.
const float kMirrorAlpha = 1e-3f;

// Perceptual roughness and anisotropy strength (KHR_materials_anisotropy: along the tangent, then across) -> alpha.
FN vec2 roughnessToAlpha(float roughness, float anisotropy)
{
    float a = clamp(roughness, 0.0f, 1.0f) * clamp(roughness, 0.0f, 1.0f);
    float s = clamp(anisotropy, 0.0f, 1.0f);
    return vec2(mix(a, 1.0f, s * s), a);
}
FN bool isMirror(vec2 alpha) { return max(alpha.x, alpha.y) < kMirrorAlpha; }

FN float ggxStretch(vec3 v, vec2 alpha)
{
    float x = alpha.x * v.x, y = alpha.y * v.y;
    return sqrt(x * x + y * y + v.z * v.z);
}

// Density of facet normals, 1/sr; 0 below the surface. From the vector's components: 1 - z^2 would lose every digit of a narrow lobe.
FN float ggxD(vec3 h, vec2 alpha)
{
    if (!(h.z > 0.0f)) return 0.0f;
    float x = h.x / alpha.x, y = h.y / alpha.y;
    float q = x * x + y * y + h.z * h.z;
    return 1.0f / (kPi * alpha.x * alpha.y * q * q);
}

// (sqrt(1 + a^2 tan^2) - 1) / 2 without the difference.
FN float ggxLambda(vec3 v, vec2 alpha)
{
    float x = alpha.x * v.x, y = alpha.y * v.y;
    float a2 = x * x + y * y;
    float z = abs(v.z);
    return a2 / (2.0f * z * (z + sqrt(a2 + z * z)));
}
FN float ggxG1(vec3 v, vec2 alpha)
{
    float z = abs(v.z);
    return z > 0.0f ? 2.0f * z / (z + ggxStretch(v, alpha)) : 0.0f;
}
FN float ggxG2(vec3 o, vec3 i, vec2 alpha)
{
    float zo = abs(o.z), zi = abs(i.z);
    float below = ggxStretch(o, alpha) * zi + ggxStretch(i, alpha) * zo;
    return below > 0.0f ? 2.0f * zo * zi / below : 0.0f;
}
// G2 / (4 z_o z_i), for reflection.
FN float ggxVisibility(vec3 o, vec3 i, vec2 alpha)
{
    float below = 2.0f * (ggxStretch(o, alpha) * abs(i.z) + ggxStretch(i, alpha) * abs(o.z));
    return below > 0.0f ? 1.0f / below : 0.0f;
}

// A facet normal as seen from o (o.z > 0): density G1(o) (o.h) D(h) / o.z per solid angle of h.
FN vec3 sampleGgxVisible(vec3 o, vec2 alpha, vec2 u)
{
    // Stretch to the hemisphere of alpha = 1, where visible normals are half-way between o and a uniform point of a spherical cap
    vec3 v = normalize(vec3(alpha.x * o.x, alpha.y * o.y, o.z));
    float z = (1.0f - u.y) * (1.0f + v.z) - v.z;
    float r = sqrt(clamp(1.0f - z * z, 0.0f, 1.0f));
    vec3 h = v + vec3(r * cos(kTwoPi * u.x), r * sin(kTwoPi * u.x), z);
    // Stretch back. h.z >= 0 but for rounding; the zero vector (grazing o, u.y -> 1) means the normal itself
    h = vec3(alpha.x * h.x, alpha.y * h.y, max(h.z, 1e-7f));
    return normalize(h);
}
// Density of the visible normal h; divide by 4 (o.h) for that of the reflected direction.
FN float ggxVisiblePdf(vec3 o, vec3 h, vec2 alpha)
{
    return 2.0f * max(dot(o, h), 0.0f) * ggxD(h, alpha) / (abs(o.z) + ggxStretch(o, alpha));
}

// Reflection: value with F = 1 (1/sr, without the cosine) and density of the direction. 0 at and below the horizon.
FN float ggxReflect(vec3 o, vec3 i, vec2 alpha)
{
    if (!(o.z > 0.0f && i.z > 0.0f)) return 0.0f;
    return ggxD(normalize(o + i), alpha) * ggxVisibility(o, i, alpha);
}
FN float ggxReflectPdf(vec3 o, vec3 i, vec2 alpha)
{
    if (!(o.z > 0.0f && i.z > 0.0f)) return 0.0f;
    return ggxD(normalize(o + i), alpha) / (2.0f * (o.z + ggxStretch(o, alpha)));
}

SHARED_END
#endif
