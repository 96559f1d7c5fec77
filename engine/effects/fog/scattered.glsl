// What the march found, at the picture's resolution.
#ifndef AFTERGLOW_FOG_SCATTERED_GLSL
#define AFTERGLOW_FOG_SCATTERED_GLSL
#include "engine/effects/fog/fog.h"

// A window two texels wide slides over the march with the pixel: wherever it stands, each quarter of the step has the same share of it.
vec3 scatteredHere(sampler2D scatteredTexture, uint divisor, ivec2 pixel, float distance_)
{
    ivec2 last = textureSize(scatteredTexture, 0) - 1;
    vec2 at = (vec2(pixel) - float(divisor / 2u)) / float(divisor);
    vec2 nearest = floor(at + 0.5), f = at - nearest + 0.5;
    vec2 shares[3] = vec2[3](0.5 - 0.5 * f, vec2(0.5), 0.5 * f);
    vec4 sum = vec4(0.0);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) {
            vec4 texel = texelFetch(scatteredTexture, clamp(ivec2(nearest) + ivec2(x - 1, y - 1), ivec2(0), last), 0);
            float apart = abs(texel.a - distance_) / max(distance_, 1e-3);
            float weight = shares[x].x * shares[y].y / (1e-3 + apart * apart);
            sum += weight * vec4(texel.rgb, 1.0);
        }
    return sum.rgb / max(sum.a, 1e-20);
}

#endif
