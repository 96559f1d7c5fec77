// What the filters of few rays share where they read pictures: a pass says with `speaksFor` which of the neighbours count.
#ifndef AFTERGLOW_LOCAL_FIT_GLSL
#define AFTERGLOW_LOCAL_FIT_GLSL
#include "engine/effects/local_fit.h"

// How much the neighbour `at`, `away` from the pixel, speaks for it, 0..1: 0 on another surface. `value`: its texel.
float speaksFor(ivec2 at, ivec2 away, vec4 value);

// Variance around the pixel, by nine of its neighbours. `noise`: standard deviations, twice, as 8 bits hold them best.
vec4 noiseAround(sampler2D noise, ivec2 here)
{
    ivec2 last = textureSize(noise, 0) - 1;
    vec4 sum = vec4(0.0);
    for (int y = -kFitReach; y <= kFitReach; y += kFitReach)
        for (int x = -kFitReach; x <= kFitReach; x += kFitReach) {
            vec4 twice = texelFetch(noise, clamp(here + ivec2(x, y), ivec2(0), last), 0);
            sum += twice * twice;
        }
    return sum * (0.25 / 9.0);
}

// `own`: what `values` holds at the pixel.
LocalFit fitAround(sampler2D values, ivec2 here, vec4 own)
{
    ivec2 last = textureSize(values, 0) - 1;
    LocalFit fit = emptyFit();
    for (int y = -kFitReach; y <= kFitReach; ++y)
        for (int x = -kFitReach; x <= kFitReach; ++x) {
            ivec2 away = ivec2(x, y), at = here + away;
            if (at != clamp(at, ivec2(0), last)) continue;
            vec4 value = texelFetch(values, at, 0);
            float weight = fitWeight(x, y) * speaksFor(at, away, value);
            if (weight > 0.0) addTo(fit, weight, vec2(away), value - own);
        }
    return fit;
}

#endif
