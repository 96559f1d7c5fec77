// The smallest level that shaders/emitter_choice.h can be compiled with: nothing shines.
#ifndef AFTERGLOW_TEST_DIALECT_EMITTER_CHOICE_H
#define AFTERGLOW_TEST_DIALECT_EMITTER_CHOICE_H
#include "shaders/emitter.h"
SHARED_BEGIN

struct EmitterSet {
    uint count;
};

FN uint emitterCount(EmitterSet) { return 0u; }
FN Emitter emitterAt(EmitterSet, uint)
{
    Emitter nothing;
    return nothing;
}
FN float emitterDensity(EmitterSet, uint) { return 0.0f; }
FN vec3 emissionAt(EmitterSet, uint, vec2) { return vec3(0.0f); }

SHARED_END
#endif
