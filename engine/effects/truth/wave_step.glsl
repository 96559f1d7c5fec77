// What the kernels of the wavefront include but shade.comp: the estimator of theirs hands on no shadow rays.
#ifndef AFTERGLOW_TRUTH_WAVE_STEP_GLSL
#define AFTERGLOW_TRUTH_WAVE_STEP_GLSL
#include "engine/effects/truth/wave.glsl"

vec3 unshadowed(Ray ray, vec3 carried) { return carried; }

#endif
