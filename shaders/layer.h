// What a rough dielectric interface sends back: the directional albedo of GGX with the exact Fresnel term, bounded from above, so that what
// lies under it never receives light that was already reflected.
// Under a smooth interface the base gets T(mu) = 1 - F(mu). A rough one seen at a grazing angle shows facets that face the eye, and
// reflects far less than F(mu); at no index up to 3.5 does it reflect more than F(mu) + 0.0008. The ratio (albedo / F) is tabulated, by the
// square roots of mu and of perceptual roughness and by index. The entries are the least ones (a linear program over 10^5 quadratures)
// whose trilinear interpolation is nowhere below the truth: the excess is 0.001 on average, and large only below mu = 0.02, where F is
// steep.
#ifndef AFTERGLOW_LAYER_H
#define AFTERGLOW_LAYER_H
#include "shaders/fresnel.h"
SHARED_BEGIN

const int kLayerCosines = 8;     // sqrt(mu) = 0 .. 1
const int kLayerRoughness = 8;   // alpha^(1/4) = 0 .. 1
const int kLayerIndices = 4;     // v = 0 .. 0.75, v^2 = (eta - 1) / (eta + 1): eta = 1, 1.13, 1.67, 3.57
const int kLayerMeanIndices = 7; // the same range
const float kLayerLastIndex = 0.75f;
const float kLayerLargestRatio = 1.001f; // beyond the table: the bound that always holds

#ifdef __cplusplus
const float kLayerRatio[256] = {
    1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.001f, 1.142f, 0.957f, 1.003f, 1.059f, 1.455f, 3.372f, 5.956f,
    0.621f, 0.856f, 1.140f, 1.020f, 1.071f, 1.461f, 3.375f, 5.955f, 0.187f, 0.307f, 0.754f, 1.284f, 1.137f, 1.519f, 3.403f, 5.948f,
    0.000f, 0.023f, 0.184f, 0.640f, 1.284f, 1.757f, 3.554f, 5.914f, 0.000f, 0.000f, 0.032f, 0.203f, 0.577f, 1.423f, 3.647f, 5.999f,
    0.000f, 0.000f, 0.004f, 0.058f, 0.235f, 0.873f, 3.169f, 5.917f, 0.000f, 0.000f, 0.000f, 0.021f, 0.117f, 0.613f, 2.745f, 5.421f,
    1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.011f, 1.022f, 0.980f, 1.002f, 1.001f, 1.001f, 1.003f, 1.006f,
    0.862f, 0.954f, 1.063f, 0.999f, 1.001f, 1.003f, 1.005f, 1.005f, 0.579f, 0.615f, 0.814f, 0.979f, 1.054f, 1.020f, 1.024f, 1.005f,
    0.294f, 0.336f, 0.413f, 0.603f, 0.863f, 1.104f, 1.074f, 1.005f, 0.126f, 0.137f, 0.176f, 0.265f, 0.444f, 0.742f, 1.187f, 0.957f,
    0.056f, 0.059f, 0.073f, 0.110f, 0.196f, 0.390f, 0.711f, 0.787f, 0.031f, 0.031f, 0.035f, 0.049f, 0.086f, 0.181f, 0.364f, 0.392f,
    1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 0.989f, 1.021f, 0.986f, 1.002f, 1.001f, 1.001f, 1.001f, 1.001f,
    0.897f, 0.961f, 1.045f, 0.999f, 1.000f, 1.001f, 1.001f, 1.001f, 0.662f, 0.682f, 0.850f, 0.998f, 1.005f, 1.002f, 1.004f, 1.001f,
    0.422f, 0.438f, 0.524f, 0.676f, 0.876f, 1.006f, 1.007f, 0.994f, 0.244f, 0.258f, 0.304f, 0.398f, 0.552f, 0.780f, 0.975f, 0.944f,
    0.151f, 0.156f, 0.182f, 0.237f, 0.341f, 0.525f, 0.664f, 0.696f, 0.112f, 0.110f, 0.121f, 0.150f, 0.207f, 0.315f, 0.372f, 0.318f,
    1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.000f, 1.004f, 1.034f, 0.983f, 1.001f, 1.001f, 1.000f, 1.000f, 1.001f,
    0.879f, 0.948f, 1.053f, 1.000f, 1.001f, 1.001f, 1.001f, 1.001f, 0.664f, 0.682f, 0.866f, 1.017f, 1.001f, 0.999f, 0.999f, 1.001f,
    0.469f, 0.518f, 0.647f, 0.824f, 0.956f, 0.988f, 0.991f, 0.992f, 0.378f, 0.424f, 0.550f, 0.712f, 0.804f, 0.858f, 0.910f, 0.944f,
    0.342f, 0.379f, 0.490f, 0.633f, 0.691f, 0.679f, 0.656f, 0.667f, 0.330f, 0.353f, 0.432f, 0.520f, 0.512f, 0.449f, 0.369f, 0.308f};

// Cosine average of F times the ratio, over that of F alone.
const float kLayerMean[56] = {1.0000f, 1.0631f, 0.9470f, 0.5316f, 0.1617f, 0.0533f, 0.0217f, 0.0122f, 1.0000f, 1.0541f, 1.0765f, 0.9423f,
                              0.5852f, 0.2988f, 0.1573f, 0.0979f, 1.0000f, 0.9985f, 1.0106f, 0.9505f, 0.7164f, 0.4263f, 0.2177f, 0.1030f,
                              1.0000f, 0.9999f, 1.0061f, 0.9769f, 0.8240f, 0.5883f, 0.3573f, 0.1922f, 1.0000f, 1.0003f, 1.0030f, 0.9850f,
                              0.8841f, 0.7011f, 0.4695f, 0.2649f, 1.0000f, 1.0003f, 1.0024f, 0.9921f, 0.9373f, 0.8116f, 0.5906f, 0.3510f,
                              1.0000f, 1.0001f, 1.0019f, 0.9955f, 0.9652f, 0.8714f, 0.6602f, 0.3979f};

