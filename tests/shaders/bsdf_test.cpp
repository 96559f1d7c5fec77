// The law of a surface: energy, reciprocity, its sampler, and the hard angles.
#include "shaders/bsdf.h"
#include "shaders/surface.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>
#include <string>

namespace afterglow::test
{
namespace
{
Material plain()
{
    Material m{};
    m.baseColor = vec4(1.0f);
    m.ior = 1.5f;
    m.specular = 1.0f;
    m.specularColor = vec3(1.0f);
    m.attenuationColor = vec3(1.0f);
    return m;
}
struct Case {
    std::string name;
    Bsdf bsdf;
};
Bsdf made(vec3 color, float roughness, float metallic, float transmission = 0.0f, float thickness = 0.0f, bool entering = true,
          float ior = 1.5f, float sigma = 0.0f, float anisotropy = 0.0f, float specular = 1.0f)
{
    Material m = plain();
    m.ior = ior;
    m.thickness = thickness;
    m.sigma = sigma;
    m.anisotropy = anisotropy;
    m.specular = specular;
    return makeBsdf(m, vec4(color, 1.0f), vec2(roughness, metallic), transmission, entering);
}
std::vector<Case> cases()
{
    const vec3 white(1.0f), red(0.8f, 0.3f, 0.1f);
    return {
        {"lambert", lambertBsdf(white)},
        {"plastic rough 0", made(white, 0.0f, 0.0f)},
        {"plastic rough 0.15", made(white, 0.15f, 0.0f)},
        {"plastic rough 0.4", made(white, 0.4f, 0.0f)},
        {"plastic rough 0.7", made(white, 0.7f, 0.0f)},
        {"plastic rough 1", made(white, 1.0f, 0.0f)},
        {"ior 1.1 rough 0.3", made(white, 0.3f, 0.0f, 0.0f, 0.0f, true, 1.1f)},
        {"ior 2.4 rough 0.3", made(white, 0.3f, 0.0f, 0.0f, 0.0f, true, 2.4f)},
        {"ior 8 rough 0.6", made(white, 0.6f, 0.0f, 0.0f, 0.0f, true, 8.0f)},
        {"half specular", made(white, 0.5f, 0.0f, 0.0f, 0.0f, true, 1.5f, 0.0f, 0.0f, 0.5f)},
        {"clay under varnish", made(white, 0.3f, 0.0f, 0.0f, 0.0f, true, 1.5f, 0.5f)},
        {"dust under varnish", made(white, 0.6f, 0.0f, 0.0f, 0.0f, true, 1.33f, 1.5f)},
        {"metal rough 0.5", made(red, 0.5f, 1.0f)},
        {"white metal rough 0.3", made(white, 0.3f, 1.0f)},
        {"half metal", made(red, 0.5f, 0.5f)},
        {"brushed metal", made(white, 0.3f, 1.0f, 0.0f, 0.0f, true, 1.5f, 0.0f, 0.8f)},
        {"brushed plastic", made(white, 0.4f, 0.0f, 0.0f, 0.0f, true, 1.5f, 0.0f, 0.8f)},
        {"frosted glass outside", made(white, 0.5f, 0.0f, 1.0f, 1.0f)},
        {"frosted glass inside", made(white, 0.5f, 0.0f, 1.0f, 1.0f, false)},
        {"clear glass outside", made(white, 0.0f, 0.0f, 1.0f, 1.0f)},
        {"clear glass inside", made(white, 0.0f, 0.0f, 1.0f, 1.0f, false)},
        {"half transmissive", made(red, 0.4f, 0.0f, 0.5f, 1.0f)},
        {"thin rough pane", made(white, 0.4f, 0.0f, 1.0f, 0.0f)},
        {"thin clear pane", made(white, 0.0f, 0.0f, 1.0f, 0.0f)},
    };
}

// What comes back of a unit sky, delta lobes included, lobe by lobe on a grid; energy that passes through counts without the radiance's eta^2.
double albedo(const Bsdf& b, vec3 wo, int channel, int n = 160)
{
    vec3 lobes = bsdfLobes(b, wo.z);
    const int strata = b.roughness > 0.0f ? 8 : 1; // a rough base chooses between two samplers by the same number
    double sum = 0.0;
    float from = 0.0f;
    for (int l = 0; l < 3; ++l) {
        if (!(lobes[l] > 0.0f)) continue;
        for (int k = 0; k < strata; ++k) {
            float choice = std::min(from + lobes[l] * (float(k) + 0.5f) / float(strata), kOneMinusEpsilon);
            double part = overSquare(
                [&](vec2 u) {
                    BsdfSample s = bsdfSample(b, wo, choice, u);
                    double w = double(s.weight[channel]);
                    return s.direction.z < 0.0f && b.thin == 0.0f ? w * double(b.eta) * double(b.eta) : w;
                },
                n);
            sum += part * double(lobes[l]) / strata;
        }
        from += lobes[l];
    }
    return sum;
}
}

TEST(Bsdf, WeakFurnaceReturnsNoMoreThanItReceives)
{
    for (const Case& c : cases())
        for (float mu : {0.01f, 0.03f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
            for (float phi : {0.0f, 1.0f}) {
                if (phi > 0.0f && c.bsdf.alpha.x == c.bsdf.alpha.y) continue;
                vec3 o = atCosine(mu);
                vec3 wo(o.x * std::cos(phi), o.x * std::sin(phi), o.z);
                EXPECT_LE(albedo(c.bsdf, wo, 0), 1.0 + 1e-3) << c.name << " mu " << mu;
            }
}
}
