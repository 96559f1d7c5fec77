// GGX: its terms, its albedo, its sampler, from mirror-like to fully rough and anisotropic.
#include "shaders/facets.h"
#include "shaders/frame.h"
#include "shaders/fresnel.h"
#include "shaders/microfacet.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
namespace
{
// Directional albedo with F = 1, by the sampler's weight G2 / G1 on a grid.
double albedo(vec3 o, vec2 alpha, double power = 0.0, int grid = 400)
{
    return overSquare(
        [&](vec2 u) {
            vec3 h = sampleGgxVisible(o, alpha, u);
            vec3 i = mirrorDirection(o, h);
            if (!(i.z > 0.0f)) return 0.0;
            double weight = double(ggxReflect(o, i, alpha) * i.z / ggxReflectPdf(o, i, alpha));
            return weight * (power > 0.0 ? std::pow(double(1.0f - dot(o, h)), power) : 1.0);
        },
        grid);
}
}

TEST(Ggx, TermsMeetTheirValues)
{
    struct Row {
        float i[2], o[2];
        vec2 alpha;
        double d, lambda, g, f;
    };
    for (const Row& r : {Row{{30, 0}, {45, 180}, {0.5f, 0.5f}, 1.152425186, 0.05901699437, 0.9264118682, 0.4358541908},
                         Row{{60, 20}, {50, 210}, {0.4f, 0.1f}, 2.932104929, 0.04175268495, 0.8778756098, 2.002234769},
                         Row{{0, 0}, {0, 0}, {1e-4f, 1e-4f}, 31830988.62, 0.0, 1.0, 7957747.155},
                         Row{{89, 10}, {88, 185}, {0.2f, 0.3f}, 0.07184833138, 2.420310533, 0.1139256213, 3.359724131}}) {
        vec3 i = fromDegrees(r.i[0], r.i[1]), o = fromDegrees(r.o[0], r.o[1]);
        expectRelative(ggxD(normalize(i + o), r.alpha), r.d, 1e-5);
        EXPECT_NEAR(ggxLambda(o, r.alpha), r.lambda, 1e-5 * r.lambda + 1e-9);
        expectRelative(ggxG2(o, i, r.alpha), r.g, 1e-5);
        expectRelative(ggxReflect(o, i, r.alpha), r.f, 1e-5);
    }
}

TEST(Ggx, NarrowLobesKeepTheirDigits)
{
    struct Row {
        float alpha;
        double d;
    };
    for (const Row& r : {Row{0.01f, 795.880826}, Row{0.001f, 79577.5776}, Row{0.0001f, 7957747.26}})
        expectRelative(ggxD(vec3(std::sin(r.alpha), 0.0f, std::cos(r.alpha)), vec2(r.alpha)), r.d, 1e-5);
}

TEST(Ggx, NormalsCoverTheGround)
{
    for (vec2 alpha : {vec2(0.1f), vec2(0.5f), vec2(1.0f), vec2(0.5f, 0.1f)}) {
        double projected = overSphere([&](vec3 h) { return double(ggxD(h, alpha) * h.z); }, 0.0, 1.0, 1500, 800);
        EXPECT_NEAR(projected, 1.0, 2e-3);
        vec3 o = fromDegrees(60.0f, 30.0f); // and the visible ones cover the view
        EXPECT_NEAR(overSphere([&](vec3 h) { return double(ggxVisiblePdf(o, h, alpha)); }, 0.0, 1.0, 1500, 800), 1.0, 2e-3);
    }
}

// H45: fully rough and seen square on, what meets one facet alone loses all but 1 - ln 2.
TEST(Ggx, AlbedoMeetsTheTable)
{
    const double mus[] = {0.1, 0.3, 0.5, 0.7, 1.0};
    struct Row {
        float alpha;
        double e[5];
    };
    for (const Row& r : {Row{0.1f, {0.8834550019, 0.936251762, 0.9692049844, 0.9814185958, 0.9883040565}},
                         Row{0.25f, {0.8916223518, 0.8379057646, 0.8572634356, 0.885335752, 0.9158124302}},
                         Row{0.5f, {0.8601050727, 0.7452719842, 0.6982506969, 0.6829542327, 0.6878485151}},
                         Row{1.0f, {0.7602104727, 0.5600988794, 0.4506938557, 0.3788877635, 0.3068528194}}})
        for (int k = 0; k < 5; ++k)
            EXPECT_NEAR(albedo(atCosine(float(mus[k])), vec2(r.alpha), 0.0, 800), r.e[k], 1e-4 * r.e[k]) << r.alpha << " " << mus[k];
    expectRelative(albedo(atCosine(0.05f), vec2(0.01f)), 0.9762075901, 1e-4);
    expectRelative(albedo(vec3(0, 0, 1), vec2(1.0f), 0.0, 800), 1.0 - std::log(2.0), 1e-4);
}

