// The sky as a light: its radiance by direction, and for an image the choice of directions in proportion to luminance times solid angle.
// This work is based on: pbrt 4ed 12.5.2 (piecewise-constant distribution over an equirectangular image).
// The includer defines, before this line:
//   struct SkyMap           passed by value, with at least these members
//     ivec2 size            of the image, px; 0: the sky is uniform
//     vec3  tint            radiance of a uniform sky, factor of the image
//     float rotation        radians about +y
//     uint  sampled         0: nothing to choose by: uniform, or black
//   vec3  skyTexel(SkyMap, ivec2)              radiance without the tint
//   float skyRow(SkyMap, int y)                chance that a row up to y is chosen, ends at 1 (engine/scene/sky.cpp makes both)
//   float skyColumn(SkyMap, ivec2)             the same within a row
#ifndef AFTERGLOW_SKY_LIGHT_H
#define AFTERGLOW_SKY_LIGHT_H
#include "shaders/light.h"
#include "shaders/ray.h"
SHARED_BEGIN

// Its two ends meet; its poles do not.
FN vec3 skyTexelAt(SkyMap sky, int x, int y)
{
    x = x < 0 ? x + sky.size.x : x;
    return skyTexel(sky, ivec2(x < sky.size.x ? x : x - sky.size.x, clamp(y, 0, sky.size.y - 1)));
}

FN vec3 skyMapRadiance(SkyMap sky, vec3 direction)
{
    if (sky.size.x == 0) return sky.tint;
    vec2 p = skyUv(direction, sky.rotation) * vec2(sky.size) - vec2(0.5f);
    vec2 cell = floor(p);
    vec2 f = p - cell;
    int x = int(cell.x), y = int(cell.y);
    vec3 upper = mix(skyTexelAt(sky, x, y), skyTexelAt(sky, x + 1, y), f.x);
    vec3 lower = mix(skyTexelAt(sky, x, y + 1), skyTexelAt(sky, x + 1, y + 1), f.x);
    return sky.tint * mix(upper, lower, f.y);
}

FN float skyMapPdf(SkyMap sky, vec3 direction)
{
    if (sky.sampled == 0u) return 0.0f;
    vec2 uv = skyUv(direction, sky.rotation);
    int x = clamp(int(uv.x * float(sky.size.x)), 0, sky.size.x - 1);
    int y = clamp(int(uv.y * float(sky.size.y)), 0, sky.size.y - 1);
    float row = skyRow(sky, y) - (y > 0 ? skyRow(sky, y - 1) : 0.0f);
    float column = skyColumn(sky, ivec2(x, y)) - (x > 0 ? skyColumn(sky, ivec2(x - 1, y)) : 0.0f);
    float sine = length(vec2(direction.x, direction.z)); // 1 - y^2 has no digits left within 0.02 degrees of a pole
    if (!(sine > 0.0f)) return 0.0f;
    // p(u, v) = row * column * width * height, d omega = 2 pi^2 sin(theta) du dv
    return row * column * float(sky.size.x) * float(sky.size.y) / (kTwoPi * kPi * sine);
}

// Where u lies between two neighbours of a cumulative table; on neither of them, one of which may be a pole.
FN float insideStep(float before, float upTo, float u)
{
    float step_ = upTo - before;
    return step_ > 0.0f ? clamp((u - before) / step_, 1.0f - kOneMinusEpsilon, kOneMinusEpsilon) : 0.5f;
}

// The first whose cumulative value exceeds u: rows, and columns of a row.
FN int chooseSkyRow(SkyMap sky, float u)
{
    int low = 0, high = sky.size.y - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (skyRow(sky, middle) > u)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}
FN int chooseSkyColumn(SkyMap sky, int y, float u)
{
    int low = 0, high = sky.size.x - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (skyColumn(sky, ivec2(middle, y)) > u)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

// pdf 0 for a uniform sky: there BSDF sampling is as good and casts no extra ray.
FN LightSample sampleSkyMap(SkyMap sky, vec2 u)
{
    LightSample light = noLight();
    if (sky.sampled == 0u) return light;
    int y = chooseSkyRow(sky, u.y);
    int x = chooseSkyColumn(sky, y, u.x);
    vec2 inside = vec2(insideStep(x > 0 ? skyColumn(sky, ivec2(x - 1, y)) : 0.0f, skyColumn(sky, ivec2(x, y)), u.x),
                       insideStep(y > 0 ? skyRow(sky, y - 1) : 0.0f, skyRow(sky, y), u.y));
    light.direction = skyDirection((vec2(float(x), float(y)) + inside) / vec2(sky.size), sky.rotation);
    light.distance = kRayFar;
    light.delta = 0u;
    light.radiance = skyMapRadiance(sky, light.direction);
    light.pdf = skyMapPdf(sky, light.direction);
    return light;
}

SHARED_END
#endif
