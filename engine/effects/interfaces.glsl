// What the interfaces of a surface (metal, dielectric layer) send to the eye of light that comes from about the mirror direction. Lighting
// takes that light from the probes, reflection from the picture.
#ifndef AFTERGLOW_INTERFACES_GLSL
#define AFTERGLOW_INTERFACES_GLSL
#include "engine/effects/seen_surface.glsl"
#include "shaders/bindings.glsl"
#include "shaders/bsdf.h"

bool hasInterface(Bsdf b) { return b.metallic > 0.0 || b.layerEdge > 0.0; }

// Of light from the whole lobe: a metal sends back the split sum of it, of its own facets however wide the pixel has the lobe (without
// cubemaps, where no table of it is held, what a smooth one would: what meets several facets is in that), the layer what its base does not
// receive.
vec3 interfaceShare(Bsdf b, float cosEye, bool cubemaps)
{
    vec3 layer = layerAlbedo(b, cosEye);
    if (!(b.metallic > 0.0)) return layer;
    if (!cubemaps) return mix(layer, mix(b.metal, vec3(1.0), schlickWeight(cosEye)), b.metallic);
    vec2 terms = textureLod(splitSum, splitSumUv(cosEye, sqrt(b.facets.alpha)), 0.0).rg;
    return mix(layer, b.metal * terms.x + terms.y, b.metallic);
}

#endif
