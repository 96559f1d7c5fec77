// Colour: from linear Rec.709, in which everything is computed, to what a display or a file wants, and back.
// Non-finite and negative input is met here: NaN -> 0, +inf -> the curve's end, every display value in [0, 1].
#ifndef AFTERGLOW_COLOR_H
#define AFTERGLOW_COLOR_H
#include "shaders/constants.h"
SHARED_BEGIN

// Rec.709 luminance of a linear colour.
FN float luminance(vec3 c) { return dot(c, vec3(0.2126390059f, 0.7151686788f, 0.0721923154f)); }

// sRGB transfer: linear [0,1] -> code [0,1]; input outside is clamped, NaN becomes 0.
FN float srgbEncode(float x)
{
    float v = x > 0.0f ? min(x, 1.0f) : 0.0f;
    return v <= 0.0031308f ? 12.92f * v : 1.055f * pow(v, 1.0f / 2.4f) - 0.055f;
}
FN float srgbDecode(float code)
{
    float v = code > 0.0f ? min(code, 1.0f) : 0.0f;
    return v <= 0.04045f ? v / 12.92f : pow((v + 0.055f) / 1.055f, 2.4f);
}
FN vec3 srgbEncode(vec3 c) { return vec3(srgbEncode(c.x), srgbEncode(c.y), srgbEncode(c.z)); }
FN vec3 srgbDecode(vec3 c) { return vec3(srgbDecode(c.x), srgbDecode(c.y), srgbDecode(c.z)); }

// What a tone curve accepts: NaN and negatives are 0, anything beyond the largest half is that half.
FN float displayInput(float x) { return x > 0.0f ? min(x, kHalfMax) : 0.0f; }

// Reinhard x / (1 + x), in a form that is 1 at +inf.
FN float reinhardCurve(float x)
{
    float v = x > 0.0f ? x : 0.0f;
    return 1.0f - 1.0f / (1.0f + v);
}
// Reinhard with white at 4, before clamping: x (1 + x/16) / (1 + x); reaches 1 at x = 4.
FN float reinhard4Curve(float x)
{
    float v = displayInput(x);
    return v * (1.0f + v * (1.0f / 16.0f)) / (1.0f + v);
}
// Narkowicz's fit of ACES. Numerator and denominator divided by x^2 above 1: no intermediate exceeds 4, in any precision.
FN float acesCurve(float x)
{
    float v = displayInput(x);
    if (v <= 1.0f) return v * (2.51f * v + 0.03f) / (v * (2.43f * v + 0.59f) + 0.14f);
    float i = 1.0f / v;
    return min((2.51f + 0.03f * i) / (2.43f + i * (0.59f + 0.14f * i)), 1.0f);
}
// Hable's film curve before white: (x(Ax + CB) + DE) / (x(Ax + B) + DF) - E/F with A .15 B .5 C .1 D .2 E .02 F .3. Brought over one
// denominator the constants cancel: x (0.14 x + 1/60) / (x (0.15 x + 0.5) + 0.06), exactly 0 at 0; divided by x^2 above 1.
FN float hablePartial(float x)
{
    if (x <= 1.0f) return x * (0.14f * x + 1.0f / 60.0f) / (x * (0.15f * x + 0.5f) + 0.06f);
    float i = 1.0f / x;
    return (0.14f + i * (1.0f / 60.0f)) / (0.15f + i * (0.5f + 0.06f * i));
}
// 1 at white = 11.2, before clamping; tends to 1.287.
FN float hableCurve(float x) { return hablePartial(displayInput(x)) / hablePartial(11.2f); }

const uint kToneNone = 0u;
const uint kToneReinhard = 1u;
const uint kToneAces = 2u;
const uint kToneHable = 3u;

// Exposed scene colour -> display-linear [0,1], by channel; monotone in each.
FN float toneMap(float x, uint curve)
{
    float y = displayInput(x);
    if (curve == kToneReinhard)
        y = reinhardCurve(y);
    else if (curve == kToneAces)
        y = acesCurve(y);
    else if (curve == kToneHable)
        y = hableCurve(y);
    return clamp(y, 0.0f, 1.0f);
}
FN vec3 toneMap(vec3 c, uint curve) { return vec3(toneMap(c.x, curve), toneMap(c.y, curve), toneMap(c.z, curve)); }

// Factor that an exposure value (EV at ISO 100) puts on luminance: 1 = saturation of the film, m2/cd.
FN float exposureFromEv(float ev) { return 1.0f / (1.2f * exp2(ev)); }

// SMPTE ST 2084 (PQ): luminance in cd/m2 -> code [0,1].
FN float pqEncode(float nits)
{
    const float kM1 = 0.1593017578125f, kM2 = 78.84375f, kC1 = 0.8359375f, kC2 = 18.8515625f, kC3 = 18.6875f;
    float y = pow(clamp(nits > 0.0f ? nits * 1e-4f : 0.0f, 0.0f, 1.0f), kM1);
    return pow((kC1 + kC2 * y) / (1.0f + kC3 * y), kM2);
}

// Linear Rec.709 (D65) <-> CIE XYZ.
FN vec3 rec709ToXyz(vec3 c)
{
    return vec3(0.4123907993f * c.x + 0.3575843394f * c.y + 0.1804807884f * c.z, luminance(c),
                0.0193308187f * c.x + 0.1191947798f * c.y + 0.9505321522f * c.z);
}
FN vec3 xyzToRec709(vec3 c)
{
    return vec3(3.2409699419f * c.x - 1.5373831776f * c.y - 0.4986107603f * c.z,
                -0.9692436363f * c.x + 1.8759675015f * c.y + 0.0415550574f * c.z,
                0.0556300797f * c.x - 0.2039769589f * c.y + 1.0569715142f * c.z);
}

// Linear Rec.2020 (D65), the primaries that a PQ signal goes with, <-> CIE XYZ.
FN vec3 rec2020ToXyz(vec3 c)
{
    return vec3(0.6369580483f * c.x + 0.1446169036f * c.y + 0.1688809752f * c.z,
                0.2627002120f * c.x + 0.6779980715f * c.y + 0.0593017165f * c.z, 0.0280726930f * c.y + 1.0609850577f * c.z);
}
FN vec3 xyzToRec2020(vec3 c)
{
    return vec3(1.7166511880f * c.x - 0.3556707838f * c.y - 0.2533662814f * c.z,
                -0.6666843518f * c.x + 1.6164812366f * c.y + 0.0157685458f * c.z,
                0.0176398574f * c.x - 0.0427706133f * c.y + 0.9421031212f * c.z);
}

SHARED_END
#endif