#endif

// 0 at eta = 1, 1 at infinity; the same from both sides of the interface.
FN float layerIndex(float eta) { return sqrt(abs(eta - 1.0f) / (eta + 1.0f)); }

// The ratio over the cosine, of one roughness and index: worked out once for all directions that are asked about at a point.
struct LayerRow {
    vec4 grazing; // at sqrt(mu) = 0, 1/7, 2/7, 3/7
    vec4 upright; // at 4/7 .. 1
};

#ifdef __cplusplus
// Position on an axis of n entries: whole part and fraction.
FN float layerCell(float x, int n) { return min(floor(clamp(x, 0.0f, 1.0f) * float(n - 1)), float(n - 2)); }

FN LayerRow layerRow(float alpha, float eta)
{
    float v = layerIndex(eta) / kLayerLastIndex;
    if (v > 1.0f) return {vec4(kLayerLargestRatio), vec4(kLayerLargestRatio)};
    float b = sqrt(sqrt(clamp(alpha, 0.0f, 1.0f)));
    float bi = layerCell(b, kLayerRoughness), vi = layerCell(v, kLayerIndices);
    float bf = b * float(kLayerRoughness - 1) - bi, vf = v * float(kLayerIndices - 1) - vi;
    const float* first = kLayerRatio + (int(vi) * kLayerRoughness + int(bi)) * kLayerCosines;
    float row[kLayerCosines];
    for (int k = 0; k < kLayerCosines; k++) {
        const float *smooth = first + k, *rough = smooth + kLayerCosines, *dense = smooth + kLayerCosines * kLayerRoughness;
        row[k] = mix(mix(smooth[0], rough[0], bf), mix(dense[0], dense[kLayerCosines], bf), vf);
    }
    return {vec4(row[0], row[1], row[2], row[3]), vec4(row[4], row[5], row[6], row[7])};
}

// Its cosine average over that of F; from below, within 0.005.
FN float layerMeanRatio(float alpha, float eta)
{
    float v = layerIndex(eta) / kLayerLastIndex;
    if (v > 1.0f) return 1.0f;
    float b = sqrt(sqrt(clamp(alpha, 0.0f, 1.0f)));
    float bi = layerCell(b, kLayerRoughness), vi = layerCell(v, kLayerMeanIndices);
    float bf = b * float(kLayerRoughness - 1) - bi, vf = v * float(kLayerMeanIndices - 1) - vi;
    int i = int(vi) * kLayerRoughness + int(bi);
    return mix(mix(kLayerMean[i], kLayerMean[i + 1], bf), mix(kLayerMean[i + kLayerRoughness], kLayerMean[i + kLayerRoughness + 1], bf),
               vf);
}
#else
// A shader writes an array of constants anew for every invocation that indexes it, which on a CPU costs eight times the rest of the
// surface: here the tables are textures of the scene's set (engine/upload/layer_tables.cpp), and the hardware's filter interpolates.
layout(set = 0, binding = 13) uniform sampler2DArray layerRatioTable; // grazing, upright
layout(set = 0, binding = 14) uniform sampler2D layerMeanTable;

float layerAxis(float x, int n) { return (clamp(x, 0.0, 1.0) * float(n - 1) + 0.5) / float(n); } // entries are texel centres

LayerRow layerRow(float alpha, float eta)
{
    float v = layerIndex(eta) / kLayerLastIndex;
    if (v > 1.0) return LayerRow(vec4(kLayerLargestRatio), vec4(kLayerLargestRatio));
    vec2 at = vec2(layerAxis(sqrt(sqrt(clamp(alpha, 0.0, 1.0))), kLayerRoughness), layerAxis(v, kLayerIndices));
    return LayerRow(textureLod(layerRatioTable, vec3(at, 0.0), 0.0), textureLod(layerRatioTable, vec3(at, 1.0), 0.0));
}

float layerMeanRatio(float alpha, float eta)
{
    float v = layerIndex(eta) / kLayerLastIndex;
    if (v > 1.0) return 1.0;
    float b = sqrt(sqrt(clamp(alpha, 0.0, 1.0)));
    return textureLod(layerMeanTable, vec2(layerAxis(b, kLayerRoughness), layerAxis(v, kLayerMeanIndices)), 0.0).r;
}
#endif

// Upper bound of (directional albedo / F(mu)): linear between the entries, by the tent of each.
FN float layerRatio(IN(LayerRow) row, float mu)
{
    float t = sqrt(clamp(mu, 0.0f, 1.0f)) * float(kLayerCosines - 1);
    vec4 grazing = max(vec4(1.0f) - abs(vec4(t) - vec4(0.0f, 1.0f, 2.0f, 3.0f)), vec4(0.0f));
    vec4 upright = max(vec4(1.0f) - abs(vec4(t) - vec4(4.0f, 5.0f, 6.0f, 7.0f)), vec4(0.0f));
    return dot(grazing, row.grazing) + dot(upright, row.upright);
}

SHARED_END
#endif
