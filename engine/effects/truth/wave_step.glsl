// A kernel of the wavefront that asks no light: the estimator is compiled in, and its shadow rays are out.
#ifndef AFTERGLOW_TRUTH_WAVE_STEP_GLSL
#define AFTERGLOW_TRUTH_WAVE_STEP_GLSL
#include "engine/effects/truth/wave.glsl"

vec3 unshadowed(Ray ray, vec3 carried) { return carried; }

#endif
