// What a rough dielectric interface sends back: the directional albedo of GGX with the exact Fresnel term, bounded from above, so that what
// lies under it never receives light that was already reflected.
// Under a smooth interface the base gets T(mu) = 1 - F(mu). A rough one seen at a grazing angle shows facets that face the eye, and reflects
// far less than F(mu); nowhere does it reflect more than F(mu) + 0.0008. The ratio (albedo / F) is tabulated, by the square root of
// mu, by perceptual roughness and by index. The entries are the least ones (a linear program over 10^5 quadratures) whose
// trilinear interpolation is nowhere below the truth: the excess is 0.001 on average, and large only below mu = 0.02, where F is steep.
#ifndef AFTERGLOW_LAYER_H
#define AFTERGLOW_LAYER_H
#include "shaders/fresnel.h"
SHARED_BEGIN

const int kLayerCosines = 8;     // sqrt(mu) = 0 .. 1
const int kLayerRoughness = 8;   // sqrt(alpha) = 0 .. 1
const int kLayerIndices = 4;     // v = 0 .. 0.75, v^2 = (eta - 1) / (eta + 1): eta = 1, 1.13, 1.67, 3.57
const int kLayerMeanIndices = 7; // the same range
const float kLayerLastIndex = 0.75f;

const float kLayerRatio[256] = {
    1.021f, 1.452f, 1.124f, 1.000f, 1.044f, 1.431f, 3.400f, 5.868f, 0.316f, 0.466f, 0.964f, 1.223f, 1.093f, 1.470f, 3.418f, 5.861f,
    0.029f, 0.063f, 0.273f, 0.871f, 1.275f, 1.674f, 3.522f, 5.841f, 0.000f, 0.000f, 0.062f, 0.331f, 0.802f, 1.596f, 3.672f, 5.846f,
    0.000f, 0.000f, 0.016f, 0.135f, 0.437f, 1.196f, 3.562f, 5.882f, 0.000f, 0.000f, 0.004f, 0.061f, 0.245f, 0.886f, 3.258f, 5.741f,
    0.000f, 0.000f, 0.000f, 0.032f, 0.155f, 0.699f, 2.986f, 5.519f, 0.000f, 0.000f, 0.000f, 0.019f, 0.112f, 0.595f, 2.783f, 5.309f,
    1.062f, 1.238f, 1.110f, 1.000f, 1.000f, 1.000f, 1.001f, 1.006f, 0.684f, 0.731f, 0.930f, 1.011f, 1.020f, 1.011f, 1.012f, 1.005f,
    0.356f, 0.404f, 0.495f, 0.738f, 0.954f, 1.067f, 1.090f, 1.004f, 0.179f, 0.196f, 0.252f, 0.372f, 0.595f, 0.925f, 1.145f, 0.984f,
    0.098f, 0.105f, 0.134f, 0.203f, 0.350f, 0.626f, 1.002f, 0.929f, 0.059f, 0.062f, 0.078f, 0.117f, 0.207f, 0.411f, 0.736f, 0.841f,
    0.041f, 0.042f, 0.050f, 0.073f, 0.130f, 0.269f, 0.527f, 0.601f, 0.031f, 0.031f, 0.034f, 0.048f, 0.085f, 0.180f, 0.358f, 0.404f,
    1.048f, 1.266f, 1.042f, 1.000f, 1.000f, 1.000f, 1.000f, 1.001f, 0.744f, 0.750f, 0.960f, 1.007f, 1.008f, 1.001f, 1.002f, 1.001f,
    0.481f, 0.497f, 0.594f, 0.794f, 0.930f, 1.010f, 1.007f, 0.998f, 0.307f, 0.325f, 0.382f, 0.494f, 0.667f, 0.887f, 1.000f, 0.970f,
    0.208f, 0.219f, 0.259f, 0.339f, 0.478f, 0.697f, 0.869f, 0.886f, 0.156f, 0.162f, 0.188f, 0.246f, 0.353f, 0.543f, 0.695f, 0.703f,
    0.127f, 0.129f, 0.147f, 0.188f, 0.268f, 0.417f, 0.524f, 0.491f, 0.112f, 0.110f, 0.120f, 0.149f, 0.206f, 0.314f, 0.373f, 0.317f,
    1.037f, 1.235f, 1.056f, 1.000f, 1.000f, 1.001f, 1.001f, 1.001f, 0.744f, 0.755f, 0.964f, 1.006f, 1.007f, 1.001f, 1.001f, 1.001f,
    0.508f, 0.554f, 0.684f, 0.896f, 0.979f, 0.993f, 0.995f, 0.997f, 0.406f, 0.454f, 0.583f, 0.745f, 0.858f, 0.918f, 0.953f, 0.965f,
    0.364f, 0.406f, 0.531f, 0.686f, 0.773f, 0.806f, 0.832f, 0.869f, 0.344f, 0.381f, 0.494f, 0.645f, 0.691f, 0.694f, 0.676f, 0.681f,
    0.335f, 0.365f, 0.462f, 0.582f, 0.603f, 0.573f, 0.514f, 0.476f, 0.330f, 0.353f, 0.430f, 0.521f, 0.506f, 0.449f, 0.369f, 0.308f};

