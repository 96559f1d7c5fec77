// Toon: what may be chosen, and what its pass knows beside the lights (shading.h).
#ifndef AFTERGLOW_TOON_H
#define AFTERGLOW_TOON_H
#include "shaders/tones.h"
SHARED_BEGIN

struct ToonParameters {
    uint steps;    // 1..64, of ramps that the level does not spell out
    uint everyone; // 1: every material that says nothing else is in steps; 0: if the level says so
};
FN ToonParameters defaultToonParameters()
{
    ToonParameters p;
    p.steps = 3u;
    p.everyone = 0u;
    return p;
}

// By material: its steps in the list of all.
struct ToonRamp {
    uint first;
    uint steps; // 0: it answers light as lighting says
};

SHARED_END
#endif
