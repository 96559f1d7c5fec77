// Spherical harmonics: the basis, what nine numbers keep of a light, and what ringing may not do.
#include "shaders/formfactor.h"
#include "shaders/sh.h"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
// Projects a radiance on the sphere by quadrature. A few thousand terms: float sums of more would lose digits.
Sh9 project(const std::function<double(vec3)>& radiance, int rows = 200, int columns = 16)
{
    Sh9 sh = shZero();
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            vec3 d = onSphere(-1.0 + 2.0 * (i + 0.5) / rows, 2.0 * M_PI * (j + 0.5) / columns);
            shAdd(sh, d, vec3(float(radiance(d) * 4.0 * M_PI / (double(rows) * columns))));
        }
    return sh;
}
double irradiance(const Sh9& radiance, vec3 n) { return M_PI * double(shEvaluate(shConvolveCosine(radiance), n).x); }
Sh9 beam(vec3 direction) // unit irradiance on a facing surface
{
    Sh9 sh = shZero();
    shAdd(sh, direction, vec3(1.0f));
    return sh;
}
}

TEST(Sh, BasisMeetsItsValues)
{
    const double expected[9] = {0.2820947918, 0.2611690283, 0.3917535424, 0.1305845141, 0.1560783472,
                                0.4682350417, 0.2928635963, 0.2341175208, -0.1170587604};
    vec3 d = normalize(vec3(1, 2, 3));
    for (int i = 0; i < 9; ++i) EXPECT_NEAR(shBasis(i, d), expected[i], 1e-7 + 1e-5 * std::abs(expected[i]));
}

TEST(Sh, BasisIsOrthonormal)
{
    for (int a = 0; a < 9; ++a)
        for (int b = a; b < 9; ++b)
            EXPECT_NEAR(overSphere([&](vec3 d) { return double(shBasis(a, d)) * double(shBasis(b, d)); }, -1.0, 1.0, 1000, 16),
                        a == b ? 1.0 : 0.0, 1e-5);
}

TEST(Sh, CosineFactorsAndQuadraticForm)
{
    expectRelative(M_PI * double(kShCosine0), 3.141592654, 1e-6);
    expectRelative(M_PI * double(kShCosine1), 2.094395102, 1e-6);
    expectRelative(M_PI * double(kShCosine2), 0.7853981634, 1e-6);
    // c1..c5 of the irradiance matrix: products of a band's factor and its polynomial's constant
    double y2 = double(shBasis(4, normalize(vec3(1, 1, 0)))) * 2.0, y1 = double(shBasis(2, vec3(0, 0, 1))),
           y20 = double(shBasis(6, vec3(0, 0, 1))) / 2.0;
    EXPECT_NEAR(M_PI * double(kShCosine2) * y2 / 2.0, 0.4290427654, 1e-6);
    EXPECT_NEAR(M_PI * double(kShCosine1) * y1 / 2.0, 0.511663354, 1e-6);
    EXPECT_NEAR(M_PI * double(kShCosine2) * y20 * 3.0, 0.7431238683, 1e-6);
    EXPECT_NEAR(M_PI * double(kShCosine0) * double(shBasis(0, vec3(0))), 0.8862269255, 1e-6);
    EXPECT_NEAR(M_PI * double(kShCosine2) * y20, 0.2477079561, 1e-6);
}

TEST(Sh, BeamRingsAsItMustAndTheReadClamps)
{
    Sh9 sh = beam(vec3(0, 0, 1));
    struct Row {
        double cosine, value;
    };
    for (const Row& r : {Row{1, 1.0625}, Row{0.5, 0.4609375}, Row{0, 0.09375}, Row{-0.5333333333333333, -0.03958333333}, Row{-1, 0.0625}})
        EXPECT_NEAR(irradiance(sh, onSphere(r.cosine, 0.7)), r.value, 1e-6 + 1e-5 * std::abs(r.value));
    EXPECT_EQ(shIrradiance(shConvolveCosine(sh), onSphere(-8.0 / 15.0, 0.0)).x, 0.0f);
    Sh9 order1 = shScaleBands(sh, 1.0f, 1.0f, 0.0f);
    EXPECT_NEAR(irradiance(order1, vec3(0, 0, -1)), -0.25, 1e-6);
}

