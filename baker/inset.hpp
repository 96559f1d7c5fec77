// A ray that starts on the very edge where two walls meet may leave between them, and the step that takes it off its own wall (offsetRay) may
// take it through the other: far from the origin that step is millimetres long. Such points move into their triangle first.
#pragma once
#include "shaders/frame.h"

namespace afterglow
{
using namespace shared;

// How long that step is, m.
inline float stepOff(vec3 position, vec3 normal) { return distance(offsetRay(position, normal), position); }

// The weights of a triangle's second and third corner, `inset` m or more off its edges, as far as it has room. `front`: its normal, as long
// as twice its area.
inline vec2 keptOffEdges(const vec3 corner[3], vec3 front, vec2 barycentric, float inset)
{
    const float twiceArea2 = dot(front, front), inset2 = inset * inset;
    vec3 weight(1.0f - barycentric.x - barycentric.y, barycentric.x, barycentric.y), least;
    for (int i = 0; i < 3; i++) {
        const vec3 side = corner[(i + 2) % 3] - corner[(i + 1) % 3];
        least[i] = inset2 * dot(side, side); // of the height over that side, times twice the area, squared
    }
    if (all(greaterThanEqual(weight * weight * twiceArea2, least)) || !(twiceArea2 > 0.0f)) return barycentric;
    least = min(sqrt(least / twiceArea2), vec3(1.0f / 3.0f));
    const vec3 above = max(weight - least, vec3(0.0f)), ones(1.0f);
    weight = least + above * ((1.0f - dot(least, ones)) / max(dot(above, ones), 1e-6f));
    return vec2(weight.y, weight.z);
}
}
