// An emissive triangle as a light: what a sample of it needs, together in memory. Both tracers hold a table of them
// (engine/scene/emitters.cpp), in which each is chosen in proportion to its power.
#ifndef AFTERGLOW_EMITTER_H
#define AFTERGLOW_EMITTER_H
#include "shaders/glsl.h"
SHARED_BEGIN

const uint kEmitterBothSides = 1u;
const uint kEmitterVaries = 2u; // by texture or alpha

struct Emitter {
    vec3 corner;   // world, m
    float density; // probability of the choice / area, 1/m2
    vec3 edge1;    // m, to the second vertex
    float upTo;    // chance that this emitter or one before it is chosen; of the last it is 1
    vec3 edge2;
    uint guide;    // where a choice starts looking: of the i-th emitter the first one whose `upTo` exceeds i / count
    vec3 normal;   // of the front, unit
    uint flags;    // kEmitter...
    vec3 emission; // radiance; of a triangle that varies its factor
    uint triangle; // in the tracer's order
};

SHARED_END
#endif
