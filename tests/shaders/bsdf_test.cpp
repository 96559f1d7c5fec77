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

// What comes back of a unit sky: the matte base by quadrature, the interfaces (deltas included) by their sampler on a grid. Energy that
// passes through counts without the radiance's eta^2.
double baseAlbedo(const Bsdf& b, vec3 wo, int channel)
{
    double sum = 0.0;
    const int rows = 300, columns = 48;
    for (int i = 0; i < rows; ++i) {
        double t = (i + 0.5) / rows, mu = t * t; // dense at the horizon, where the layer's transmittance falls to 0
        for (int j = 0; j < columns; ++j) {
            vec3 wi = onSphere(mu, 2.0 * M_PI * (j + 0.5) / columns);
            sum += double(baseValue(b, wo, wi)[channel]) * mu * 2.0 * t * 2.0 * M_PI / (double(rows) * columns);
        }
    }
    return sum;
}
double interfaceAlbedo(const Bsdf& b, vec3 wo, int channel, int n = 128)
{
    vec3 lobes = bsdfLobes(b, wo.z);
    double sum = 0.0;
    for (int l = 1; l < 3; ++l) {
        if (!(lobes[l] > 0.0f)) continue;
        float choice = std::min(lobes.x + (l == 1 ? 0.5f * lobes.y : lobes.y + 0.5f * lobes.z), kOneMinusEpsilon);
        sum += overSquare(
            [&](vec2 u) {
                BsdfSample s = bsdfSample(b, wo, choice, u);
                if (!(s.pdf > 0.0f) && (s.lobe & kLobeDelta) == 0u) return 0.0;
                // Weight of the interfaces alone: the base shares the direction, not the estimate
                vec3 f = s.pdf > 0.0f ? s.weight * (s.pdf / std::abs(s.direction.z)) : s.weight;
                if (s.pdf > 0.0f && s.direction.z > 0.0f) f -= baseValue(b, wo, s.direction);
                double own = 1.0;
                if (s.pdf > 0.0f) {
                    float lobePdf =
                        s.direction.z > 0.0f ? ggxReflectPdf(wo, s.direction, b.alpha) : transmissionValue(b, wo, s.direction).pdf;
                    own = double(std::abs(s.direction.z) / lobePdf);
                } else {
                    own = double(lobes[l]);
                }
                double w = double(f[channel]) * own;
                return s.direction.z < 0.0f && b.thin == 0.0f ? w * double(b.eta) * double(b.eta) : w;
            },
            n);
    }
    return sum;
}
double albedo(const Bsdf& b, vec3 wo, int channel = 0) { return baseAlbedo(b, wo, channel) + interfaceAlbedo(b, wo, channel); }
}

TEST(Bsdf, WeakFurnaceReturnsNoMoreThanItReceives)
{
    for (const Case& c : cases())
        for (float mu : {0.01f, 0.03f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
            for (float phi : {0.0f, 1.0f}) {
                if (phi > 0.0f && c.bsdf.alpha.x == c.bsdf.alpha.y) continue;
                vec3 o = atCosine(mu);
                vec3 wo(o.x * std::cos(phi), o.x * std::sin(phi), o.z);
                EXPECT_LE(albedo(c.bsdf, wo), 1.0 + 3e-4) << c.name << " mu " << mu;
            }
}

// What the layer does not send back, the base receives: a white dielectric is white at any roughness and any angle that holds energy.
TEST(Bsdf, WhitePlasticReturnsNearlyEverything)
{
    for (float roughness : {0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.7f, 0.85f, 1.0f})
        for (float mu : {0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
            EXPECT_NEAR(albedo(made(vec3(1.0f), roughness, 0.0f), atCosine(mu)), 1.0, mu < 0.3f ? 0.06 : 0.012) << roughness << " " << mu;
}

TEST(Bsdf, FurnaceDoesNotJumpWhereTheLobeBecomesAMirror)
{
    float below = std::sqrt(kMirrorAlpha * 0.999f), above = std::sqrt(kMirrorAlpha * 1.001f);
    for (float metallic : {0.0f, 1.0f})
        for (float mu : {0.1f, 0.3f, 0.7f, 1.0f})
            EXPECT_NEAR(albedo(made(vec3(0.8f), below, metallic), atCosine(mu)), albedo(made(vec3(0.8f), above, metallic), atCosine(mu)),
                        1e-3);
}
}
