// Spectra against the closed and the summed values of the multi-lobe fit.
#include "shaders/color.h"
#include "shaders/sampling.h"
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
    const double integral[3] = {106.71446, 106.94617, 106.85545}; // nm
    dvec3 sum(0.0);
    for (double w = 360.05; w < 830.0; w += 0.1) sum += dvec3(colorMatching(float(w))) * 0.1;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], integral[c], 2e-5 + 1e-4 * integral[c]);
}

// Where the fit strays most from the CIE 1931 table of 5 nm steps, that table's value, and by how much.
TEST(Spectrum, ColorMatchingFitStraysFromTheTable)
{
    struct Row {
        int channel;
        float wavelength;
        double table, error;
    };
    for (const Row& r : {Row{0, 630, 0.6424, 0.01381063}, Row{1, 620, 0.381, 0.0073081857}, Row{2, 425, 1.03905, 0.022121472}})
        EXPECT_NEAR(std::abs(double(colorMatching(r.wavelength)[r.channel]) - r.table), r.error, 2e-5 + 1e-4 * r.error);
    // So luminous flux, too, is what the table says within 0.0073 of a watt's 683 lm: V(555 nm) is 1, V(510 nm) 0.503, V(780 nm) 1.499e-5
    const double most = 0.0073081857 + 1e-6;
    auto lumen = [](float wavelength, double watt) { return watt * double(kLuminousEfficacy * colorMatching(wavelength).y); };
    EXPECT_NEAR(lumen(555.0f, 1.0), 683.0, 683.0 * most);
    EXPECT_NEAR(lumen(510.0f, 1.0), 343.549, 683.0 * most);
    EXPECT_NEAR(lumen(780.0f, 100.0), 1.023817, 68300.0 * most);
}

TEST(Spectrum, Planck)
{
    auto perMetre = [](float wavelength, float temperature) { return double(planck(wavelength, temperature)) * 1e6; };
    expectRelative(perMetre(555.0f, 5778.0f), 25754254350000.0, 1e-5);
    expectRelative(perMetre(500.0f, 3000.0f), 260268339600.0, 1e-5);
    expectRelative(perMetre(400.0f, 2856.0f), 39443784220.0, 1e-5);
    // In SI units 1 nm would overflow: 2 h c^2 / lambda^5 = 1.19104297e29
    expectRelative(perMetre(1.0f, 1e6f), 1.19104297e29 / std::expm1(14.38776877), 1e-5);
    expectRelative(blackbodyExitance(5778.0f), 63200699.74, 1e-5);
    expectRelative(kWienWavelength / 5778.0f, 501.5181646, 1e-5);
    expectRelative(kWienFrequency / 5778.0f, 882.5619296, 1e-5);
    double visible = 0.0; // 380..780 nm
    for (double w = 380.05; w < 780.0; w += 0.1) visible += double(planck(float(w), 5778.0f)) * 1e-4;
    expectRelative(M_PI * visible / double(blackbodyExitance(5778.0f)), 0.465261107, 1e-5);
}

// A black body of 5778 K with the Sun's radius, seen from 1 au.
TEST(Spectrum, SunIsABlackBodyFarAway)
{
    const double sine = 6.957e8 / 149597870700.0;
    expectRelative(double(blackbodyExitance(5778.0f)) * sine * sine, 1366.831784, 1e-4);
    expectRelative(std::asin(sine) * 180.0 / M_PI, 0.2664531072, 1e-4);
    expectRelative(coneSolidAngle(float(sine)), 6.794310706e-05, 1e-4);
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
        expectRelative(xyz.x / sum, r.x, 1e-5);
        expectRelative(xyz.y / sum, r.y, 1e-5);
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
    expectRelative(blackbodyXyz(5778.0f).y * double(kLuminousEfficacy) / double(blackbodyExitance(5778.0f) * kInvPi), 92.14611733, 1e-4);
}

// Three channels in place of a spectrum: n bounces of a black body's light, of luminance 1, off rho = a + b exp(-((w - mu) / s)^2 / 2); the
// reflectance of a channel is that under equal energy.
TEST(Spectrum, TrichromaticProductErrs)
{
    struct Row {
        double mu, s, a, b;
        int bounces;
        dvec3 spectral, trichromatic;
        double luminanceError, channelError; // the latter over the luminance
    };
    auto rgb = [](dvec3 xyz) { return dvec3(xyzToRec709(vec3(xyz))); };
    auto meets = [](double actual, double expected) { expectRelative(actual, expected, 2e-4, 2e-5); };
    for (const Row& r :
         {Row{550, 60, 0.1, 0.8, 1, {0.56740594, 0.86123702, 0.24830782}, {0.56686117, 0.86548404, 0.24555118}, 0.0036082869, 0.005628845},
          Row{550, 60, 0.1, 0.8, 3, {0.19647451, 0.61833874, -0.0099172191}, {0.14844147, 0.67947965, 0.017777}, 0.073480734, 0.12651273},
          Row{620,
              10,
              0.02,
              0.9,
              1,
              {0.43933212, 0.0024017341, 0.011918156},
              {0.43151248, 0.00059856654, 0.011521023},
              -0.031052969,
              0.081456886}}) {
        SCOPED_TRACE(testing::Message() << "mu " << r.mu << ", " << r.bounces << " bounces");
        dvec3 light(0.0), reflected(0.0), reflectance(0.0), white(0.0);
        for (double w = 360.125; w < 830.0; w += 0.25) {
            double rho = r.a + r.b * std::exp(-0.5 * std::pow((w - r.mu) / r.s, 2.0));
            dvec3 cmf(colorMatching(float(w)));
            double source = double(planck(float(w), 5778.0f));
            light += cmf * source;
            reflected += cmf * source * std::pow(rho, r.bounces);
            reflectance += cmf * rho;
            white += cmf;
        }
        dvec3 spectral = rgb(reflected / light.y), trichromatic = rgb(light / light.y), tint = rgb(reflectance) / rgb(white);
        for (int i = 0; i < r.bounces; ++i) trichromatic *= tint;
        double y = reflected.y / light.y, worst = 0.0;
        for (int c = 0; c < 3; ++c) {
            meets(spectral[c], r.spectral[c]);
            meets(trichromatic[c], r.trichromatic[c]);
            worst = std::max(worst, std::abs(trichromatic[c] - spectral[c]));
        }
        meets(double(luminance(vec3(trichromatic))) / y - 1.0, r.luminanceError);
        meets(worst / y, r.channelError);
    }
}
}