TEST(Sh, WindowIsTheLeastThatKeepsABeamPositive)
{
    auto lowest = [](float lambda) {
        Sh9 sh = shDering(beam(vec3(0, 0, 1)), lambda);
        double low = 1.0;
        for (int i = 0; i <= 2000; ++i) low = std::min(low, irradiance(sh, onSphere(-1.0 + i / 1000.0, 0.0)));
        return low;
    };
    expectRelative(kShWindow, 0.1777318515, 1e-4);
    EXPECT_GE(lowest(kShWindow), -1e-6);
    EXPECT_LT(lowest(kShWindow * 0.98f), -1e-4);
}

TEST(Sh, WholeSkies)
{
    Sh9 uniform = project([](vec3) { return 1.0; });
    EXPECT_NEAR(uniform.c[0].x, 3.544907702, 1e-3);
    EXPECT_NEAR(irradiance(uniform, normalize(vec3(1, -2, 3))), 3.141592654, 1e-3);
    Sh9 gradient = project([](vec3 d) { return 1.0 + 0.5 * double(d.z); });
    EXPECT_NEAR(irradiance(gradient, vec3(0, 0, 1)), 4.188790205, 4e-3);
    Sh9 half = project([](vec3 d) { return d.z > 0.0f ? 1.0 : 0.0; });
    struct Row {
        double cosine, irradiance, radiance;
    };
    for (const Row& r : {Row{1, 3.141592654, 1.25}, Row{0, 1.570796327, 0.5}, Row{-1, 0.0, -0.25}}) {
        EXPECT_NEAR(irradiance(half, onSphere(r.cosine, 0.3)), r.irradiance, 1e-3 * r.irradiance + 1e-5);
        EXPECT_NEAR(shEvaluate(half, onSphere(r.cosine, 0.3)).x, r.radiance, 1e-3 * std::abs(r.radiance) + 1e-5);
    }
    Sh9 cosine = project([](vec3 d) { return double(std::max(d.z, 0.0f)); });
    struct Lobe {
        double cosine, exact, sh;
    };
    for (const Lobe& r : {Lobe{1, 2.094395102, 2.078032641}, Lobe{0, 0.6666666667, 0.6626797004}, Lobe{-1, 0.0, -0.01636246174}}) {
        vec3 n = onSphere(r.cosine, 0.3);
        EXPECT_NEAR(irradiance(cosine, n), r.sh, 1e-3 * std::abs(r.sh) + 1e-5);
        double exact = overSphere([&](vec3 d) { return double(std::max(d.z, 0.0f) * std::max(dot(d, n), 0.0f)); });
        EXPECT_NEAR(exact, r.exact, 1e-3 * r.exact + 1e-5);
    }
}

TEST(Sh, DiscLight)
{
    struct Row {
        double degrees, cosine, exact, value;
    };
    for (const Row& r :
         {Row{30, 1.0, 0.7853981634, 0.8157004983}, Row{30, 0.6, 0.471238898, 0.4545684372}, Row{10, 1.0, 0.09473060975, 0.1003828053}}) {
        // Zonal: one ring of the cap at a time
        Sh9 sh = shZero();
        double edge = std::cos(r.degrees * M_PI / 180.0);
        const int rings = 400, turns = 64;
        for (int i = 0; i < rings; ++i)
            for (int j = 0; j < turns; ++j)
                shAdd(sh, onSphere(edge + (1.0 - edge) * (i + 0.5) / rings, 2.0 * M_PI * (j + 0.5) / turns),
                      vec3(float((1.0 - edge) * 2.0 * M_PI / (double(rings) * turns))));
        EXPECT_NEAR(irradiance(sh, onSphere(r.cosine, 1.0)), r.value, 1e-3 * r.value);
        float sine = float(std::sin(r.degrees * M_PI / 180.0)); // a sphere at distance R / sine looks the same
        expectRelative(M_PI * double(sphereFormFactor(1.0f / sine, float(r.cosine))), r.exact, 1e-5);
    }
}

// Energy of the clamped cosine that order L leaves out: sum over bands of A_l^2 (2l+1) / (4 pi), against its whole, 2 pi / 3.
TEST(Sh, Truncation)
{
    const double a[3] = {M_PI * double(kShCosine0), M_PI * double(kShCosine1), M_PI * double(kShCosine2)},
                 missing[3] = {0.625, 0.125, 0.0078125}, rms[3] = {0.0, 0.3535533906, 0.08838834765};
    double kept = 0.0;
    for (int l = 0; l < 3; ++l) {
        kept += a[l] * a[l] * (2 * l + 1) / (4.0 * M_PI);
        double lost = 1.0 - kept / (2.0 * M_PI / 3.0);
        expectRelative(lost, missing[l], 1e-5);
        if (l > 0) expectRelative(std::sqrt(lost), rms[l], 1e-5);
    }
}
}
