// Spectra against the closed and the summed values of the multi-lobe fit, and the fit against the CIE's table.
// Closed forms, by their names: color.cmf_fit, color.cmf_fit_vs_table, color.planck, color.blackbody_totals, color.blackbody_xy,
// color.blackbody_linear_srgb, color.luminous_efficacy, color.monochromatic_lumen, color.sun, color.trichromatic_error.
#include "shaders/color.h"
#include "shaders/lightmap.h"
#include "shaders/sampling.h"
#include "shaders/spectrum.h"
#include "tests/shaders/cie_tables.hpp"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>

namespace afterglow::test
{
namespace
{
// XYZ of a black body, by the midpoint rule over 360..830 nm; W m^-2 sr^-1 weighted.
dvec3 integratedXyz(float temperature)
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

TEST(Spectrum, ColorMatchingFitStraysFromTheTable)
{
    dvec3 most(0.0);
    double nm = kTableFirst;
    for (dvec3 seen : kObserver) {
        most = max(most, abs(dvec3(colorMatching(float(nm))) - seen));
        nm += kTableStep;
    }
    const dvec3 strays(0.01381063, 0.0073081857, 0.022121472), integral(106.8657, 106.85704, 106.89332);
    const dvec3 sum = tabledXyz([](double) { return 1.0; });
    for (int c = 0; c < 3; ++c) {
        expectRelative(most[c], strays[c], 1e-4, 2e-5);
        expectRelative(sum[c], integral[c], 1e-4, 2e-5);
    }
}

// Luminous flux of so many watts at one wavelength: exactly by the table; by the fit, off by what that strays.
TEST(Spectrum, Lumen)
{
    struct Row {
        float wavelength;
        double watt, lumen;
    };
    for (const Row& r : {Row{555, 1, 683.0}, Row{510, 1, 343.549}, Row{780, 100, 1.023817}}) {
        const dvec3 seen = kObserver[std::size_t((double(r.wavelength) - kTableFirst) / kTableStep)];
        expectRelative(double(kLuminousEfficacy) * seen.y * r.watt, r.lumen, 1e-5, 1e-6);
        EXPECT_NEAR(double(kLuminousEfficacy * colorMatching(r.wavelength).y) * r.watt, r.lumen, 683.0 * r.watt * 0.0073082);
    }
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
    const double seen = tabledXyz([](double nm) { return double(planck(float(nm), 5778.0f)) * 1e-3; }).y; // W m^-2 sr^-1
    expectRelative(double(kLuminousEfficacy) * seen * M_PI * sine * sine, 125858.5516, 1e-4);             // lx
}

// H92: at wavelength 0, in the cold, and in the heat.
TEST(Spectrum, PlanckIsFiniteEverywhere)
{
    for (float wavelength : {0.0f, 1e-3f, 1.0f, 580.0f, 1e6f})
        for (float temperature : {0.0f, 1.0f, 300.0f, 1e4f, 1e6f}) {
            float b = planck(wavelength, temperature);
            EXPECT_TRUE(std::isfinite(b) && b >= 0.0f) << wavelength << " " << temperature;
        }
    EXPECT_LT(planck(580.0f, 300.0f), 1e-20f); // a body at room temperature does not shine
    EXPECT_EQ(planck(0.0f, 1e4f), 0.0f);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(colorMatching(0.0f)[c]));
    const vec3 cold = blackbodyXyz(300.0f);
    EXPECT_TRUE(cold.y >= 0.0f && std::isfinite(cold.x + cold.y + cold.z));
    EXPECT_EQ(encodeHalf(cold.y * 1e-3f * kLuminousEfficacy), 0u) << "cd m^-2 in a picture";
    expectRelative(blackbodyXyz(1e4f).y * 1e-3f, integratedXyz(1e4f).y, 1e-4);
}

TEST(Spectrum, BlackbodyColours)
{
    struct Row {
        float temperature;
        dvec3 fit, table; // chromaticity and luminance, cd m^-2
    };
    for (const Row& r : {Row{5778, {0.3262013584, 0.3360082489, 1853740996.0}, {0.3264296854, 0.3357222852, 1852420908.0}},
                         Row{6500, {0.3133751411, 0.3238564214, 3074431182.0}, {0.3135252247, 0.3236272859, 3072522593.0}},
                         Row{2856, {0.446229994, 0.4086558608, 19782751.39}, {0.4475348889, 0.4074284196, 19749746.58}}}) {
        const auto meets = [](dvec3 xyz, dvec3 expected) {
            const vec2 xy = chromaticity(vec3(xyz));
            expectRelative(xy.x, expected.x, 1e-5);
            expectRelative(xy.y, expected.y, 1e-5);
            expectRelative(xyz.y * double(kLuminousEfficacy), expected.z, 1e-5);
        };
        meets(integratedXyz(r.temperature), r.fit);
        meets(tabledXyz([&](double nm) { return double(planck(float(nm), r.temperature)) * 1e-3; }), r.table);
        expectRelative(double(blackbodyXyz(r.temperature).y) * 1e-3 * double(kLuminousEfficacy), r.fit.z, 1e-5);
    }
    struct Linear {
        float temperature;
        dvec3 rgb;
    };
    for (const Linear& r :
         {Linear{5778, {1.107739006, 0.9767881134, 0.912607029}}, Linear{1500, {3.171321719, 0.4620676151, -0.066530397}}}) {
        const vec3 rgb = blackbodyColor(r.temperature);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], r.rgb[c], 1e-5 + 1e-4 * std::abs(r.rgb[c])) << r.temperature;
    }
    // lm/W of the whole radiation at 5778 K
    const double whole = double(blackbodyExitance(5778.0f) * kInvPi),
                 tabled = tabledXyz([](double nm) { return double(planck(float(nm), 5778.0f)) * 1e-3; }).y;
    expectRelative(integratedXyz(5778.0f).y * double(kLuminousEfficacy) / whole, 92.14611733, 1e-4);
    expectRelative(tabled * double(kLuminousEfficacy) / whole, 92.08049817, 1e-4);
}

