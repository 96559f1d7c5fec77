// Spectra against the closed and the summed values of the multi-lobe fit.
#include "shaders/color.h"
#include "shaders/spectrum.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
namespace
{
// XYZ of a black body, by the midpoint rule over 360..830 nm; W m^-2 sr^-1 weighted.
dvec3 blackbodyXyz(float temperature)
{
    dvec3 sum(0.0);
    const double step = 0.25;
    for (double w = 360.0 + step / 2; w < 830.0; w += step)
        sum += dvec3(colorMatching(float(w))) * double(planck(float(w), temperature)) * step * 1e-3;
    return sum;
}
}

TEST(Spectrum, ColorMatchingFit)
{
    struct Row {
        float wavelength;
        dvec3 xyz;
    };
    for (const Row& r : {Row{450, {0.343750028, 0.03341479953, 1.781385039}}, Row{555, {0.5169453266, 0.9979280263, 0.005604848444}},
                         Row{600, {1.055926269, 0.634135928, 4.23135088e-05}}, Row{650, {0.2836318734, 0.1100453433, 2.961158503e-08}}})
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(colorMatching(r.wavelength)[c], r.xyz[c], 1e-7 + 2e-6 * r.xyz[c]) << r.wavelength;
    dvec3 integral(0.0);
    for (double w = 360.05; w < 830.0; w += 0.1) integral += dvec3(colorMatching(float(w))) * 0.1;
    EXPECT_NEAR(integral.x, 106.71446, 0.011);
    EXPECT_NEAR(integral.y, 106.94617, 0.011);
    EXPECT_NEAR(integral.z, 106.85545, 0.011);
}

TEST(Spectrum, Planck)
{
    expectRelative(planck(555.0f, 5778.0f), 25754254.35, 1e-5); // per um
    expectRelative(planck(500.0f, 3000.0f), 260268.3396, 1e-5);
    expectRelative(planck(400.0f, 2856.0f), 39443.78422, 1e-5);
    expectRelative(blackbodyExitance(5778.0f), 63200699.74, 1e-5);
    EXPECT_NEAR(kWienWavelength / 5778.0f, 501.5181646, 5e-3);
    EXPECT_NEAR(kWienFrequency / 5778.0f, 882.5619296, 1e-2);
}

TEST(Spectrum, PlanckIsFiniteEverywhere)
{
    for (float wavelength : {0.0f, 1e-3f, 1.0f, 580.0f, 1e6f})
        for (float temperature : {0.0f, 1.0f, 300.0f, 1e4f, 1e6f}) {
            float b = planck(wavelength, temperature);
            EXPECT_TRUE(std::isfinite(b) && b >= 0.0f) << wavelength << " " << temperature;
        }
    EXPECT_LT(planck(580.0f, 300.0f), 1e-20f); // a body at room temperature does not shine
}

TEST(Spectrum, BlackbodyColours)
{
    struct Row {
        float temperature;
        double x, y, luminance;
    };
    for (const Row& r : {Row{5778, 0.3262013584, 0.3360082489, 1853740996.0}, Row{6500, 0.3133751411, 0.3238564214, 3074431182.0},
                         Row{2856, 0.446229994, 0.4086558608, 19782751.39}}) {
        dvec3 xyz = blackbodyXyz(r.temperature);
        double sum = xyz.x + xyz.y + xyz.z;
        EXPECT_NEAR(xyz.x / sum, r.x, 1e-5);
        EXPECT_NEAR(xyz.y / sum, r.y, 1e-5);
        expectRelative(xyz.y * double(kLuminousEfficacy), r.luminance, 1e-5);
    }
    struct Linear {
        float temperature;
        dvec3 rgb;
    };
    for (const Linear& r :
         {Linear{5778, {1.107739006, 0.9767881134, 0.912607029}}, Linear{1500, {3.171321719, 0.4620676151, -0.066530397}}}) {
        dvec3 xyz = blackbodyXyz(r.temperature);
        vec3 rgb = xyzToRec709(vec3(xyz / xyz.y));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], r.rgb[c], 1e-5 + 1e-4 * std::abs(r.rgb[c])) << r.temperature;
    }
    // lm/W of the whole radiation at 5778 K
    EXPECT_NEAR(blackbodyXyz(5778.0f).y * double(kLuminousEfficacy) / double(blackbodyExitance(5778.0f) * kInvPi), 92.14611733, 1e-2);
}

// Three channels in place of a spectrum: the error of one bounce off a broad reflectance, as it must come out of these functions.
TEST(Spectrum, TrichromaticProductErrs)
{
    struct Row {
        double mu, s, a, b;
        int bounces;
        double luminanceError;
    };
    for (const Row& r :
         {Row{550, 60, 0.1, 0.8, 1, 0.0036082869}, Row{550, 60, 0.1, 0.8, 3, 0.073480734}, Row{620, 10, 0.02, 0.9, 1, -0.031052969}}) {
        dvec3 light(0.0), truth(0.0), reflectance(0.0), white(0.0);
        for (double w = 360.125; w < 830.0; w += 0.25) {
            double rho = r.a + r.b * std::exp(-0.5 * std::pow((w - r.mu) / r.s, 2.0));
            dvec3 cmf(colorMatching(float(w)));
            double source = double(planck(float(w), 5778.0f));
            light += cmf * source;
            truth += cmf * source * std::pow(rho, r.bounces);
            reflectance += cmf * rho;
            white += cmf;
        }
        auto rgb = [](dvec3 xyz) { return dvec3(xyzToRec709(vec3(xyz))); };
        double scale = light.y;
        dvec3 tint = rgb(reflectance / white.y) / rgb(white / white.y), product = rgb(light / scale);
        for (int i = 0; i < r.bounces; ++i) product *= tint;
        double y = double(luminance(vec3(product)));
        EXPECT_NEAR(y / (truth.y / scale) - 1.0, r.luminanceError, 2e-4 * std::abs(r.luminanceError) + 4e-5) << r.mu << " x" << r.bounces;
    }
}
}
