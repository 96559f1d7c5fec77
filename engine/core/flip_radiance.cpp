#include "engine/core/error.hpp"
#include "engine/core/flip.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
using shared::vec3;

// The paper's ACES fit looks at 0.6 of the exposed value.
constexpr float kAcesInput = 0.6f;

struct Exposures {
    float first, last; // log2
    int count;
};

// From the exposure that keeps the reference's brightest pixel below the curve's shoulder to the one that does so for its median
// (2021, section 4.1). Where half the picture is black the median is that of what is lit.
static Exposures exposures(const Image& reference)
{
    std::vector<float> luminances;
    for (std::size_t i = 0; i + 2 < reference.pixels.size(); i += std::size_t(reference.channels)) {
        const float* p = &reference.pixels[i];
        const float luminance = shared::luminance(vec3(p[0], p[1], p[2]));
        if (std::isfinite(luminance)) luminances.push_back(std::max(luminance, 0.0f));
    }
    std::sort(luminances.begin(), luminances.end());
    if (luminances.empty() || luminances.back() <= 0.0f) return {0.0f, 0.0f, 1};
    if (luminances[luminances.size() / 2] <= 0.0f)
        luminances.erase(luminances.begin(), std::upper_bound(luminances.begin(), luminances.end(), 0.0f));
    const float brightest = luminances.back();
    const std::size_t half = luminances.size() / 2;
    const float median = luminances.size() % 2 == 1 ? luminances[half] : 0.5f * (luminances[half - 1] + luminances[half]);

    // The shoulder: acesCurve(v) = 0.85 at v (2.51 v + 0.03) = 0.85 (v (2.43 v + 0.59) + 0.14), a quadratic a v^2 + b v + c = 0.
    constexpr float level = 0.85f, a = 2.51f - level * 2.43f, b = 0.03f - level * 0.59f, c = -level * 0.14f;
    const float shoulder = (-b + std::sqrt(b * b - 4.0f * a * c)) / (2.0f * a) / kAcesInput;
    const float first = std::log2(shoulder / brightest), last = std::log2(shoulder / median);
    return {first, last, std::max(2, int(std::ceil(last - first)))};
}

static Image exposed(const Image& radiance, float exposure)
{
    Image shown = radiance;
    const float factor = std::exp2(exposure) * kAcesInput;
    for (float& v : shown.pixels) v = shared::toneMap(factor * v, shared::kToneAces);
    return shown;
}

Flip flipRadiance(const Image& test, const Image& reference, float pixelsPerDegree)
{
    const Exposures range = exposures(reference);
    Flip flip;
    flip.map = Image(test.width, test.height, 1);
    for (int i = 0; i < range.count; ++i) {
        const float exposure = range.first + (range.last - range.first) * float(i) / float(std::max(1, range.count - 1));
        const Flip one = flipDisplayed(exposed(test, exposure), exposed(reference, exposure), pixelsPerDegree);
        for (std::size_t p = 0; p < one.map.pixels.size(); ++p) flip.map.pixels[p] = std::max(flip.map.pixels[p], one.map.pixels[p]);
    }
    for (float error : flip.map.pixels) flip.mean += double(error);
    flip.mean /= std::max(1.0, double(flip.map.pixels.size()));
    return flip;
}
}