// What the gamut lacks is made up by grey: the luminance stays, the hue's direction stays, no channel is below 0.
TEST(Spectrum, GamutIsMetAtItsBorder)
{
    const vec3 ember = blackbodyColor(1500.0f), shown = intoGamut(ember);
    EXPECT_LT(ember.z, 0.0f);
    EXPECT_EQ(shown.z, 0.0f);
    EXPECT_NEAR(luminance(shown), 1.0f, 1e-6f);
    EXPECT_NEAR((shown.x - 1.0f) / (ember.x - 1.0f), (shown.y - 1.0f) / (ember.y - 1.0f), 1e-5f);
    const vec3 daylit = blackbodyColor(5778.0f);
    EXPECT_EQ(intoGamut(daylit), daylit);
    EXPECT_GE(blackbodyColor(1910.0f).z, 0.0f); // from about 1909 K on
    EXPECT_LT(blackbodyColor(1900.0f).z, 0.0f);
    EXPECT_EQ(intoGamut(vec3(-1.0f, 0.0f, 0.0f)), vec3(0.0f));
    EXPECT_EQ(blackbodyColor(0.0f), vec3(0.0f));
}

// Cost law: the relative error of Y by the step of a sum, of a smooth spectrum and of a band of 10 nm; useless once the step passes the
// band.
TEST(Spectrum, SpectralStep)
{
    const auto smooth = [](double nm) { return double(planck(float(nm), 5778.0f)); };
    const auto band = [&](double nm) { return smooth(nm) * std::exp(-0.5 * std::pow((nm - 620.0) / 10.0, 2.0)); };
    const auto xyzOf = [](auto power, double step) {
        dvec3 sum(0.0);
        for (double nm = 360.0; nm < 830.0; nm += step) sum += dvec3(colorMatching(float(nm))) * power(nm) * step;
        return sum;
    };
    const double steps[] = {5.0, 10.0, 20.0, 40.0};
    const double smoothErrors[] = {9.32400323e-6, 5.25832965e-5, 1.56810190e-4, 5.37463820e-3};
    const double bandErrors[] = {8.97e-12, 5.68e-9, 0.0103290350, 0.536702017};
    const double rounding = 1e-6; // of the fit in floats
    const dvec3 smoothExact = xyzOf(smooth, 0.05), bandExact = xyzOf(band, 0.05);
    double lastShift = 0.0;
    for (int i = 0; i < 4; ++i) {
        const dvec3 coarse = xyzOf(smooth, steps[i]);
        EXPECT_NEAR(std::abs(coarse.y / smoothExact.y - 1.0), smoothErrors[i], rounding) << steps[i];
        EXPECT_NEAR(std::abs(xyzOf(band, steps[i]).y / bandExact.y - 1.0), bandErrors[i], rounding) << steps[i];
        const double shift = double(length(chromaticity(vec3(coarse)) - chromaticity(vec3(smoothExact))));
        EXPECT_GE(shift + double(rounding), lastShift) << steps[i];
        lastShift = shift;
    }
    EXPECT_GT(lastShift, 1e-4);
}

