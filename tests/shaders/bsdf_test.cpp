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
        {"white metal rough 1", made(white, 1.0f, 1.0f)},
        {"half metal", made(red, 0.5f, 0.5f)},
        {"brushed metal", made(white, 0.3f, 1.0f, 0.0f, 0.0f, true, 1.5f, 0.0f, 0.8f)},
        {"rough brushed metal", made(white, 0.7f, 1.0f, 0.0f, 0.0f, true, 1.5f, 0.0f, 0.5f)},
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

// What comes back of a unit sky: the wide lobes (matte base, and between a metal's facets) by quadrature, the interfaces' own (deltas
// included) by their sampler on a grid. Energy that passes through counts without the radiance's eta^2.
vec3 wideValue(const Bsdf& b, const BsdfView& view, vec3 wi) { return baseValue(b, view, wi) + againValue(b, view, wi); }
double wideAlbedo(const Bsdf& b, vec3 wo, int channel)
{
    const BsdfView view = viewBsdf(b, wo);
    double sum = 0.0;
    const int rows = 300, columns = 48;
    for (int i = 0; i < rows; ++i) {
        double t = (i + 0.5) / rows, mu = t * t; // dense at the horizon, where the layer's transmittance falls to 0
        for (int j = 0; j < columns; ++j) {
            vec3 wi = onSphere(mu, 2.0 * M_PI * (j + 0.5) / columns);
            sum += double(wideValue(b, view, wi)[channel]) * mu * 2.0 * t * 2.0 * M_PI / (double(rows) * columns);
        }
    }
    return sum;
}
double interfaceAlbedo(const Bsdf& b, vec3 wo, int channel, int n = 128)
{
    const BsdfView view = viewBsdf(b, wo);
    const vec3 lobes = view.lobes;
    double sum = 0.0;
    for (int l = 1; l < 3; ++l) {
        if (!(lobes[l] > 0.0f)) continue;
        float choice = std::min(lobes.x + (l == 1 ? 0.5f * (1.0f + view.wide) * lobes.y : lobes.y + 0.5f * lobes.z), kOneMinusEpsilon);
        sum += overSquare(
            [&](vec2 u) {
                BsdfSample s = bsdfSample(b, wo, choice, u);
                if (!(s.pdf > 0.0f) && (s.lobe & kLobeDelta) == 0u) return 0.0;
                // Weight of the interfaces alone: the wide lobes share the direction, not the estimate
                vec3 f = s.pdf > 0.0f ? s.weight * (s.pdf / std::abs(s.direction.z)) : s.weight;
                if (s.pdf > 0.0f && s.direction.z > 0.0f) f -= wideValue(b, view, s.direction);
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
double albedo(const Bsdf& b, vec3 wo, int channel = 0) { return wideAlbedo(b, wo, channel) + interfaceAlbedo(b, wo, channel); }
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

// What the layer does not send back, the base receives: a white dielectric is white at any roughness and any angle that holds energy (H45).
TEST(Bsdf, WhitePlasticReturnsNearlyEverything)
{
    for (float roughness : {0.0f, 0.05f, 0.1f, 0.2f, 0.3f, 0.5f, 0.7f, 0.85f, 1.0f})
        for (float mu : {0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
            EXPECT_NEAR(albedo(made(vec3(1.0f), roughness, 0.0f), atCosine(mu)), 1.0, mu < 0.3f ? 0.06 : 0.012) << roughness << " " << mu;
}

// H45: what one facet loses others send back. A metal of reflectance 1 is white at any roughness and any angle.
TEST(Bsdf, WhiteMetalReturnsEverything)
{
    for (float roughness : {0.0f, 0.04f, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1.0f})
        for (float mu : {0.002f, 0.01f, 0.03f, 0.1f, 0.2f, 0.35f, 0.5f, 0.75f, 1.0f})
            EXPECT_NEAR(albedo(made(vec3(1.0f), roughness, 1.0f), atCosine(mu)), 1.0, 0.01) << roughness << " " << mu;
}

// Of a grey one as of a colour's channel: between two facets and beyond, each reflects F once more, by its mean over directions.
TEST(Bsdf, GreyMetalReturnsWhatItsFacetsLeave)
{
    for (float f0 : {0.2f, 0.6f, 0.9f}) {
        const Bsdf metal = made(vec3(f0), 1.0f, 1.0f);
        const double f = (1.0 + 20.0 * double(f0)) / 21.0, loss = 1.0 - 0.409137093; // cosine averages of Schlick's term and of 1 - E
        double met = f * loss, between = 0.0;
        for (int facets = 2; facets < 200; ++facets, met *= f * loss) between += met * f * (1.0 - loss);
        // Of views by the cosine, so that what one facet loses is `loss` on average
        double sum = 0.0;
        const int steps = 64;
        for (int k = 0; k < steps; ++k) sum += double(viewBsdf(metal, atCosine(std::sqrt((float(k) + 0.5f) / steps))).again.x) / steps;
        EXPECT_NEAR(sum, between, 0.01);
    }
}

// H44: below kMirrorAlpha, which is a roughness of 0.0316, all are the one mirror: no lobe has a value, so none overflows.
TEST(Bsdf, WhatIsNearlySmoothIsTheMirror)
{
    const vec3 o = fromDegrees(50.0f, 10.0f);
    const BsdfSample smooth = bsdfSample(made(vec3(0.8f), 0.0f, 1.0f), o, 0.4f, vec2(0.2f, 0.9f));
    EXPECT_EQ(smooth.lobe, kLobeReflection | kLobeDelta);
    for (float roughness : {1e-4f, 1e-3f, 0.03f}) {
        const Bsdf metal = made(vec3(0.8f), roughness, 1.0f);
        const BsdfSample s = bsdfSample(metal, o, 0.4f, vec2(0.2f, 0.9f));
        EXPECT_EQ(s.lobe, smooth.lobe) << roughness;
        EXPECT_EQ(s.direction, smooth.direction) << roughness;
        EXPECT_EQ(s.weight, smooth.weight) << roughness;
        EXPECT_EQ(bsdfEvaluate(metal, o, s.direction), vec3(0.0f)) << roughness;
        EXPECT_EQ(bsdfPdf(metal, o, s.direction), 0.0f) << roughness;
    }
    EXPECT_FALSE(isMirror(made(vec3(0.8f), 0.032f, 1.0f).alpha));
}

// H44
TEST(Bsdf, FurnaceDoesNotJumpWhereTheLobeBecomesAMirror)
{
    float below = std::sqrt(kMirrorAlpha * 0.999f), above = std::sqrt(kMirrorAlpha * 1.001f);
    for (float metallic : {0.0f, 1.0f})
        for (float mu : {0.1f, 0.3f, 0.7f, 1.0f})
            EXPECT_NEAR(albedo(made(vec3(0.8f), below, metallic), atCosine(mu)), albedo(made(vec3(0.8f), above, metallic), atCosine(mu)),
                        1e-3);
}

TEST(Bsdf, IsReciprocal)
{
    Random random;
    for (const Case& c : cases())
        for (int k = 0; k < 2000; ++k) {
            vec3 o = onSphere(double(random.next()) * 0.9998 + 1e-4, 6.28 * double(random.next())),
                 i = onSphere(double(random.next()) * 0.9998 + 1e-4, 6.28 * double(random.next()));
            vec3 a = bsdfEvaluate(c.bsdf, o, i), b = bsdfEvaluate(c.bsdf, i, o);
            for (int ch = 0; ch < 3; ++ch) ASSERT_NEAR(a[ch], b[ch], 2e-3f * std::abs(a[ch]) + 1e-6f) << c.name;
            ASSERT_TRUE(std::isfinite(a.x) && a.x >= 0.0f) << c.name;
        }
}

// Through an interface, f / eta^2 of the far side is what both ways share: f(o -> i) * eta^2 = f(i -> o) as seen from the other side.
TEST(Bsdf, TransmissionIsReciprocalUpToTheRadianceScale)
{
    Bsdf out = made(vec3(1.0f), 0.5f, 0.0f, 1.0f, 1.0f, true), in = made(vec3(1.0f), 0.5f, 0.0f, 1.0f, 1.0f, false);
    Random random;
    for (int k = 0; k < 5000; ++k) {
        vec3 o = onSphere(double(random.next()) * 0.998 + 1e-3, 6.28 * double(random.next())),
             i = onSphere(-double(random.next()) * 0.998 - 1e-3, 6.28 * double(random.next()));
        vec3 flip(1, 1, -1);
        float a = bsdfEvaluate(out, o, i).x * out.eta * out.eta, b = bsdfEvaluate(in, i * flip, o * flip).x;
        ASSERT_NEAR(a, b, 5e-3f * std::abs(a) + 1e-4f);
    }
}

TEST(Bsdf, SamplesFollowTheDensity)
{
    for (const Case& c : cases()) {
        if (isMirror(c.bsdf.alpha) || c.bsdf.alpha.y < 0.08f) continue; // deltas are judged by their weights, narrow lobes by the GGX tests
        for (float theta : {0.0f, 40.0f, 75.0f}) {
            vec3 o = fromDegrees(theta, 20.0f);
            double deviation = directionChiSquare(
                [&](Random& r, vec3& d) {
                    float choice = r.next();
                    BsdfSample s = bsdfSample(c.bsdf, o, choice, r.next2());
                    d = s.direction;
                    return s.pdf > 0.0f;
                },
                [&](vec3 i) { return double(bsdfPdf(c.bsdf, o, i)); }, 60000);
            EXPECT_LT(deviation, 4.5) << c.name << " " << theta;
        }
    }
}

// E[weight] over samples = integral of f cos over all directions, for what is no delta.
TEST(Bsdf, SampleWeightsEstimateTheIntegral)
{
    for (const Case& c : cases()) {
        if (isMirror(c.bsdf.alpha)) continue;
        vec3 o = fromDegrees(50.0f, 10.0f);
        Random random;
        Mean mean;
        for (int k = 0; k < 60000; ++k) {
            float choice = random.next();
            BsdfSample s = bsdfSample(c.bsdf, o, choice, random.next2());
            ASSERT_TRUE(s.weight.x >= 0.0f && std::isfinite(s.weight.x)) << c.name;
            float scale = s.direction.z < 0.0f && c.bsdf.thin == 0.0f ? c.bsdf.eta * c.bsdf.eta : 1.0f;
            mean.add(double(s.weight.x * scale));
        }
        EXPECT_NEAR(mean.value(), albedo(c.bsdf, o), 4.0 * mean.error() + 2e-3) << c.name;
    }
}

// H41
TEST(Bsdf, EndsOfTheUnitIntervalAndOfTheHorizonAreSafe)
{
    const float last = 1.0f - 1.0f / 16777216.0f;
    for (const Case& c : cases())
        for (float mu : {1e-7f, 1e-4f, 0.5f, 1.0f})
            for (float choice : {0.0f, 0.3f, 0.7f, last})
                for (float x : {0.0f, 0.5f, last})
                    for (float y : {0.0f, 0.5f, last}) {
                        BsdfSample s = bsdfSample(c.bsdf, atCosine(mu), choice, vec2(x, y));
                        EXPECT_NEAR(length(s.direction), 1.0f, 1e-3f) << c.name;
                        EXPECT_TRUE(std::isfinite(s.pdf) && s.pdf >= 0.0f) << c.name;
                        for (int ch = 0; ch < 3; ++ch)
                            EXPECT_TRUE(std::isfinite(s.weight[ch]) && s.weight[ch] >= 0.0f) << c.name << " " << mu;
                    }
    for (const Case& c : cases()) {
        EXPECT_EQ(bsdfEvaluate(c.bsdf, vec3(1, 0, 0), vec3(0, 0, 1)), vec3(0.0f)) << c.name;
        EXPECT_EQ(bsdfEvaluate(c.bsdf, vec3(0, 0.6f, -0.8f), vec3(0, 0, 1)), vec3(0.0f)) << c.name;
        EXPECT_EQ(bsdfEvaluate(c.bsdf, vec3(0, 0, 1), vec3(1, 0, 0)), vec3(0.0f)) << c.name;
        if (c.bsdf.transmission.x == 0.0f) {
            EXPECT_EQ(bsdfEvaluate(c.bsdf, vec3(0, 0, 1), vec3(0, 0, -1)), vec3(0.0f)) << c.name;
        }
    }
}

// H47: light from straight behind, where o + i = 0, and an eye below the surface. Light straight through is for glass alone, and between
// equal indices, where o + eta i = 0, for no facet of it.
TEST(Bsdf, StraightBehindAndBelowThereIsNothing)
{
    std::vector<Case> all = cases();
    all.push_back({"frosted, of the index of air", made(vec3(1.0f), 0.5f, 0.0f, 1.0f, 1.0f, true, 1.0f)});
    for (const Case& c : all)
        for (float degrees : {0.0f, 30.0f, 89.0f}) {
            const vec3 o = fromDegrees(degrees, 25.0f), below(o.x, o.y, -o.z);
            for (vec3 i : {o, below, vec3(0, 0, 1), -below}) {
                EXPECT_EQ(bsdfEvaluate(c.bsdf, below, i), vec3(0.0f)) << c.name;
                EXPECT_EQ(bsdfPdf(c.bsdf, below, i), 0.0f) << c.name;
                EXPECT_EQ(bsdfSample(c.bsdf, below, 0.5f, vec2(0.5f)).weight, vec3(0.0f)) << c.name;
            }
            const BsdfValue through = bsdfValue(c.bsdf, o, -o);
            EXPECT_TRUE(std::isfinite(through.f.x) && std::isfinite(through.pdf)) << c.name;
            if (c.bsdf.transmission.x > 0.0f && c.bsdf.eta != 1.0f) continue;
            EXPECT_EQ(through.f, vec3(0.0f)) << c.name;
            EXPECT_EQ(through.pdf, 0.0f) << c.name;
        }
}

TEST(Bsdf, MirrorDoesNotDimWithTheAngle)
{
    Bsdf mirror = made(vec3(0.9f), 0.0f, 1.0f);
    for (float degrees : {0.0f, 45.0f, 60.0f}) {
        vec3 o = fromDegrees(degrees, 30.0f);
        BsdfSample s = bsdfSample(mirror, o, 0.4f, vec2(0.2f, 0.9f));
        EXPECT_EQ(s.lobe, kLobeReflection | kLobeDelta);
        EXPECT_EQ(s.pdf, 0.0f);
        EXPECT_NEAR(length(s.direction - vec3(-o.x, -o.y, o.z)), 0.0f, 1e-6f);
        EXPECT_NEAR(s.weight.x, 0.9f + 0.1f * schlickWeight(o.z), 1e-6f);
    }
    EXPECT_EQ(bsdfEvaluate(mirror, vec3(0, 0, 1), vec3(0, 0, 1)), vec3(0.0f)); // a light sampled on purpose never meets a mirror
}

// H43: at the critical angle, a float's step at a time and 1e-6 degrees to either side, what is not reflected passes: no ring is black.
TEST(Bsdf, ClearGlassHasNoRingAtTheCriticalAngle)
{
    const Bsdf in = made(vec3(1.0f), 0.0f, 0.0f, 1.0f, 1.0f, false);
    const auto returned = [&](float cosine) {
        const vec3 o = atCosine(cosine), lobes = viewBsdf(in, o).lobes;
        double sum = double(bsdfSample(in, o, 0.5f * lobes.y, vec2(0.5f)).weight.x * lobes.y);
        if (lobes.z > 0.0f) sum += double(bsdfSample(in, o, lobes.y + 0.5f * lobes.z, vec2(0.5f)).weight.x * lobes.z * in.eta * in.eta);
        return sum;
    };
    const double critical = std::asin(1.0 / 1.5);
    float cosine = float(std::cos(critical));
    for (int k = 0; k < 1000; ++k) cosine = std::nextafter(cosine, 0.0f);
    for (int k = 0; k < 2000; ++k, cosine = std::nextafter(cosine, 1.0f)) EXPECT_NEAR(returned(cosine), 1.0, 1e-3) << k - 1000;
    for (double off : {-1e-6, 0.0, 1e-6}) EXPECT_NEAR(returned(float(std::cos(critical + off * M_PI / 180.0))), 1.0, 1e-3);
}

// H43
TEST(Bsdf, ClearGlassScalesRadianceAndReflectsTotally)
{
    Bsdf in = made(vec3(1.0f), 0.0f, 0.0f, 1.0f, 1.0f, false);
    auto through = [](const Bsdf& b, vec3 o) {
        vec3 lobes = viewBsdf(b, o).lobes;
        BsdfSample s = bsdfSample(b, o, std::min(lobes.x + lobes.y + 0.5f * lobes.z, kOneMinusEpsilon), vec2(0.5f));
        return s.lobe & kLobeTransmission ? s.weight.x * lobes.z : 0.0f;
    };
    // From inside glass, toward a light outside at 45 degrees: (1 - F) eta^2
    float inner = std::asin(std::sin(kPi / 4.0f) / 1.5f);
    expectRelative(through(in, vec3(std::sin(inner), 0, std::cos(inner))), 2.1369602, 1e-5);
    EXPECT_EQ(through(in, fromDegrees(60.0f, 0.0f)), 0.0f);
    // Matched indices are invisible
    Bsdf air = made(vec3(1.0f), 0.0f, 0.0f, 1.0f, 1.0f, true, 1.0f);
    expectRelative(through(air, fromDegrees(70.0f, 0.0f)), 1.0, 1e-6);
    // A clear slab at normal incidence, all inner reflections: 2 eta / (eta^2 + 1)
    double f = double(interfaceReflectance(in, 1.0f).x), t = 1.0 - f;
    expectRelative(t * t / (1.0 - f * f), 0.9230769231, 1e-5);
}

TEST(Surface, LambertIsLambert)
{
    Material m = plain();
    m.flags = kMaterialLambert;
    Bsdf b = makeBsdf(m, vec4(0.5f, 0.25f, 2.0f, 1.0f), vec2(0.3f, 1.0f), 0.0f, true);
    EXPECT_FLOAT_EQ(bsdfEvaluate(b, fromDegrees(30, 0), fromDegrees(70, 100)).x, 0.5f * kInvPi);
    EXPECT_FLOAT_EQ(bsdfEvaluate(b, fromDegrees(30, 0), fromDegrees(70, 100)).z, kInvPi); // albedo is at most 1
    BsdfSample s = bsdfSample(b, fromDegrees(30, 0), 0.99f, vec2(0.3f));
    EXPECT_EQ(s.lobe, kLobeDiffuse);
    EXPECT_NEAR(s.weight.y, 0.25f, 1e-6f);
    Material none = plain(); // specular factor 0 is the other way to say so
    none.specular = 0.0f;
    EXPECT_FLOAT_EQ(bsdfEvaluate(makeBsdf(none, vec4(0.5f), vec2(0.5f, 0.0f), 0.0f, true), fromDegrees(30, 0), fromDegrees(70, 100)).x,
                    0.5f * kInvPi);
}
}
