#include "engine/app/study/judge.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/display/display.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
constexpr double kDarkest = 0.1; // of the truth's mean: where all is dark, so much more counts as no error

Truth truthOf(Image a, Image b)
{
    check(a.pixels.size() == b.pixels.size(), "two estimates of one truth");
    Truth truth{std::move(a), std::move(b), {}};
    truth.mean = truth.a;
    for (std::size_t i = 0; i < truth.mean.pixels.size(); ++i) truth.mean.pixels[i] = 0.5f * (truth.a.pixels[i] + truth.b.pixels[i]);
    return truth;
}

static double meanOf(const Image& image)
{
    double sum = 0.0;
    for (float value : image.pixels) sum += double(value);
    return sum / double(std::max<std::size_t>(image.pixels.size(), 1));
}

// What a difference at a pixel is divided by, squared. Of both pictures: where one of them alone is bright, as beside a lamp or at a
// stray sample of the path tracer, the error is large and not boundless.
static double weightOf(double picture, double truth, double dark, Measure measure)
{
    if (measure == Measure::values) return 1.0;
    const double bright = measure == Measure::samples ? truth * truth : 0.5 * (picture * picture + truth * truth);
    return bright + dark * dark;
}

static double errorSquared(const Image& picture, const Image& again, const Truth& truth, Measure measure)
{
    check(picture.pixels.size() == truth.mean.pixels.size() && again.pixels.size() == picture.pixels.size(), "pictures of one size");
    const double dark = kDarkest * meanOf(truth.mean);
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.mean.pixels.size(); ++i) {
        const double x = double(picture.pixels[i]), y = double(again.pixels[i]);
        const double weight = weightOf(0.5 * (x + y), double(truth.mean.pixels[i]), dark, measure);
        if (weight > 0.0) sum += (x - double(truth.a.pixels[i])) * (y - double(truth.b.pixels[i])) / weight;
    }
    return sum / double(std::max<std::size_t>(truth.mean.pixels.size(), 1));
}

double errorOf(const Image& picture, const Image& again, const Truth& truth, Measure measure)
{
    return std::sqrt(std::max(errorSquared(picture, again, truth, measure), 0.0));
}

double noiseOf(const Truth& truth) { return 0.5 * std::sqrt(errorSquared(truth.a, truth.a, truthOf(truth.b, truth.b), Measure::radiance)); }

// As the frame's display pass does it: middle grey for the mean of the logarithms.
Exhibit exhibitFor(const Image& reference, const DisplayParameters& display)
{
    Exhibit exhibit;
    exhibit.curve = uint(display.curve);
    if (display.exposureEv) {
        exhibit.exposure = exposureFromEv(*display.exposureEv);
        return exhibit;
    }
    double logs = 0.0, counted = 0.0;
    for (std::size_t i = 0; i + 2 < reference.pixels.size(); i += std::size_t(reference.channels)) {
        const float bright = luminance(vec3(reference.pixels[i], reference.pixels[i + 1], reference.pixels[i + 2]));
        if (bright > kDarkestCounted) logs += std::log2(double(bright)), counted += 1.0;
    }
    if (counted > 0.0) exhibit.exposure = kMiddleGrey / float(std::exp2(logs / counted));
    return exhibit;
}

Image shown(const Image& picture, const Exhibit& exhibit)
{
    Image out(picture.width, picture.height, 3);
    for (std::size_t i = 0; i < std::size_t(picture.width) * std::size_t(picture.height); ++i)
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = picture.pixels[i * std::size_t(picture.channels) + std::min(c, std::size_t(picture.channels - 1))];
            out.pixels[3 * i + c] = exhibit.values ? std::clamp(value, 0.0f, 1.0f) : toneMap(exhibit.exposure * value, exhibit.curve);
        }
    return out;
}
}
