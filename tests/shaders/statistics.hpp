// How a sampler and a density are judged: integrals over the sphere, chi-square, standard errors. Random numbers of their own, fixed seed.
#pragma once
#include "shaders/constants.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace afterglow::test
{
using namespace shared;

struct Random {
    std::mt19937 engine{20240607u};
    float next() { return float(engine() >> 8u) * (1.0f / 16777216.0f); }
    vec2 next2()
    {
        float x = next();
        return {x, next()};
    }
};

// Mean and its standard error.
struct Mean {
    double sum = 0.0, squares = 0.0;
    double count = 0.0;
    void add(double x)
    {
        sum += x;
        squares += x * x;
        count += 1.0;
    }
    double value() const { return sum / count; }
    double variance() const { return std::max(squares / count - value() * value(), 0.0) * count / (count - 1.0); }
    double error() const { return std::sqrt(variance() / count); }
};

// |actual - expected| <= absolute + relative |expected|: the tolerance of a closed form in float32.
inline void expectRelative(double actual, double expected, double relative, double absolute = 0.0)
{
    EXPECT_NEAR(actual, expected, absolute + relative * std::abs(expected));
}

// Direction by height and azimuth.
inline vec3 onSphere(double z, double phi)
{
    double r = std::sqrt(std::max(1.0 - z * z, 0.0));
    return {float(r * std::cos(phi)), float(r * std::sin(phi)), float(z)};
}
inline vec3 fromDegrees(float theta, float phi)
{
    double t = double(theta) * M_PI / 180.0, p = double(phi) * M_PI / 180.0;
    return {float(std::sin(t) * std::cos(p)), float(std::sin(t) * std::sin(p)), float(std::cos(t))};
}
inline vec3 atCosine(float mu) { return {std::sqrt(std::max(1.0f - mu * mu, 0.0f)), 0.0f, mu}; }

// Integral over the band z in [low, high] of the sphere, midpoint rule.
inline double overSphere(const std::function<double(vec3)>& f, double low = -1.0, double high = 1.0, int rows = 400, int columns = 400)
{
    double sum = 0.0;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) sum += f(onSphere(low + (high - low) * (i + 0.5) / rows, 2.0 * M_PI * (j + 0.5) / columns));
    return sum * (high - low) * 2.0 * M_PI / (double(rows) * columns);
}

// Gauss-Legendre-free mean over [0,1]^2: midpoint rule.
inline double overSquare(const std::function<double(vec2)>& f, int n = 256)
{
    double sum = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += f(vec2((float(i) + 0.5f) / float(n), (float(j) + 0.5f) / float(n)));
    return sum / (double(n) * n);
}

// Deviation of a chi-square sum with k degrees of freedom, in standard normals (Wilson & Hilferty 1931). A right sampler stays below 4.
inline double chiSquareDeviation(double sum, int k)
{
    double v = 2.0 / (9.0 * k);
    return (std::cbrt(sum / k) - (1.0 - v)) / std::sqrt(v);
}

// Counts against expectations; bins that expect fewer than 5 are pooled.
inline double chiSquare(const std::vector<double>& counts, const std::vector<double>& expected)
{
    double sum = 0.0, poolCount = 0.0, poolExpected = 0.0;
    int bins = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < 5.0) {
            poolCount += counts[i];
            poolExpected += expected[i];
            continue;
        }
        sum += (counts[i] - expected[i]) * (counts[i] - expected[i]) / expected[i];
        ++bins;
    }
    if (poolExpected >= 5.0) {
        sum += (poolCount - poolExpected) * (poolCount - poolExpected) / poolExpected;
        ++bins;
    } else if (poolCount > 25.0) {
        return 1e9; // Samples where the density promises none
    }
    return bins > 1 ? chiSquareDeviation(sum, bins - 1) : 0.0;
}

// A sampler of directions against its density. sample(u) returns false when it draws nothing. The deviation, in standard normals.
inline double directionChiSquare(const std::function<bool(Random&, vec3&)>& sample, const std::function<double(vec3)>& pdf,
                                 int count = 200000, double low = -1.0, double high = 1.0)
{
    const int rows = 24, columns = 32, fine = 16;
    const double top = std::acos(high), polar = std::acos(low) - top; // rows of equal angle: lobes at the pole are resolved
    std::vector<double> counts(rows * columns, 0.0), expected(rows * columns, 0.0);
    Random random;
    for (int n = 0; n < count; ++n) {
        vec3 d;
        if (!sample(random, d)) continue;
        double turn = std::atan2(double(d.y), double(d.x)) / (2.0 * M_PI);
        int column = std::min(int((turn < 0.0 ? turn + 1.0 : turn) * columns), columns - 1);
        double row = (std::acos(std::clamp(double(d.z), -1.0, 1.0)) - top) / polar;
        if (row < -1e-4 || row > 1.0001) return 1e9; // a direction out of bounds
        counts[std::size_t(std::clamp(int(row * rows), 0, rows - 1) * columns + column)] += 1.0;
    }
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            double sum = 0.0;
            for (int a = 0; a < fine; ++a) {
                double theta = top + polar * (i + (a + 0.5) / fine) / rows;
                for (int b = 0; b < fine; ++b)
                    sum += pdf(onSphere(std::cos(theta), 2.0 * M_PI * (j + (b + 0.5) / fine) / columns)) * std::sin(theta);
            }
            expected[std::size_t(i * columns + j)] = sum / (double(fine) * fine) * count * polar / rows * 2.0 * M_PI / columns;
        }
    return chiSquare(counts, expected);
}
}
