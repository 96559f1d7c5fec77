// The geometry pass: its variants, and what it leaves (shaders/gbuffer.h).
#ifndef AFTERGLOW_GEOMETRY_H
#define AFTERGLOW_GEOMETRY_H
#include "shaders/gbuffer.h"
SHARED_BEGIN

// Specialization constants of geometry.frag.
const uint kGeometryMasked = 0u;   // alpha >= cutoff keeps
const uint kGeometryEmission = 1u; // the second attachment is there
const uint kGeometryObjects = 2u;  // the third
const uint kGeometryFacets = 3u;   // the fourth

SHARED_END
#endif