// Between 0 and 1, together 1, at every wavelength that there is and beyond.
TEST(Spectrum, PrimariesShareAllLight)
{
    for (float nm = 0.0f; nm < 2000.0f; nm += 1.0f) {
        const vec3 shares = primarySpectra(nm);
        for (int c = 0; c < 3; ++c) EXPECT_TRUE(shares[c] >= 0.0f && shares[c] <= 1.0f) << nm;
        EXPECT_NEAR(shares.x + shares.y + shares.z, 1.0f, 1e-6f) << nm;
    }
}

// Three channels in place of a spectrum: n bounces of a black body's light, of luminance 1, off rho = a + b exp(-((w - mu) / s)^2 / 2); the
// reflectance of a channel is that under equal energy.
struct Product {
    dvec3 spectral, trichromatic;
    double luminanceError, channelError; // relative; the latter over the luminance
};
static Product productOf(double mu, double s, double a, double b, int bounces)
{
    auto rgb = [](dvec3 xyz) { return dvec3(xyzToRec709(vec3(xyz))); };
    dvec3 light(0.0), reflected(0.0), reflectance(0.0), white(0.0);
    for (double w = 360.125; w < 830.0; w += 0.25) {
        double rho = a + b * std::exp(-0.5 * std::pow((w - mu) / s, 2.0));
        dvec3 cmf(colorMatching(float(w)));
        double source = double(planck(float(w), 5778.0f));
        light += cmf * source;
        reflected += cmf * source * std::pow(rho, bounces);
        reflectance += cmf * rho;
        white += cmf;
    }
    Product p{rgb(reflected / light.y), rgb(light / light.y), 0.0, 0.0};
    for (int i = 0; i < bounces; ++i) p.trichromatic *= rgb(reflectance) / rgb(white);
    const double y = reflected.y / light.y;
    p.luminanceError = double(luminance(vec3(p.trichromatic))) / y - 1.0;
    for (int c = 0; c < 3; ++c) p.channelError = std::max(p.channelError, std::abs(p.trichromatic[c] - p.spectral[c]) / y);
    return p;
}

TEST(Spectrum, TrichromaticProductErrs)
{
    struct Row {
        double mu, s, a, b;
        int bounces;
        Product product;
    };
    auto meets = [](double actual, double expected) { expectRelative(actual, expected, 2e-4, 2e-5); };
    for (const Row& r :
         {Row{550,
              60,
              0.1,
              0.8,
              1,
              {{0.56740594, 0.86123702, 0.24830782}, {0.56686117, 0.86548404, 0.24555118}, 0.0036082869, 0.005628845}},
          Row{550, 60, 0.1, 0.8, 3, {{0.19647451, 0.61833874, -0.0099172191}, {0.14844147, 0.67947965, 0.017777}, 0.073480734, 0.12651273}},
          Row{620,
              10,
              0.02,
              0.9,
              1,
              {{0.43933212, 0.0024017341, 0.011918156}, {0.43151248, 0.00059856654, 0.011521023}, -0.031052969, 0.081456886}}}) {
        SCOPED_TRACE(testing::Message() << "mu " << r.mu << ", " << r.bounces << " bounces");
        const Product p = productOf(r.mu, r.s, r.a, r.b, r.bounces);
        for (int c = 0; c < 3; ++c) {
            meets(p.spectral[c], r.product.spectral[c]);
            meets(p.trichromatic[c], r.product.trichromatic[c]);
        }
        meets(p.luminanceError, r.product.luminanceError);
        meets(p.channelError, r.product.channelError);
    }
}

// Cost law: no convergence but a bias. It grows with each bounce, and as the band narrows.
TEST(Spectrum, TrichromaticErrorGrows)
{
    for (const double mu : {450.0, 550.0, 620.0}) {
        double last = 0.0;
        for (int bounces = 1; bounces <= 8; ++bounces) {
            const double error = productOf(mu, 60.0, 0.1, 0.8, bounces).channelError;
            EXPECT_GT(error, last * 1.1) << mu << " nm, " << bounces << " bounces";
            last = error;
        }
        last = 0.0;
        for (const double width : {160.0, 80.0, 40.0}) {
            const double error = productOf(mu, width, 0.02, 0.9, 1).channelError;
            EXPECT_GT(error, last * 1.5) << mu << " nm, " << width << " nm wide";
            last = error;
        }
    }
}
}
