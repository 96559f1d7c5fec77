#include "engine/scene/repair.hpp"
#include "shaders/constants.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace afterglow
{
namespace
{
constexpr float kSmallestNormal = std::numeric_limits<float>::min();

float flushed(float value) { return std::abs(value) < kSmallestNormal ? 0.0f : value; }

bool finite(vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

float largest(vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

void count(Dropped& dropped, const char* key, int occurrences)
{
    if (occurrences > 0) dropped[key] += occurrences;
}
}

float clamped(double value, float lower, float upper, Dropped& dropped, const char* key)
{
    if (value >= double(lower) && value <= double(upper)) return flushed(float(value));
    ++dropped[key];
    return value > double(upper) ? upper : lower;
}

vec3 clamped(dvec3 value, float lower, float upper, Dropped& dropped, const char* key)
{
    Dropped found;
    const vec3 result(clamped(value.x, lower, upper, found, key), clamped(value.y, lower, upper, found, key),
                      clamped(value.z, lower, upper, found, key));
    if (!found.empty()) ++dropped[key]; // a colour counts once
    return result;
}

bool degenerate(vec3 a, vec3 b, vec3 c)
{
    // Half a float step of the largest coordinate m is at least m * 2^-25 and at most m * 2^-24; three points that a file means to lie on a
    // line are off it by no more, and a triangle that is one step high is at least m * 2^-24 high: this is the height to tell them apart
    // by.
    constexpr double kFlat = 1.0 / (1 << 24);
    const dvec3 ab = dvec3(b) - dvec3(a), ac = dvec3(c) - dvec3(a), bc = dvec3(c) - dvec3(b);
    const double longest = std::max({length(ab), length(ac), length(bc)});
    const double coordinate = double(std::max({largest(a), largest(b), largest(c)}));
    return !(length(cross(ab, ac)) > longest * coordinate * kFlat);
}

void dropBadTriangles(std::vector<vec3>& positions, std::vector<uint>& corners, Dropped& dropped)
{
    int denormal = 0, notFinite = 0, tooFar = 0, flat = 0;
    for (vec3& p : positions) {
        const vec3 clean(flushed(p.x), flushed(p.y), flushed(p.z));
        if (finite(p) && clean != p) ++denormal;
        p = clean;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const vec3 a = positions[corners[i]], b = positions[corners[i + 1]], c = positions[corners[i + 2]];
        if (!finite(a) || !finite(b) || !finite(c)) {
            ++notFinite;
        } else if (std::max({largest(a), largest(b), largest(c)}) > kLargestCoordinate) {
            ++tooFar;
        } else if (degenerate(a, b, c)) {
            ++flat;
        } else {
            for (int corner = 0; corner < 3; ++corner) corners[kept++] = corners[i + corner];
        }
    }
    corners.resize(kept);
    count(dropped, "denormal coordinates", denormal);
    count(dropped, "triangles with a coordinate that is no number", notFinite);
    count(dropped, "triangles with a coordinate beyond 1e18 m", tooFar);
    count(dropped, "degenerate triangles", flat);
}

void repairRadiance(Image& image, Dropped& dropped)
{
    int bad = 0;
    for (float& value : image.pixels) {
        if (value >= 0.0f && value <= kLargestRadiance) {
            value = flushed(value);
            continue;
        }
        value = !(value > 0.0f) ? 0.0f : std::isfinite(value) ? kLargestRadiance : kHalfMax; // NaN or negative; too large; +inf
        ++bad;
    }
    count(dropped, "sky texels that are no radiance", bad);
}
}
