#include "engine/core/flip.hpp"
#include "engine/core/error.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace afterglow
{
using shared::vec3;
using Plane = std::vector<vec3>; // width * height

// ---- Colour -------------------------------------------------------------------------------------------------------------------------

static vec3 relativeXyz(vec3 rgb) { return shared::rec709ToXyz(rgb) / shared::rec709ToXyz(vec3(1.0f)); }

// Opponent space in which the eye's contrast sensitivity is known: luminance, red-green, blue-yellow (YCxCz).
static vec3 opponent(vec3 rgb)
{
    const vec3 q = relativeXyz(rgb);
    return vec3(116.0f * q.y - 16.0f, 500.0f * (q.x - q.y), 200.0f * (q.y - q.z));
}

static vec3 rgbOfOpponent(vec3 o)
{
    const float y = (o.x + 16.0f) / 116.0f;
    return shared::xyzToRec709(vec3(o.y / 500.0f + y, y, y - o.z / 200.0f) * shared::rec709ToXyz(vec3(1.0f)));
}

// CIE L*a*b* with chroma scaled by lightness (Hunt's effect: dark colours look less colourful).
static vec3 huntLab(vec3 rgb)
{
    const vec3 q = relativeXyz(rgb);
    const auto f = [](float t) {
        constexpr float delta = 6.0f / 29.0f;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3.0f * delta * delta) + 4.0f / 29.0f;
    };
    const float lightness = 116.0f * f(q.y) - 16.0f, chroma = 0.01f * lightness;
    return vec3(lightness, chroma * 500.0f * (f(q.x) - f(q.y)), chroma * 200.0f * (f(q.y) - f(q.z)));
}

