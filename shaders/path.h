// The limits of a path, and the small numbers that the estimator needs; one place, so that both tracers stop alike.
#ifndef AFTERGLOW_PATH_H
#define AFTERGLOW_PATH_H
#include "shaders/constants.h"
#include "shaders/glsl.h"
#include "shaders/scene.h"
SHARED_BEGIN

struct PathSettings {
    uint maxBounces;    // surfaces that scatter; 0: emission and direct light of the first only. Bias of the cut: albedo^(maxBounces + 2)
    uint maxCollisions; // with media that scatter; 1: single scattering. A walk is long: 10 tau^2 and more
    uint maxVertices;   // of both kinds before the last; 0: emission and direct light of the first vertex only
    uint rouletteFrom;  // first bounce after which a path may end by chance
    uint glow;          // 1: some medium emits
};

FN PathSettings defaultPathSettings() { return PathSettings(64u, 1u << 20u, 1u << 20u, 4u, 0u); }

const uint kDirectPunctual = 0u; // the categories of light that next-event estimation asks one after another
const uint kDirectEmitter = 1u;
const uint kDirectSky = 2u;
const uint kDirectCategories = 3u;

const float kRouletteCeiling = 0.95f;    // even a white furnace ends
const float kCollisionCeiling = 0.9999f; // and a white cloud, whose paths collide 10^4 times at an optical depth of 100
const uint kFreeCollisions = 64u;        // that lose no path but to absorption
const float kShadowShortening = 1e-4f;   // share of the distance by which a shadow ray stops before its light

SHARED_END
#endif
