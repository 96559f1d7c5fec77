// The filter of what is traced by few rays: a plane through the values around a pixel, where the noise of the rays explains what is left
// over beside it. What it does not explain, an edge of the light itself, stays: of that the pixel's own value knows best. Linear changes
// are kept exactly, and so is everything where the rays of a pixel agree.
// Based on: James & Stein 1961 (shrinkage by the measured share of noise); Moon et al. 2014, "Adaptive Rendering Based on Weighted Local
// Regression".
#ifndef AFTERGLOW_LOCAL_FIT_H
#define AFTERGLOW_LOCAL_FIT_H
#include "shaders/glsl.h"
SHARED_BEGIN

// Sums over the neighbours that lie on the pixel's surface, by weight. Values are told as what they differ from the pixel's own, four at a
// time.
struct LocalFit {
    float weight;
    vec2 at; // px from the pixel
    float xx, xy, yy;
    vec4 value, square, atX, atY;
};
FN LocalFit emptyFit()
{
    LocalFit f;
    f.weight = f.xx = f.xy = f.yy = 0.0f;
    f.at = vec2(0.0f);
    f.value = f.square = f.atX = f.atY = vec4(0.0f);
    return f;
}
FN void addTo(INOUT(LocalFit) f, float weight, vec2 away, vec4 value)
{
    vec4 weighted = value * weight;
    f.weight += weight;
    f.at += away * weight;
    f.xx += weight * away.x * away.x;
    f.xy += weight * away.x * away.y;
    f.yy += weight * away.y * away.y;
    f.value += weighted;
    f.square += weighted * value;
    f.atX += weighted * away.x;
    f.atY += weighted * away.y;
}

// 5 x 5 pixels weigh 1/2 1 1 1 1/2 along each axis: every one of sixteen pixels that share a sequence (turn.h) counts the same.
const int kFitReach = 2; // px
FN float fitWeight(int x, int y) { return (abs(x) == kFitReach ? 0.5f : 1.0f) * (abs(y) == kFitReach ? 0.5f : 1.0f); }

// What to add to the pixel's own value. `noise`: the variance that its rays leave, as measured around it; where it is 0 nothing is added.
// `frames`: of how many such pictures the mean is shown, which scatters less by their number and is as biased as one.
FN vec4 fitted(LocalFit f, vec4 noise, float frames)
{
    const float kLeastSpread = 0.1f; // px^2: neighbours along a line say nothing of what lies across it
    float share = 1.0f / max(f.weight, 1e-9f);
    vec2 at = f.at * share;
    float xx = f.xx * share - at.x * at.x, xy = f.xy * share - at.x * at.y, yy = f.yy * share - at.y * at.y;
    vec4 mean = f.value * share, atX = f.atX * share - mean * at.x, atY = f.atY * share - mean * at.y;
    float spread = xx * yy - xy * xy;
    vec4 slopeX = vec4(0.0f), slopeY = vec4(0.0f);
    if (spread > kLeastSpread * (xx + yy)) {
        slopeX = (atX * yy - atY * xy) / spread;
        slopeY = (atY * xx - atX * xy) / spread;
    }
    vec4 left = max(f.square * share - mean * mean - slopeX * atX - slopeY * atY, vec4(0.0f));
    vec4 edge = max(left - noise, vec4(0.0f));
    vec4 spared = noise / max(frames * edge + noise, vec4(1e-9f));
    return (mean - slopeX * at.x - slopeY * at.y) * spared;
}

SHARED_END
#endif