// Cosine average of F times the ratio, over that of F alone.
const float kLayerMean[56] = {1.2767f, 0.6819f, 0.2271f, 0.0788f, 0.0388f, 0.0225f, 0.0152f, 0.0119f, 1.1427f, 1.0100f, 0.6793f, 0.3885f,
                              0.2411f, 0.1626f, 0.1205f, 0.0964f, 1.0359f, 0.9801f, 0.7926f, 0.5308f, 0.3486f, 0.2295f, 0.1526f, 0.1021f,
                              1.0172f, 0.9926f, 0.8774f, 0.6788f, 0.5073f, 0.3724f, 0.2686f, 0.1915f, 1.0079f, 0.9958f, 0.9196f, 0.7754f,
                              0.6253f, 0.4854f, 0.3634f, 0.2644f, 1.0052f, 0.9982f, 0.9573f, 0.8653f, 0.7435f, 0.6059f, 0.4694f, 0.3503f,
                              1.0035f, 0.9995f, 0.9769f, 0.9131f, 0.8098f, 0.6744f, 0.5292f, 0.3972f};

// 0 at eta = 1, 1 at infinity; the same from both sides of the interface.
FN float layerIndex(float eta) { return sqrt(abs(eta - 1.0f) / (eta + 1.0f)); }

// Position on an axis of n entries: whole part and fraction.
FN float layerCell(float x, int n) { return min(floor(clamp(x, 0.0f, 1.0f) * float(n - 1)), float(n - 2)); }

FN float layerRow(int index, int rough, int cosine, float f)
{
    int i = (index * kLayerRoughness + rough) * kLayerCosines + cosine;
    return mix(kLayerRatio[i], kLayerRatio[i + 1], f);
}

// Upper bound of (directional albedo / F(mu)); eta >= 1.
FN float layerRatio(float mu, float alpha, float eta)
{
    float v = layerIndex(eta) / kLayerLastIndex;
    if (v > 1.0f) return 1.001f; // Beyond the table: the bound that always holds
    float t = sqrt(clamp(mu, 0.0f, 1.0f)), b = sqrt(clamp(alpha, 0.0f, 1.0f));
    float ti = layerCell(t, kLayerCosines), bi = layerCell(b, kLayerRoughness), vi = layerCell(v, kLayerIndices);
    float tf = t * float(kLayerCosines - 1) - ti, bf = b * float(kLayerRoughness - 1) - bi, vf = v * float(kLayerIndices - 1) - vi;
    int cosine = int(ti), rough = int(bi), index = int(vi);
    float low = mix(layerRow(index, rough, cosine, tf), layerRow(index, rough + 1, cosine, tf), bf);
    float high = mix(layerRow(index + 1, rough, cosine, tf), layerRow(index + 1, rough + 1, cosine, tf), bf);
    return mix(low, high, vf);
}

// Its cosine average over that of F; from below, within 0.005.
FN float layerMeanRatio(float alpha, float eta)
{
    float v = layerIndex(eta) / kLayerLastIndex;
    if (v > 1.0f) return 1.0f;
    float b = sqrt(clamp(alpha, 0.0f, 1.0f));
    float bi = layerCell(b, kLayerRoughness), vi = layerCell(v, kLayerMeanIndices);
    float bf = b * float(kLayerRoughness - 1) - bi, vf = v * float(kLayerMeanIndices - 1) - vi;
    int i = int(vi) * kLayerRoughness + int(bi);
    return mix(mix(kLayerMean[i], kLayerMean[i + 1], bf), mix(kLayerMean[i + kLayerRoughness], kLayerMean[i + kLayerRoughness + 1], bf),
               vf);
}

SHARED_END
#endif
