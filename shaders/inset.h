// A ray that starts on the very edge where two walls meet may leave between them, and the step that takes it off its own wall (offsetRay)
// may take it through the other: far from the origin that step is millimetres long. Such points move into their triangle first.
#ifndef AFTERGLOW_INSET_H
#define AFTERGLOW_INSET_H
#include "shaders/frame.h"
SHARED_BEGIN

// How long that step is, m.
FN float stepOff(vec3 position, vec3 normal) { return distance(offsetRay(position, normal), position); }

// The share of a triangle's height over each side that `inset` m are; a, b and c its corners, in that order. `front`: its normal, as long
// as twice its area, not 0.
FN vec3 insetShares(vec3 a, vec3 b, vec3 c, vec3 front, float inset)
{
    return inset * vec3(length(c - b), length(a - c), length(b - a)) / length(front);
}

// The weights of the second and third corner, those shares or more off its sides. `least`: a third each at the most.
FN vec2 keptOffEdges(vec2 barycentric, vec3 least)
{
    vec3 weight = vec3(1.0f - barycentric.x - barycentric.y, barycentric.x, barycentric.y);
    if (weight.x >= least.x && weight.y >= least.y && weight.z >= least.z) return barycentric;
    vec3 above = max(weight - least, vec3(0.0f)), ones = vec3(1.0f);
    weight = least + above * ((1.0f - dot(least, ones)) / max(dot(above, ones), 1e-6f));
    return vec2(weight.y, weight.z);
}

SHARED_END
#endif