TEST(Ggx, AnisotropicAlbedoMeetsTheTable)
{
    struct Row {
        vec2 alpha;
        float phi;
        double e;
    };
    for (const Row& r : {Row{{0.5f, 0.1f}, 0, 0.8057605942}, Row{{0.5f, 0.1f}, 45, 0.7985846483}, Row{{0.5f, 0.1f}, 90, 0.8042691365},
                         Row{{1.0f, 0.001f}, 0, 0.651636791}, Row{{1.0f, 0.001f}, 90, 0.532839105}})
        EXPECT_NEAR(albedo(fromDegrees(60.0f, r.phi), r.alpha), r.e, 1e-4 * r.e) << r.alpha.x << " " << r.phi;
}

// H46: alpha 1 along x and 0.001 along y, from every side. Facets then lean along x alone, with slopes s of density (1 + s^2)^(-3/2) / 2, and
// the albedo is the integral of that times (o.m) / (o.z (1 + Lambda(o) + Lambda(i))), m = (-s, 0, 1), i the mirrored o, above the horizon.
TEST(Ggx, BrushedAlbedoIsThatOfGroovesFromEverySide)
{
    const auto lambda = [](dvec3 v) { return 0.5 * (std::sqrt(v.x * v.x + v.z * v.z) / v.z - 1.0); };
    for (int degrees = 0; degrees < 360; degrees += 15) {
        const vec3 view = fromDegrees(60.0f, float(degrees));
        const dvec3 o(view);
        double grooves = 0.0;
        const int steps = 20000;
        for (int k = 0; k < steps; ++k) {
            const double lean = M_PI * ((k + 0.5) / steps - 0.5), s = std::tan(lean); // ds (1 + s^2)^(-3/2) = cos(lean) d lean
            const dvec3 m(-s, 0.0, 1.0), i = 2.0 * dot(o, m) / dot(m, m) * m - o;
            if (dot(o, m) > 0.0 && i.z > 0.0)
                grooves += 0.5 * std::cos(lean) * M_PI / steps * dot(o, m) / (o.z * (1.0 + lambda(o) + lambda(i)));
        }
        EXPECT_NEAR(albedo(view, vec2(1.0f, 0.001f)), grooves, 1e-3) << degrees;
    }
}

TEST(Ggx, SplitSumScaleAndBias)
{
    struct Row {
        float alpha, mu;
        double scale, bias;
    };
    for (const Row& r : {Row{0.25f, 0.9f, 0.90703634, 0.000346750587}, Row{0.5f, 0.5f, 0.6881007121, 0.01014998478},
                         Row{1.0f, 0.2f, 0.6276205049, 0.01402760128}}) {
        double bias = albedo(atCosine(r.mu), vec2(r.alpha), 5.0);
        EXPECT_NEAR(bias, r.bias, 0.002 * r.bias + 1e-4);
        EXPECT_NEAR(albedo(atCosine(r.mu), vec2(r.alpha)) - bias, r.scale, 0.002 * r.scale + 1e-4);
    }
}

TEST(Ggx, AverageAlbedoMeetsTheTable)
{
    struct Row {
        float alpha;
        double average;
    };
    for (const Row& r : {Row{0.25f, 0.882323383}, Row{0.5f, 0.700240469}, Row{1.0f, 0.409137093}}) {
        Random random;
        Mean mean;
        for (int i = 0; i < 400000; ++i) {
            vec3 o = atCosine(std::sqrt(1.0f - random.next())); // cosine-distributed views
            vec3 h = sampleGgxVisible(o, vec2(r.alpha), random.next2()), w = mirrorDirection(o, h);
            mean.add(w.z > 0.0f ? double(ggxReflect(o, w, vec2(r.alpha)) * w.z / ggxReflectPdf(o, w, vec2(r.alpha))) : 0.0);
        }
        EXPECT_NEAR(mean.value(), r.average, 4.0 * mean.error() + 1e-4 * r.average);
    }
}

// What is given back is what is lost, hardly less and no more: at every angle, and of brushed surfaces from every side.
TEST(FacetLoss, IsABoundThatIsNearlyMet)
{
    for (float alpha : {0.001f, 0.003f, 0.01f, 0.03f, 0.08f, 0.14f, 0.22f, 0.35f, 0.5f, 0.7f, 1.0f})
        for (float mu : {0.001f, 0.005f, 0.02f, 0.06f, 0.15f, 0.3f, 0.5f, 0.8f, 1.0f}) {
            const double above = 1.0 - albedo(atCosine(mu), vec2(alpha), 0.0, 800) - double(facetLoss(facetLossOf(vec2(alpha)), mu));
            EXPECT_GT(above, -2e-4) << alpha << " " << mu;
            EXPECT_LT(above, 0.009) << alpha << " " << mu;
        }
    for (vec2 alpha :
         {vec2(0.011f, 0.01f), vec2(0.04f, 0.0025f), vec2(0.17f, 0.01f), vec2(0.5f, 0.1f), vec2(0.6f, 0.5f), vec2(1.0f, 0.25f)})
        for (float mu : {0.01f, 0.03f, 0.1f, 0.35f, 1.0f})
            for (float phi : {0.0f, 0.8f, 1.57f}) {
                const FacetLoss loss = facetLossOf(alpha);
                const vec3 o = atCosine(mu), turned(o.x * std::cos(phi), o.x * std::sin(phi), o.z);
                EXPECT_LT(albedo(turned, alpha, 0.0, 200) + double(loss.share * facetLoss(loss, mu)), 1.0 + 5e-4)
                    << alpha.x << " " << alpha.y << " " << mu << " " << phi;
            }
}

