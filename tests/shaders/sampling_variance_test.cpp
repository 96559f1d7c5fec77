// What a sample is worth: means and variances in closed form, of multiple importance sampling, of strategies, and of rays that ask how open
// a place is.
#include "shaders/sampling.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
// int_0^1 x^k dx from one sample each of p = 1 and p = 2x: mean and variance in closed form.
TEST(Heuristics, HaveTheirClosedVariance)
{
    struct Row {
        double k, truth, balance, power;
    };
    for (const Row& r : {Row{2, 0.3333333333, 0.01872105861, 0.01817598678}, Row{1, 0.5, 0.01111098815, 0.01325022005}}) {
        Random random;
        Mean balance, power;
        for (int i = 0; i < 400000; ++i) {
            float a = random.next(), b = std::sqrt(random.next());
            auto estimate = [&](auto heuristic) {
                double first = std::pow(double(a), r.k) * double(heuristic(1.0f, 2.0f * a));
                double second = b > 0.0f ? std::pow(double(b), r.k) / (2.0 * double(b)) * double(heuristic(2.0f * b, 1.0f)) : 0.0;
                return first + second;
            };
            balance.add(estimate(balanceHeuristic));
            power.add(estimate(powerHeuristic));
        }
        EXPECT_NEAR(balance.value(), r.truth, 4.0 * balance.error() + 1e-9);
        EXPECT_NEAR(power.value(), r.truth, 4.0 * power.error() + 1e-9);
        expectRelative(balance.variance(), r.balance, 0.05);
        expectRelative(power.variance(), r.power, 0.05);
    }
}

// Estimates of E / pi under a unit sky, and of a disc light by its area and by its solid angle.
TEST(Sampling, VariancesOfStrategies)
{
    Random random;
    Mean cosine, hemisphere, sphere;
    for (int i = 0; i < 400000; ++i) {
        vec2 u = random.next2();
        vec3 c = sampleCosineHemisphere(u);
        cosine.add(double(c.z * kInvPi / cosineHemispherePdf(c.z)));
        hemisphere.add(double(sampleUniformHemisphere(u).z * kInvPi / uniformHemispherePdf()));
        sphere.add(double(std::max(sampleUniformSphere(u).z, 0.0f) * kInvPi / uniformSpherePdf()));
    }
    EXPECT_NEAR(cosine.variance(), 0.0, 1e-9);
    expectRelative(hemisphere.variance(), 0.3333333333, 0.05);
    expectRelative(sphere.variance(), 1.666666667, 0.05);

    struct Row {
        double radius, height, area, solid;
    };
    for (const Row& r : {Row{1, 1, 0.4112335167, 0.02421116893}, Row{2, 0.5, 43.88455079, 1.082997211}}) {
        Mean byArea, bySolidAngle;
        float h = float(r.height), sine = float(r.radius / std::hypot(r.radius, r.height));
        for (int i = 0; i < 400000; ++i) {
            vec2 p = sampleDisc(random.next2()) * float(r.radius);
            float d2 = dot(p, p) + h * h, c = h / std::sqrt(d2);
            byArea.add(double(c / areaPdfToSolidAngle(float(1.0 / (M_PI * r.radius * r.radius)), d2, c)));
            bySolidAngle.add(double(sampleUniformCone(sine, random.next2()).z / uniformConePdf(sine)));
        }
        double truth = M_PI * r.radius * r.radius / (r.radius * r.radius + r.height * r.height);
        EXPECT_NEAR(byArea.value(), truth, 4.0 * byArea.error());
        EXPECT_NEAR(bySolidAngle.value(), truth, 4.0 * bySolidAngle.error());
        expectRelative(byArea.variance(), r.area, 0.05);
        expectRelative(bySolidAngle.variance(), r.solid, 0.05);
    }
}

// Rays about a floor's normal beside walls that reach to infinity: cosine-weighted they see p, and one ray's variance is p (1 - p); evenly
// spread they see the share of the solid angle.
TEST(Sampling, RaysSeeHowOpenAPlaceIs)
{
    struct Place {
        const char* name;
        std::function<bool(vec3)> open;
        double cosine, even;
    };
    // At the inner edge of two planes: the other one rises at an angle from this one's +x side
    auto wedge = [](double degrees) { return [=](vec3 d) { return std::atan2(double(d.z), double(d.x)) < degrees * M_PI / 180.0; }; };
    for (const Place& place :
         {Place{"wedge of 90 degrees", wedge(90.0), 0.5, 0.5}, Place{"wedge of 60 degrees", wedge(60.0), 0.25, 0.3333333333},
          Place{"wedge of 135 degrees", wedge(135.0), 0.8535533906, 0.75},
          Place{"corner of a room", [](vec3 d) { return d.x > 0.0f && d.y > 0.0f; }, 0.25, 0.25}}) {
        SCOPED_TRACE(place.name);
        Random random;
        Mean cosine, even;
        for (int i = 0; i < 200000; ++i) {
            cosine.add(place.open(sampleCosineHemisphere(random.next2())) ? 1.0 : 0.0);
            even.add(place.open(sampleUniformHemisphere(random.next2())) ? 1.0 : 0.0);
        }
        EXPECT_NEAR(cosine.value(), place.cosine, 4.0 * cosine.error() + 1e-5 * place.cosine);
        EXPECT_NEAR(even.value(), place.even, 4.0 * even.error() + 1e-5 * place.even);
        expectRelative(cosine.variance(), place.cosine * (1.0 - place.cosine), 0.05);
    }
}
}
