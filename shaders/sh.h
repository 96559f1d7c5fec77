// Spherical harmonics to order 2: light from everywhere in nine numbers a channel.
// Real basis without Condon-Shortley phase, order (0,0) (1,-1) (1,0) (1,1) (2,-2) (2,-1) (2,0) (2,1) (2,2), i.e. 1, y, z, x, xy, yz, zz,
// xz, xx-yy. Based on: Ramamoorthi & Hanrahan 2001 (irradiance), Sloan 2008 (windows).
#ifndef AFTERGLOW_SH_H
#define AFTERGLOW_SH_H
#include "shaders/constants.h"
SHARED_BEGIN

struct Sh9 {
    vec3 c[9];
};

// Zonal factors of the clamped cosine over pi: what turns radiance into irradiance / pi, by band.
const float kShCosine0 = 1.0f;
const float kShCosine1 = 2.0f / 3.0f;
const float kShCosine2 = 1.0f / 4.0f;

FN int shBand(int i) { return i == 0 ? 0 : (i < 4 ? 1 : 2); }

FN float shBasis(int i, vec3 d)
{
    if (i == 0) return 0.28209479177f;
    if (i == 1) return 0.48860251190f * d.y;
    if (i == 2) return 0.48860251190f * d.z;
    if (i == 3) return 0.48860251190f * d.x;
    if (i == 4) return 1.09254843059f * d.x * d.y;
    if (i == 5) return 1.09254843059f * d.y * d.z;
    if (i == 6) return 0.31539156525f * (3.0f * d.z * d.z - 1.0f);
    if (i == 7) return 1.09254843059f * d.x * d.z;
    return 0.54627421529f * (d.x * d.x - d.y * d.y);
}

FN Sh9 shZero()
{
    Sh9 sh;
    for (int i = 0; i < 9; ++i) sh.c[i] = vec3(0.0f, 0.0f, 0.0f);
    return sh;
}

// Adds `value` arriving from unit `direction`; for a radiance sample, value = radiance / (pdf * count).
// A float sum loses digits after some 10^4 terms: add up in batches, then add the batches.
FN void shAdd(INOUT(Sh9) sh, vec3 direction, vec3 value)
{
    for (int i = 0; i < 9; ++i) sh.c[i] += value * shBasis(i, direction);
}

FN vec3 shEvaluate(Sh9 sh, vec3 direction)
{
    vec3 sum = sh.c[0] * shBasis(0, direction);
    for (int i = 1; i < 9; ++i) sum += sh.c[i] * shBasis(i, direction);
    return sum;
}

FN Sh9 shScaleBands(Sh9 sh, float band0, float band1, float band2)
{
    for (int i = 0; i < 9; ++i) sh.c[i] *= i == 0 ? band0 : (i < 4 ? band1 : band2);
    return sh;
}

// Radiance -> irradiance / pi about +normal: the product with the clamped cosine.
FN Sh9 shConvolveCosine(Sh9 radiance) { return shScaleBands(radiance, kShCosine0, kShCosine1, kShCosine2); }

// Irradiance / pi about `normal`, from coefficients that are already convolved (as the probes store them). Never negative: order 2 rings
// to -19/480 of a single light's irradiance behind it.
FN vec3 shIrradiance(Sh9 irradianceOverPi, vec3 normal) { return max(shEvaluate(irradianceOverPi, normal), vec3(0.0f, 0.0f, 0.0f)); }

// Laplacian window 1 / (1 + lambda l^2 (l+1)^2): takes the ringing away at the price of a dimmer peak.
// kShWindow is the least lambda that keeps one directional light's irradiance >= 0 everywhere.
const float kShWindow = 0.1777318515f;
FN float shWindow(int band, float lambda)
{
    float l = float(band);
    return 1.0f / (1.0f + lambda * l * l * (l + 1.0f) * (l + 1.0f));
}
FN Sh9 shDering(Sh9 sh, float lambda) { return shScaleBands(sh, 1.0f, shWindow(1, lambda), shWindow(2, lambda)); }

SHARED_END
#endif
