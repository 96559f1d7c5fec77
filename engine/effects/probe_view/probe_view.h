// What the bake left in the air, made visible: what may be shown, and in which colours.
#ifndef AFTERGLOW_PROBE_VIEW_H
#define AFTERGLOW_PROBE_VIEW_H
#include "shaders/constants.h"
#include "shaders/heat.h"
SHARED_BEGIN

// What is shown.
const uint kShowNothing = 0u;
const uint kShowProbes = 1u;    // spheres where irradiance probes stand, white and matte, in their own light
const uint kShowValidity = 2u;  // the same spheres, coloured by how far they stand from the corner that they are asked for
const uint kShowCells = 3u;     // surfaces, in the colour of the cell whose probes light them
const uint kShowWeights = 4u;   // surfaces, by the largest weight of one of its eight probes
const uint kShowInfluence = 5u; // surfaces, in the colours of the reflection probes that they mirror

struct ProbeMark {
    vec3 position; // world, m
    float radius;  // m
    float moved;   // from its corner, of the cell's diagonal; of all cells that ask it, the most
};

struct ProbeViewFrame {
    mat4 worldToClip;
    mat4 clipToWorld;
    vec4 eye;         // as viewRay() takes it
    vec2 size;        // of the picture, px
    float pixel;      // m, how wide one is: at 1 m of a perspective, everywhere of an orthographic eye
    uint shown;       // kShow...
    uint reflections; // boxes
};

const float kSphereOfCell = 1.0f / 12.0f;  // radius, of the least edge of the cells that ask the probe
const float kSmallestSphere = 2.0f;        // px: a smaller one is not seen
const float kLargestSphere = 1.0f / 16.0f; // of its distance: a larger one would hide the rest

// One of many colours that are told apart, of one brightness to the eye or nearly: neighbours in number lie far apart in hue.
FN vec3 colorOfNumber(uint number)
{
    float turn = fract(float(number % 8192u) * 0.61803399f) * kTwoPi; // by the golden ratio
    return vec3(0.55f) + 0.35f * vec3(cos(turn), cos(turn - kTwoPi / 3.0f), cos(turn + kTwoPi / 3.0f));
}

// Green where a probe stands at its corner, through yellow to red a quarter of the diagonal away.
FN vec3 colorOfMove(float moved)
{
    float x = clamp(4.0f * moved, 0.0f, 1.0f);
    return x < 0.5f ? mix(vec3(0.10f, 0.60f, 0.20f), vec3(0.95f, 0.75f, 0.10f), 2.0f * x)
                    : mix(vec3(0.95f, 0.75f, 0.10f), vec3(0.85f, 0.10f, 0.08f), 2.0f * x - 1.0f);
}

// Form by a lamp at the eye: `facing` is the cosine between normal and eye.
FN float formOf(float facing) { return 0.35f + 0.65f * facing; }

SHARED_END
#endif