// HyAB: city-block in lightness, Euclidean in chroma; made for large differences.
static float hyab(vec3 a, vec3 b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

// ---- Filters ------------------------------------------------------------------------------------------------------------------------

using Kernel = std::vector<vec3>; // 2 * radius + 1 taps, each channel its own

enum class Axis { x, y };

// The border pixel goes on for ever.
static Plane filtered(const Plane& in, int width, int height, const Kernel& kernel, Axis axis)
{
    const int radius = int(kernel.size()) / 2;
    Plane out(in.size());
    parallelFor(std::size_t(height), 0, [&](std::size_t row) {
        const int y = int(row);
        for (int x = 0; x < width; ++x) {
            vec3 sum(0.0f);
            for (int k = -radius; k <= radius; ++k) {
                const int u = axis == Axis::x ? std::clamp(x + k, 0, width - 1) : x;
                const int v = axis == Axis::y ? std::clamp(y + k, 0, height - 1) : y;
                sum += kernel[std::size_t(k + radius)] * in[std::size_t(v) * std::size_t(width) + std::size_t(u)];
            }
            out[row * std::size_t(width) + std::size_t(x)] = sum;
        }
    });
    return out;
}

// The eye's contrast sensitivity as Gaussians in space: a sqrt(pi / b) exp(-(pi d)^2 / b), d in degrees (2020, table 1).
// Luminance and red-green are one Gaussian each; blue-yellow is two.
struct Sensitivity {
    vec3 a, b;
};
static const Sensitivity kNarrow = {vec3(1.0f, 1.0f, 34.1f), vec3(0.0047f, 0.0053f, 0.04f)};
static const Sensitivity kWide = {vec3(0.0f, 0.0f, 13.5f), vec3(1e-5f, 1e-5f, 0.025f)};

static vec3 weight(const Sensitivity& s) { return s.a * sqrt(shared::kPi / s.b); }

static Kernel gaussian(const Sensitivity& s, float pixelsPerDegree)
{
    // Three standard deviations of the widest Gaussian, sigma^2 = b / (2 pi^2)
    const float widest = std::sqrt(kNarrow.b.z / 2.0f) / shared::kPi;
    const int radius = int(std::ceil(3.0f * widest * pixelsPerDegree));
    Kernel kernel;
    for (int x = -radius; x <= radius; ++x) {
        const float d = shared::kPi * float(x) / pixelsPerDegree;
        kernel.push_back(exp(-vec3(d * d) / s.b));
    }
    return kernel;
}

static vec3 total(const Kernel& kernel)
{
    vec3 sum(0.0f);
    for (const vec3& tap : kernel) sum += tap;
    return sum;
}

// What the eye resolves at this distance. A sum of two Gaussians is not separable, each of them is: filter apart, then add.
static Plane resolved(const Plane& in, int width, int height, float pixelsPerDegree)
{
    Kernel narrow = gaussian(kNarrow, pixelsPerDegree), wide = gaussian(kWide, pixelsPerDegree);
    const vec3 narrowSum = total(narrow), wideSum = total(wide);
    const vec3 sum = weight(kNarrow) * narrowSum * narrowSum + weight(kWide) * wideSum * wideSum; // of the 2-D filter: becomes 1
    for (vec3& tap : narrow) tap *= sqrt(weight(kNarrow) / sum);
    for (vec3& tap : wide) tap *= sqrt(weight(kWide) / sum);

    Plane out = filtered(filtered(in, width, height, narrow, Axis::x), width, height, narrow, Axis::y);
    const Plane rest = filtered(filtered(in, width, height, wide, Axis::x), width, height, wide, Axis::y);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += rest[i];
    return out;
}

// Edges and points that the eye finds: lengths of the first and second derivative of luminance (x = edge, y = point).
static Plane features(const Plane& opponents, int width, int height, float pixelsPerDegree)
{
    constexpr float featureWidth = 0.082f; // degrees: of the eye's edge detectors
    const float sigma = 0.5f * featureWidth * pixelsPerDegree;
    const int radius = int(std::ceil(3.0f * sigma));
    Kernel taps; // slope, curvature, mean
    for (int x = -radius; x <= radius; ++x) {
        const float t = float(x) / sigma, g = std::exp(-0.5f * t * t);
        taps.push_back(vec3(-t * g, (t * t - 1.0f) * g, g));
    }
    // Rising and falling parts of a derivative weigh 1 each, so that a full step answers 1.
    vec3 rising(0.0f), falling(0.0f);
    for (const vec3& tap : taps) rising += max(tap, vec3(0.0f)), falling -= min(tap, vec3(0.0f));
    for (vec3& tap : taps)
        for (int c = 0; c < 3; ++c) tap[c] /= tap[c] > 0.0f ? rising[c] : std::max(falling[c], std::numeric_limits<float>::min());

    Plane grey(opponents.size());
    for (std::size_t i = 0; i < grey.size(); ++i) grey[i] = vec3((opponents[i].x + 16.0f) / 116.0f);
    const Plane alongX = filtered(grey, width, height, taps, Axis::x);
    Kernel across, curvature; // slope x mean, curvature x mean, mean x slope; mean x curvature
    for (const vec3& tap : taps) across.push_back(vec3(tap.z, tap.z, tap.x)), curvature.push_back(vec3(tap.y));
    Plane out = filtered(alongX, width, height, across, Axis::y);
    const Plane last = filtered(alongX, width, height, curvature, Axis::y);
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = vec3(std::hypot(out[i].x, out[i].z), std::hypot(out[i].y, last[i].z), 0.0f);
    return out;
}

// ---- LDR-FLIP -----------------------------------------------------------------------------------------------------------------------

static void demandSameSize(const Image& a, const Image& b)
{
    if (a.width != b.width || a.height != b.height) throw Error("cannot compare pictures of different sizes: render both at one size");
    check(a.channels >= 3 && b.channels >= 3, "FLIP looks at colours");
}

static Plane opponents(const Image& image)
{
    Plane plane(std::size_t(image.width) * std::size_t(image.height));
    for (std::size_t i = 0; i < plane.size(); ++i) {
        const float* p = &image.pixels[i * std::size_t(image.channels)];
        const auto shown = [](float v) { return v > 0.0f ? std::min(v, 1.0f) : 0.0f; }; // NaN is black
        plane[i] = opponent(vec3(shown(p[0]), shown(p[1]), shown(p[2])));
    }
    return plane;
}

// Colour difference 0..1: a power brings out small ones, the largest are compressed into the last twentieth (2020, section 4.1.3).
static float colorDifference(vec3 a, vec3 b)
{
    constexpr float exponent = 0.7f, kneeIn = 0.4f, kneeOut = 0.95f;
    static const float largest = std::pow(hyab(huntLab(vec3(0.0f, 1.0f, 0.0f)), huntLab(vec3(0.0f, 0.0f, 1.0f))), exponent);
    const float apart = std::pow(hyab(a, b), exponent), knee = kneeIn * largest;
    return apart < knee ? apart / knee * kneeOut : kneeOut + (apart - knee) / (largest - knee) * (1.0f - kneeOut);
}

Flip flipDisplayed(const Image& test, const Image& reference, float pixelsPerDegree)
{
    demandSameSize(test, reference);
    const int width = test.width, height = test.height;
    const Plane seenTest = opponents(test), seenReference = opponents(reference);
    const Plane colorTest = resolved(seenTest, width, height, pixelsPerDegree);
    const Plane colorReference = resolved(seenReference, width, height, pixelsPerDegree);
    const Plane shapeTest = features(seenTest, width, height, pixelsPerDegree);
    const Plane shapeReference = features(seenReference, width, height, pixelsPerDegree);

    Flip flip;
    flip.map = Image(width, height, 1);
    parallelFor(std::size_t(height), 0, [&](std::size_t y) {
        for (std::size_t i = y * std::size_t(width); i < (y + 1) * std::size_t(width); ++i) {
            const auto lab = [](vec3 o) { return huntLab(clamp(rgbOfOpponent(o), vec3(0.0f), vec3(1.0f))); };
            const float color = colorDifference(lab(colorTest[i]), lab(colorReference[i]));
            const vec3 shapes = abs(shapeTest[i] - shapeReference[i]);
            const float feature = std::sqrt(std::min(std::max(shapes.x, shapes.y) / std::sqrt(2.0f), 1.0f));
            flip.map.pixels[i] = std::pow(color, 1.0f - feature);
        }
    });
    for (float error : flip.map.pixels) flip.mean += double(error);
    flip.mean /= std::max(1.0, double(flip.map.pixels.size()));
    return flip;
}
}
