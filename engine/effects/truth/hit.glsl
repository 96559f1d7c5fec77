// A triangle that a ray may meet, as the programs of hits see it.
#ifndef AFTERGLOW_TRUTH_HIT_GLSL
#define AFTERGLOW_TRUTH_HIT_GLSL

hitAttributeEXT vec2 barycentric;
uint triangleMet() { return uint(gl_InstanceCustomIndexEXT + gl_PrimitiveID); }

#endif
