// Colour facts: transfer curves, tone curves, PQ, matrices, and what becomes of NaN and infinity.
// Closed forms, by their names: color.rgb_to_xyz, color.srgb_transfer, color.normalised_chromaticity.
#include "shaders/color.h"
#include "tests/shaders/statistics.hpp"
#include <gtest/gtest.h>
#include <limits>

namespace afterglow::test
{
namespace
{
const float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

// Columns are what the primaries are in XYZ, and the way back leads back.
void expectMatrix(vec3 (*toXyz)(vec3), vec3 (*fromXyz)(vec3), const double (&m)[3][3])
{
    for (int c = 0; c < 3; ++c) {
        vec3 unit(0.0f);
        unit[c] = 1.0f;
        vec3 xyz = toXyz(unit), back = fromXyz(xyz);
        for (int r = 0; r < 3; ++r) {
            EXPECT_NEAR(xyz[r], m[r][c], 5e-7);
            EXPECT_NEAR(back[r], unit[r], 1e-6);
        }
    }
}
}

TEST(Color, SrgbTransferMeetsTheStandard)
{
    expectRelative(srgbEncode(0.0031308f), 0.040449936, 2e-6, 1e-7);
    expectRelative(srgbEncode(0.18f), 0.4613561295, 2e-6, 1e-7);
    expectRelative(srgbEncode(0.5f), 0.7353569831, 2e-6, 1e-7);
    for (int code = 0; code < 256; ++code) EXPECT_EQ(std::lround(srgbEncode(srgbDecode(float(code) / 255.0f)) * 255.0f), code);
}

TEST(Color, SrgbSwallowsWhatIsNoColour)
{
    EXPECT_EQ(srgbEncode(-0.0396f), 0.0f);
    EXPECT_EQ(srgbEncode(kNan), 0.0f);
    EXPECT_FLOAT_EQ(srgbEncode(kInfinity), 1.0f);
    EXPECT_EQ(srgbDecode(kNan), 0.0f);
    EXPECT_FLOAT_EQ(srgbDecode(2.0f), 1.0f);
}

TEST(Color, ChromaticityOfCodesIsNotThatOfLight)
{
    struct Swatch {
        vec3 codes;
        double red, green;
    };
    for (const Swatch& s : {Swatch{{36, 228, 228}, 0.0112420235, 0.4943789882}, Swatch{{18, 114, 114}, 0.01765630873, 0.4911718456},
                            Swatch{{9, 57, 57}, 0.03230456277, 0.4838477186}}) {
        vec3 codes = s.codes / (s.codes.x + s.codes.y + s.codes.z);
        EXPECT_NEAR(codes.x, 0.07317073171, 1e-6);
        EXPECT_NEAR(codes.y, 0.4634146341, 1e-6);
        vec3 light = srgbDecode(s.codes / 255.0f);
        light /= light.x + light.y + light.z;
        EXPECT_NEAR(light.x, s.red, 1e-6);
        EXPECT_NEAR(light.y, s.green, 1e-6);
    }
}

TEST(Color, MatricesOfTheirPrimaries)
{
    const double rec709[3][3] = {{0.4123907993, 0.3575843394, 0.1804807884},
                                 {0.2126390059, 0.7151686788, 0.07219231536},
                                 {0.01933081872, 0.1191947798, 0.9505321522}};
    const double rec2020[3][3] = {
        {0.6369580483, 0.1446169036, 0.1688809752}, {0.262700212, 0.6779980715, 0.05930171647}, {0.0, 0.02807269305, 1.060985058}};
    expectMatrix(rec709ToXyz, xyzToRec709, rec709);
    expectMatrix(rec2020ToXyz, xyzToRec2020, rec2020);
    EXPECT_NEAR(luminance(vec3(1, 0, 0)), rec709[1][0], 1e-7);
    EXPECT_NEAR(luminance(vec3(0, 1, 0)), rec709[1][1], 1e-7);
    EXPECT_NEAR(luminance(vec3(0, 0, 1)), rec709[1][2], 1e-7);
    vec3 white = xyzToRec2020(rec709ToXyz(vec3(1.0f))); // one white
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(white[c], 1.0f, 1e-6f);
}

TEST(Color, ToneCurvesMeetTheirValues)
{
    struct Row {
        float x;
        double reinhard, reinhard4, aces, hable;
    };
    for (const Row& r :
         {Row{0.18f, 0.1525423729, 0.1542584746, 0.2668989204, 0.06710982928}, Row{1.0f, 0.5, 0.53125, 0.8037974684, 0.3043005615},
          Row{16.0f, 0.9411764706, 1.882352941, 1.0, 1.071748021}, Row{65504.0f, 0.999984734, 4094.937486, 1.0, 1.287063474}}) {
        expectRelative(reinhardCurve(r.x), r.reinhard, 1e-5);
        expectRelative(reinhard4Curve(r.x), r.reinhard4, 1e-5);
        expectRelative(acesCurve(r.x), r.aces, 1e-5);
        expectRelative(hableCurve(r.x), r.hable, 1e-5);
    }
}

TEST(Color, ToneCurvesStayInTheDisplayAndRise)
{
    for (uint curve : {kToneNone, kToneReinhard, kToneAces, kToneHable}) {
        EXPECT_EQ(toneMap(0.0f, curve), 0.0f);
        EXPECT_EQ(toneMap(-1.0f, curve), 0.0f);
        EXPECT_EQ(toneMap(kNan, curve), 0.0f);
        EXPECT_NEAR(toneMap(kInfinity, curve), 1.0f, 2e-5);
        EXPECT_NEAR(toneMap(65504.0f, curve), 1.0f, 2e-5);
        float last = 0.0f;
        for (float x = 1e-6f; x < 1e6f; x *= 1.01f) {
            float y = toneMap(x, curve);
            EXPECT_GE(y, last - 1e-6f) << x;
            EXPECT_LE(y, 1.0f);
            last = y;
        }
    }
    EXPECT_FLOAT_EQ(reinhardCurve(kInfinity), 1.0f);
    // In halves x (2.51 x + 0.03) is infinite at x = 200
    expectRelative(acesCurve(200.0f), std::min(100406.0 / (200.0 * (2.43 * 200.0 + 0.59) + 0.14), 1.0), 1e-6);
}

TEST(Color, ExposureAndPq)
{
    expectRelative(exposureFromEv(0.0f), 0.8333333333, 1e-6);
    expectRelative(exposureFromEv(15.0f), 2.54313151e-05, 1e-6);
    expectRelative(pqEncode(100.0f), 0.5080784215, 1e-5);
    expectRelative(pqEncode(1000.0f), 0.7518270962, 1e-5);
    expectRelative(pqEncode(10000.0f), 1.0, 1e-5);
    EXPECT_GE(pqEncode(kNan), 0.0f);
}
}
