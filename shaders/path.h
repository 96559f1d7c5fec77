// The limits of a path, and the small numbers that the estimator needs; one place, so that both tracers stop alike.
#ifndef AFTERGLOW_PATH_H
#define AFTERGLOW_PATH_H
#include "shaders/constants.h"
#include "shaders/glsl.h"
#include "shaders/scene.h"
SHARED_BEGIN

struct PathSettings {
    uint maxBounces;   // surfaces that scatter; 0: emission and direct light of the first only. Bias of the cut: albedo^(maxBounces + 2)
    uint rouletteFrom; // first bounce after which a path may end by chance
};

const uint kDirectPunctual = 0u; // the categories of light that next-event estimation asks one after another
const uint kDirectEmitter = 1u;
const uint kDirectSky = 2u;
const uint kDirectCategories = 3u;

const float kRouletteCeiling = 0.95f;  // even a white furnace ends
const float kShadowShortening = 1e-4f; // share of the distance by which a shadow ray stops before its light

// Where a ray is inside the box of a medium: (enter, leave) in m, enter >= leave when it is not. Slabs that the ray runs along neither cut
// nor admit it (their reciprocals are infinite of the right sign; a start exactly on a face counts as inside).
FN vec2 mediumInterval(Medium medium, vec3 origin, vec3 direction, float far_)
{
    float enter = 0.0f;
    float leave = far_;
    for (int a = 0; a < 3; a++) {
        if (direction[a] == 0.0f) {
            if (origin[a] < medium.lower[a] || origin[a] > medium.upper[a]) return vec2(0.0f, 0.0f);
            continue;
        }
        float first = (medium.lower[a] - origin[a]) / direction[a];
        float second = (medium.upper[a] - origin[a]) / direction[a];
        enter = max(enter, min(first, second));
        leave = min(leave, max(first, second));
    }
    return vec2(enter, leave);
}

SHARED_END
#endif
