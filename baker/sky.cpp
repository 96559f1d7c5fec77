// This work is based on: pbrt 4ed 12.5.2 (piecewise-constant distribution over an equirectangular image).
#include "baker/sky.hpp"
#include "shaders/color.h"
#include "shaders/ray.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static vec3 texelAt(const Image& image, int x, int y)
{
    x = (x % image.width + image.width) % image.width;
    const float* p = image.at(x, std::clamp(y, 0, image.height - 1));
    return vec3(p[0], p[1], p[2]);
}

// Solid angle of a texel in row y goes with the sine at the row's middle.
static double rowSine(int y, int height) { return std::sin(double(kPi) * (y + 0.5) / height); }

SkyLight::SkyLight(const Sky& sky) : sky_(sky)
{
    const Image& image = sky.image;
    if (image.pixels.empty()) return;
    rows_.resize(std::size_t(image.height));
    columns_.resize(std::size_t(image.width) * std::size_t(image.height));
    double total = 0.0;
    for (int y = 0; y < image.height; y++) {
        float* columns = &columns_[std::size_t(y) * std::size_t(image.width)];
        double row = 0.0;
        for (int x = 0; x < image.width; x++) {
            row += double(luminance(texelAt(image, x, y)));
            columns[x] = float(row);
        }
        for (int x = 0; x < image.width && row > 0.0; x++) columns[x] /= float(row);
        total += row * rowSine(y, image.height);
        rows_[std::size_t(y)] = float(total);
    }
    if (total > 0.0)
        for (float& row : rows_) row /= float(total);
    else
        rows_.clear();
}

vec3 SkyLight::radiance(vec3 direction) const
{
    const Image& image = sky_.image;
    if (image.pixels.empty()) return sky_.radiance;
    vec2 p = skyUv(direction, sky_.rotation) * vec2(float(image.width), float(image.height)) - vec2(0.5f);
    vec2 cell = floor(p);
    vec2 f = p - cell;
    int x = int(cell.x), y = int(cell.y);
    vec3 upper = mix(texelAt(image, x, y), texelAt(image, x + 1, y), f.x);
    vec3 lower = mix(texelAt(image, x, y + 1), texelAt(image, x + 1, y + 1), f.x);
    return sky_.radiance * mix(upper, lower, f.y);
}

// Index of the first of the cumulative values above u, and where in its step u lies.
static int choose(const float* cumulative, int count, float u, float& inside)
{
    int i = std::min(int(std::upper_bound(cumulative, cumulative + count, u) - cumulative), count - 1);
    float before = i > 0 ? cumulative[i - 1] : 0.0f;
    float step = cumulative[i] - before;
    inside = step > 0.0f ? std::clamp((u - before) / step, 0.0f, 1.0f - 0x1p-24f) : 0.5f;
    return i;
}

LightSample SkyLight::sample(vec2 u) const
{
    LightSample light = noLight();
    if (rows_.empty()) return light;
    const Image& image = sky_.image;
    vec2 inside;
    int y = choose(rows_.data(), image.height, u.y, inside.y);
    int x = choose(&columns_[std::size_t(y) * std::size_t(image.width)], image.width, u.x, inside.x);
    vec2 uv = (vec2(float(x), float(y)) + inside) / vec2(float(image.width), float(image.height));
    light.direction = skyDirection(uv, sky_.rotation);
    light.distance = kRayFar;
    light.delta = 0;
    light.radiance = radiance(light.direction);
    light.pdf = pdf(light.direction);
    return light;
}

float SkyLight::pdf(vec3 direction) const
{
    if (rows_.empty()) return 0.0f;
    const Image& image = sky_.image;
    vec2 uv = skyUv(direction, sky_.rotation);
    int x = std::clamp(int(uv.x * float(image.width)), 0, image.width - 1);
    int y = std::clamp(int(uv.y * float(image.height)), 0, image.height - 1);
    float row = rows_[std::size_t(y)] - (y > 0 ? rows_[std::size_t(y) - 1] : 0.0f);
    const float* columns = &columns_[std::size_t(y) * std::size_t(image.width)];
    float column = columns[x] - (x > 0 ? columns[x - 1] : 0.0f);
    float sine = std::sqrt(std::max(1.0f - direction.y * direction.y, 0.0f));
    if (!(sine > 0.0f)) return 0.0f;
    // p(u, v) = row * column * width * height, d omega = 2 pi^2 sin(theta) du dv
    return row * column * float(image.width) * float(image.height) / (kTwoPi * kPi * sine);
}
}
