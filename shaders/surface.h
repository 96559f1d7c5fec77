// From a material and its textures' values to the law of one point: the same function for both tracers and for the raster pass.
#ifndef AFTERGLOW_SURFACE_H
#define AFTERGLOW_SURFACE_H
#include "shaders/bsdf.h"
#include "shaders/scene.h"
SHARED_BEGIN

// baseColor, roughMetal (x perceptual roughness, y metallic) and transmission: factor times texture. entering: wo is on the outer side.
FN Bsdf makeBsdf(Material m, vec4 baseColor, vec2 roughMetal, float transmission, bool entering)
{
    vec3 color = clamp(vec3(baseColor), 0.0f, 1.0f);
    if ((m.flags & kMaterialLambert) != 0u) {
        Bsdf matte = lambertBsdf(color);
        matte.roughness = eonRoughness(m.sigma);
        return matte;
    }
    float metallic = clamp(roughMetal.y, 0.0f, 1.0f);
    float through = clamp(transmission, 0.0f, 1.0f);
    float ior = m.ior > 1.0f ? m.ior : 1.0f;
    Bsdf b;
    b.thin = m.thickness > 0.0f ? 0.0f : 1.0f;
    bool inside = !entering && through > 0.0f && b.thin == 0.0f;
    b.eta = inside ? 1.0f / ior : ior;
    b.diffuse = color * ((1.0f - metallic) * (1.0f - through));
    b.roughness = eonRoughness(m.sigma);
    b.metal = color;
    b.metallic = metallic;
    b.layer = min(m.specularColor * dielectricF0(ior), vec3(1.0f)) * clamp(m.specular, 0.0f, 1.0f);
    b.layerEdge = clamp(m.specular, 0.0f, 1.0f);
    b.transmission = color * ((1.0f - metallic) * through);
    b.alpha = roughnessToAlpha(roughMetal.x, m.anisotropy);
    // The matte base lies under the outer side only: within the body there is nothing but the interface
    if (inside) b.diffuse = vec3(0.0f, 0.0f, 0.0f);
    prepareBsdf(b);
    return b;
}

// Absorption in 1/m within a body of glass or water (KHR_materials_volume): by Beer's law attenuationColor is left after
// attenuationDistance.
FN vec3 bodyAbsorption(Material m)
{
    const float kDarkest = 1e-30f; // of a colour: its logarithm is finite
    if (!(m.thickness > 0.0f && m.transmission > 0.0f)) return vec3(0.0f, 0.0f, 0.0f);
    return -log(max(m.attenuationColor, vec3(kDarkest))) / m.attenuationDistance;
}

SHARED_END
#endif