// The mean is that of the loss itself, from above: what comes back of a facet's loss is all of it but for 0.002 of the light.
TEST(FacetLoss, MeanIsThatOfTheLoss)
{
    for (float alpha : {0.001f, 0.004f, 0.016f, 0.05f, 0.09f, 0.16f, 0.3f, 0.5f, 0.75f, 1.0f}) {
        const FacetLoss loss = facetLossOf(vec2(alpha));
        double mean = 0.0, most = 0.0;
        const int steps = 4000;
        for (int k = 0; k < steps; ++k) {
            const double t = (k + 0.5) / steps, mu = t * t * t; // dense at the horizon
            const double lost = double(facetLoss(loss, float(mu)));
            mean += lost * 2.0 * mu * 3.0 * t * t / steps;
            most = std::max(most, lost);
        }
        EXPECT_LE(mean, double(loss.mean) * (1.0 + 1e-3)) << alpha;
        EXPECT_LT(most * (1.0 - mean / double(loss.mean)), 0.002) << alpha;
    }
}

TEST(Ggx, VisibleNormalsFollowTheirDensity)
{
    for (vec2 alpha : {vec2(0.2f), vec2(0.5f), vec2(1.0f), vec2(0.5f, 0.15f)})
        for (float theta : {0.0f, 50.0f, 85.0f}) {
            vec3 o = fromDegrees(theta, 25.0f);
            double deviation = directionChiSquare(
                [&](Random& r, vec3& h) {
                    h = sampleGgxVisible(o, alpha, r.next2());
                    return true;
                },
                [&](vec3 h) { return double(ggxVisiblePdf(o, h, alpha)); }, 100000, 0.0);
            EXPECT_LT(deviation, 4.0) << alpha.x << " " << theta;
        }
}

// H46, H41: brushed surfaces, from every side, and the ends of the unit interval.
TEST(Ggx, NoSampleGainsEnergy)
{
    Random random;
    const float last = 1.0f - 1.0f / 16777216.0f;
    for (vec2 alpha : {vec2(1e-3f), vec2(0.03f), vec2(0.5f), vec2(1.0f), vec2(1.0f, 0.001f)})
        for (int k = 0; k < 20000; ++k) {
            vec3 o = onSphere(double(random.next()) * 0.999999 + 1e-7, 2.0 * M_PI * double(random.next()));
            vec2 u = random.next2();
            if (k < 4) u = vec2(k & 1 ? last : 0.0f, k & 2 ? last : 0.0f);
            vec3 h = sampleGgxVisible(o, alpha, u);
            EXPECT_NEAR(length(h), 1.0f, 1e-5f);
            vec3 i = mirrorDirection(o, h);
            if (!(i.z > 0.0f)) continue;
            float weight = ggxVisibility(o, i, alpha) * 2.0f * (o.z + ggxStretch(o, alpha)) * i.z;
            EXPECT_TRUE(weight >= 0.0f && weight <= 1.0f + 1e-5f) << weight;
        }
}

TEST(Ggx, BelowTheHorizonThereIsNothing)
{
    vec2 alpha(0.3f);
    vec3 o = fromDegrees(40.0f, 0.0f);
    EXPECT_EQ(ggxReflect(o, vec3(0.6f, 0, -0.8f), alpha), 0.0f);
    EXPECT_EQ(ggxReflect(o, vec3(1, 0, 0), alpha), 0.0f);
    EXPECT_EQ(ggxReflectPdf(o, -o, alpha), 0.0f);
    EXPECT_EQ(ggxReflect(vec3(1, 0, 0), vec3(0, 0, 1), alpha), 0.0f);
    EXPECT_EQ(ggxD(vec3(0.6f, 0, -0.8f), alpha), 0.0f);
}

TEST(Ggx, PrefilterOfACosineAndOfACap)
{
    // N = V = R: directions weighted by D (n.l); the environment is max(0, n.l), or 1 within 20 degrees
    struct Row {
        float alpha;
        double cosine, cap;
    };
    for (const Row& r : {Row{0.25f, 0.8673956628, 0.4242746613}, Row{0.5f, 0.7635608765, 0.2069372375}}) {
        double weight = 0.0, cosine = 0.0, cap = 0.0;
        const double edge = std::cos(20.0 * M_PI / 180.0);
        for (int i = 0; i < 400000; ++i) {
            double c = (i + 0.5) / 400000.0;
            vec3 l = onSphere(c, 0.0);
            double w = double(ggxD(normalize(l + vec3(0, 0, 1)), vec2(r.alpha))) * c;
            weight += w;
            cosine += w * c;
            cap += c > edge ? w : 0.0;
        }
        EXPECT_NEAR(cosine / weight, r.cosine, 1e-3);
        EXPECT_NEAR(cap / weight, r.cap, 1e-3);
    }
}
}
