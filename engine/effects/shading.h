// What every pass that lights surfaces knows of the frame, and its variants (shading.glsl).
#ifndef AFTERGLOW_SHADING_H
#define AFTERGLOW_SHADING_H
#include "shaders/glsl.h"
SHARED_BEGIN

struct LightingFrame {
    mat4 clipToWorld;
    vec4 eye;          // w = 1: position; 0: the direction towards an orthographic eye
    vec3 ambient;      // radiance from everywhere, where nothing baked says better
    float skyRotation; // radians about +y
    vec3 skyRadiance;  // uniform sky, or the tint of its image
    vec2 size;         // of the picture, px
};

// Specialization constants: a feature that the level lacks is not in the shader. How many of a thing there are is one, too: a CPU then reads
// an element once for all the pixels that it shades at a time, rather than once for each.
const uint kLightingLightmaps = 0u;   // number of pages; 0: none
const uint kLightingProbes = 1u;      // 0: none
const uint kLightingReflections = 2u; // number of cubemaps; 0: none
const uint kLightingEmission = 3u;
const uint kLightingSunMaps = 4u;      // shadow maps of each sun; 0: nothing casts a shadow
const uint kLightingMedia = 6u;        // that dim the lights on their way
const uint kLightingLayers = 7u;       // the parts of the light go to attachments of their own, too: one of kLayers...
const uint kLightingTraced = 8u;       // the lights' shadows on surfaces were traced
const uint kLightingOcclusion = 9u;    // visibility of the light from everywhere is known
const uint kLightingLights = 10u;      // that the runtime adds
const uint kLightingDirectional = 12u; // lightmaps tell normals apart
const uint kLightingFacets = 13u;      // some metal is rough

const uint kLayersNone = 0u;
const uint kLayersMirrored = 1u; // what the interfaces mirror, alone
const uint kLayersAll = 2u;

SHARED_END
#endif
