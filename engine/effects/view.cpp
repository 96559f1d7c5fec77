#include "engine/effects/view.hpp"
#include <algorithm>
#include <limits>

namespace afterglow
{
View makeView(const Camera& camera, uvec2 shown, const FrameSample& sample)
{
    View view;
    view.size = sample.drawn == uvec2(0) ? shown : sample.drawn;
    view.frame = sample.frame;
    view.jitter = sample.jitter;
    view.textureBias = sample.textureBias;
    view.mayStray = sample.mayStray;
    const bool perspective = camera.fovY > 0.0f;
    view.eye = perspective ? vec4(vec3(camera.toWorld[3]), 1.0f) : vec4(normalize(vec3(camera.toWorld[2])), 0.0f);
    // In double: far from the origin the product of two float inverses would tremble
    view.steady = dmat4(projection(camera, shown)) * inverse(dmat4(camera.toWorld));
    view.last = view.steady;
    view.worldToClip = mat4(jittered(view));
    view.clipToWorld = mat4(inverse(jittered(view)));
    return view;
}

View centred(View view, uvec2 size)
{
    view.size = size;
    view.jitter = vec2(0.0f);
    view.textureBias = 0.0f;
    view.worldToClip = mat4(view.steady);
    view.clipToWorld = mat4(inverse(view.steady));
    return view;
}

dmat4 jittered(const View& view)
{
    dmat4 toCentre(1.0);
    toCentre[3] = dvec4(-2.0 * dvec2(view.jitter) / dvec2(view.size), 0.0, 1.0); // what lies at the sample comes to the pixel's centre
    return toCentre * view.steady;
}

namespace
{
vec3 cornerOf(const vec3& lower, const vec3& upper, int corner)
{
    return vec3(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y, corner & 4 ? upper.z : lower.z);
}
}

bool mayBeSeen(const mat4& worldToClip, const vec3& lower, const vec3& upper)
{
    int outside[5] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const vec4 c = worldToClip * vec4(cornerOf(lower, upper, corner), 1.0f);
        outside[0] += c.x < -c.w;
        outside[1] += c.x > c.w;
        outside[2] += c.y < -c.w;
        outside[3] += c.y > c.w;
        outside[4] += c.z > c.w;
    }
    for (int count : outside)
        if (count == 8) return false;
    return true;
}

// z < w beyond the near plane; at the eye w = 0 <= z.
bool isBeyondNear(const mat4& worldToClip, const vec3& lower, const vec3& upper)
{
    for (int corner = 0; corner < 8; ++corner) {
        const vec4 c = worldToClip * vec4(cornerOf(lower, upper, corner), 1.0f);
        if (!(c.z < c.w)) return false;
    }
    return true;
}

// With rows X, Y, W of worldToClip a point p is drawn at u = X p / W p, and a step d moves it by (X - u W) d / W p, where |u| <= 1.
float pixelsPerMetre(const View& view, const vec3& lower, const vec3& upper)
{
    const auto row = [&](int i) { return vec3(view.worldToClip[0][i], view.worldToClip[1][i], view.worldToClip[2][i]); };
    float nearest = std::numeric_limits<float>::infinity();
    for (int corner = 0; corner < 8; ++corner)
        nearest = std::min(nearest, dot(row(3), cornerOf(lower, upper, corner)) + view.worldToClip[3][3]);
    if (!(nearest > 0.0f)) return std::numeric_limits<float>::infinity();
    const auto longest = [&](int axis) { return std::max(length(row(axis) - row(3)), length(row(axis) + row(3))); };
    return 0.5f * std::max(float(view.size.x) * longest(0), float(view.size.y) * longest(1)) / nearest;
}

static vec3 clipRow(const View& view, int row)
{
    return vec3(view.worldToClip[0][row], view.worldToClip[1][row], view.worldToClip[2][row]);
}

vec2 metresOfDepth(const View& view)
{
    // Clip z is the near distance of a perspective, whose w is the distance; a share of the depth of an orthographic box
    if (view.eye.w > 0.0f) return vec2(float((dmat4(view.worldToClip) * dvec4(view.eye)).z), 0.0f);
    return vec2(0.0f, 1.0f / length(clipRow(view, 2)));
}

float pixelWidth(const View& view) { return 2.0f / (float(view.size.y) * length(clipRow(view, 1))); }
}
