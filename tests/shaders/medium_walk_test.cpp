// Paths through a medium, built of free flights and scatterings: what many orders of scattering make of a slab, and what tracking costs.
// Closed forms, by their names: medium.H, medium.slab_multiple, medium.random_walk, medium.tracking_variance.
#include "shaders/medium.h"
#include "shaders/phase.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
struct Slab {
    Mean reflected, transmitted; // fractions of a beam; what passes unscattered counts as transmitted
};
// Isotropic scattering of albedo w in a slab of optical depth tau, under a beam at cosine mu0.
Slab slab(float w, float tau, float mu0, int paths)
{
    Random random;
    Slab result;
    for (int i = 0; i < paths; ++i) {
        double weight = 1.0, depth = 0.0;
        float mu = mu0; // of the direction of flight, downwards
        while (true) {
            depth += double(mu * sampleDistance(1.0f, random.next()));
            if (depth < 0.0 || depth > double(tau)) break;
            weight *= double(w);
            if (weight < 1e-9) break; // absorbed
            mu = samplePhaseHg(0.0f, random.next2()).direction.z;
        }
        result.reflected.add(depth < 0.0 ? weight : 0.0);
        result.transmitted.add(depth > double(tau) ? weight : 0.0);
    }
    return result;
}
}

TEST(MediumWalk, SlabScattersByAllOrders)
{
    struct Row {
        float w, tau, mu0;
        double reflected, transmitted;
    };
    for (const Row& r : {Row{1.0f, 1.0f, 1.0f, 0.3413288, 0.6586712}, Row{0.8f, 2.0f, 0.5f, 0.3571388, 0.1491755}}) {
        Slab found = slab(r.w, r.tau, r.mu0, 400000);
        EXPECT_NEAR(found.reflected.value(), r.reflected, 4.0 * found.reflected.error() + 1e-5 * r.reflected);
        EXPECT_NEAR(found.transmitted.value(), r.transmitted, 4.0 * found.transmitted.error() + 1e-5 * r.transmitted);
    }
}

// A half space of albedo w reflects 1 - sqrt(1 - w) H(mu0) of a beam, H of Chandrasekhar.
TEST(MediumWalk, HalfSpaceReflectsByH)
{
    struct Row {
        float mu0;
        double h, albedo;
    };
    for (const Row& r : {Row{1.0f, 1.85009852, 0.414947479}, Row{0.5f, 1.5560338, 0.507938907}}) {
        Mean reflected = slab(0.9f, kFloatMax, r.mu0, 400000).reflected;
        EXPECT_NEAR(reflected.value(), r.albedo, 4.0 * reflected.error() + 1e-5 * r.albedo);
        double root = std::sqrt(0.1);
        EXPECT_NEAR((1.0 - reflected.value()) / root, r.h, 4.0 * reflected.error() / root + 1e-5 * r.h);
    }
    // Without absorption it reflects all, and walks never end; H is in what a thick slab lets through, up to exp(-tau):
    // H(mu0) / (sqrt 3 (tau + 2 q)), q = 0.710446 (Milne's extrapolation length)
    const float tau = 10.0f;
    Mean through = slab(1.0f, tau, 1.0f, 400000).transmitted;
    double scale = std::sqrt(3.0) * (double(tau) + 2.0 * 0.7104460896);
    EXPECT_NEAR(through.value() * scale, 2.90781053, 4.0 * through.error() * scale + 1e-5 * 2.90781053);
}

// Estimates of exp(-tau) against a majorant: a flight either ends at a real collision (analog), or loses its share at each (ratio).
TEST(MediumWalk, TrackingHasItsClosedVariance)
{
    const float tau = 1.0f, majorant = 2.0f;
    Random random;
    Mean analog, ratio;
    for (int i = 0; i < 400000; ++i) {
        double passed = 1.0, kept = 1.0;
        for (float t = sampleDistance(majorant, random.next()); t < 1.0f; t += sampleDistance(majorant, random.next())) {
            if (random.next() < tau / majorant) passed = 0.0;
            kept *= 1.0 - double(tau / majorant);
        }
        analog.add(passed);
        ratio.add(kept);
    }
    EXPECT_NEAR(analog.value(), double(transmittance(tau, 1.0f)), 4.0 * analog.error());
    EXPECT_NEAR(ratio.value(), double(transmittance(tau, 1.0f)), 4.0 * ratio.error());
    expectRelative(analog.variance(), 0.2325441579, 0.05);
    expectRelative(ratio.variance(), 0.08779487691, 0.05);
}

// Mean squared distance of n flights: 2 / sigma^2 [n / (1-g) - g (1 - g^n) / (1-g)^2].
TEST(MediumWalk, StraysAsFarAsItMust)
{
    struct Row {
        int n;
        float g, sigma;
        double value;
    };
    for (const Row& r : {Row{10, 0.0f, 1.0f, 20.0}, Row{10, 0.9f, 1.0f, 82.76211922}, Row{1, 0.5f, 2.0f, 0.5}}) {
        Random random;
        Mean mean;
        for (int walk = 0; walk < 100000; ++walk) {
            vec3 p(0.0f), d(0, 0, 1);
            for (int k = 0; k < r.n; ++k) {
                p += d * sampleDistance(r.sigma, random.next());
                vec3 local = samplePhaseHg(r.g, random.next2()).direction;
                vec3 t = normalize(std::abs(d.x) > 0.5f ? vec3(-d.z, 0, d.x) : vec3(0, d.z, -d.y));
                d = normalize(t * local.x + cross(d, t) * local.y + d * local.z);
            }
            mean.add(double(dot(p, p)));
        }
        EXPECT_NEAR(mean.value(), r.value, 4.0 * mean.error() + 1e-5 * r.value);
    }
}
}
