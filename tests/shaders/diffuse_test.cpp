// Matte surfaces: the printed Oren-Nayar with its loss, and the energy-preserving one without.
#include "shaders/diffuse.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
TEST(OrenNayar, PrintedFormMeetsItsValues)
{
    struct Row {
        float sigma, mu;
        double a, b, e;
    };
    for (const Row& r : {Row{0.3f, 1.0f, 0.8928571429, 0.225, 0.8928571429}, Row{0.5f, 0.5f, 0.7844827586, 0.3308823529, 0.8831284199},
                         Row{0.5f, 0.1f, 0.7844827586, 0.3308823529, 0.9386238739}}) {
        expectRelative(orenNayarA(r.sigma), r.a, 1e-5);
        expectRelative(orenNayarB(r.sigma), r.b, 1e-5);
        expectRelative(orenNayarAlbedo(r.sigma, r.mu), r.e, 1e-5);
        double integral = overSphere([&](vec3 i) { return double(orenNayar(r.sigma, atCosine(r.mu), i) * i.z); }, 0.0, 1.0, 1000, 500);
        EXPECT_NEAR(integral, r.e, 1e-4);
    }
    double average = 0.0;
    for (int i = 0; i < 2000; ++i) {
        double mu = (i + 0.5) / 2000.0;
        average += 2.0 * mu * double(orenNayarAlbedo(0.5f, float(mu))) / 2000.0;
    }
    expectRelative(average, 0.8552781063, 1e-5);
}

TEST(Eon, MeetsItsValues)
{
    struct Row {
        float mi, mo, degrees, r, rho;
        double e, fon, f;
    };
    for (const Row& c :
         {Row{0.5f, 0.8f, 0, 1, 0.8f, 0.7751239171, 0.8653195483, 0.3579203345}, Row{1e-7f, 0.5f, 0, 1, 0.9f, 0.9, 1.0, 0.6077643338},
          Row{0.1f, 0.3f, 150, 0.5f, 1, 1.0, 0.9855373318, 0.1661170902}}) {
        double phi = double(c.degrees) * M_PI / 180.0;
        vec3 i = onSphere(double(c.mi), phi), o = onSphere(double(c.mo), 0.0);
        expectRelative(fonAlbedo(c.r, c.mi), c.fon, 1e-5);
        expectRelative(eonAlbedo(vec3(c.rho), c.r, c.mi).x, c.e, 1e-5);
        expectRelative(eon(vec3(c.rho), c.r, o, i).x, c.f, 1e-5);
    }
    // The horizon itself: the lobe's (S / mu)(1 - S^3) is 0 / 0 there, the lobe pi/2 - 2/3
    expectRelative(fonAlbedo(1.0f, 0.0f), double(fonA(1.0f)) * (1.0 + 0.90412966 / M_PI), 1e-6);
    expectRelative(eonAlbedo(vec3(0.9f), 1.0f, 0.0f).x, 0.9, 1e-5);
    EXPECT_EQ(fonAlbedo(1.0f, std::nextafter(1.0f, 2.0f)), fonAlbedo(1.0f, 1.0f)); // a cosine that rounding took above 1
}

// H48: A + r A (1/2 - 2 / (3 pi)) along the horizon, where (S / mu)(1 - S^3) is 0 / 0: 1, at any roughness, that of sigma 1.5 among them.
TEST(Eon, AlongTheHorizonTheFujiiAlbedoIsOne)
{
    for (float r : {0.0f, 0.3f, eonRoughness(1.5f), 1.0f}) {
        const double a = double(fonA(r));
        expectRelative(fonAlbedo(r, 0.0f), a + double(r) * a * (0.5 - 2.0 / (3.0 * M_PI)), 1e-6);
        expectRelative(fonAlbedo(r, 0.0f), 1.0, 1e-6);
        EXPECT_TRUE(std::isfinite(eon(vec3(1.0f), r, vec3(1, 0, 0), vec3(0, 0, 1)).x));
    }
}

TEST(Eon, AWhiteSurfaceReturnsEverything)
{
    for (float r : {0.0f, 1e-4f, 0.3f, 1.0f})
        for (float mu : {0.0f, 1e-3f, 0.1f, 0.5f, 1.0f}) {
            EXPECT_NEAR(eonAlbedo(vec3(1.0f), r, mu).x, 1.0f, 1e-5f);
            if (mu < 0.05f) continue;
            double integral = overSphere([&](vec3 i) { return double(eon(vec3(1.0f), r, atCosine(mu), i).x * i.z); }, 0.0, 1.0, 1000, 500);
            EXPECT_NEAR(integral, 1.0, 5e-4) << r << " " << mu;
        }
}

// H48: sigma 0 is Lambert.
TEST(Eon, IsReciprocalAndFiniteAndLambertAtZero)
{
    Random random;
    for (int k = 0; k < 10000; ++k) {
        vec3 i = onSphere(double(random.next()), 6.28 * double(random.next())),
             o = onSphere(double(random.next()), 6.28 * double(random.next()));
        float a = eon(vec3(0.7f), 0.6f, o, i).x, b = eon(vec3(0.7f), 0.6f, i, o).x;
        EXPECT_NEAR(a, b, 1e-4f * std::abs(a) + 1e-6f);
        EXPECT_TRUE(std::isfinite(a) && a >= 0.0f);
        EXPECT_FLOAT_EQ(eon(vec3(0.7f), 0.0f, o, i).x, i.z > 0.0f && o.z > 0.0f ? 0.7f * kInvPi : 0.0f);
    }
    EXPECT_EQ(eon(vec3(1.0f), 1.0f, vec3(1, 0, 0), vec3(1, 0, 0)).x, 0.0f); // the horizon itself
    EXPECT_EQ(eonRoughness(0.0f), 0.0f);
    EXPECT_LE(eonRoughness(1.5f), 1.0f);
}
}
