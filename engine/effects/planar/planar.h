// Planar reflection: where the picture of the eye behind a mirror is looked up.
#ifndef AFTERGLOW_PLANAR_H
#define AFTERGLOW_PLANAR_H
#include "shaders/camera.h"
#include "shaders/frame.h"
SHARED_BEGIN

struct PlanarFrame {
    mat4 clipToWorld;
    vec4 eye;           // w = 1: position; 0: the direction towards an orthographic eye
    mat4 worldToMirror; // clip space of the eye behind the mirror
    mat4 mirrorToWorld;
    vec3 normal;   // of the mirror's plane, on the side of the eye
    vec2 size;     // of the picture, px
    ivec2 corner;  // of the mirror's picture in it, px
    vec2 mirrored; // size of the mirror's picture, px
};

// Specialization constants.
const uint kPlanarRipples = 0u; // a normal map tilts what is mirrored
const uint kPlanarLayers = 1u;  // the layer of what is mirrored is an attachment, too

// Facets that send the light down into the plane: it leaves along it, this sine above.
const float kLeastRise = 0.02f;

// The mirror's picture is flipped in x.
FN vec2 mirroredUv(vec2 pixel, vec2 corner, vec2 size)
{
    vec2 uv = (pixel - corner) / size;
    return vec2(1.0f - uv.x, uv.y);
}

// The direction in which a facet of normal n sends the eye's look, never below the plane.
FN vec3 rippledDirection(vec3 toEye, vec3 n, vec3 plane)
{
    vec3 r = mirrorDirection(toEye, n);
    float rise = dot(r, plane);
    return rise < kLeastRise ? safeNormalize(r + plane * (kLeastRise - rise), plane) : r;
}

// What a smooth mirror shows at the pixel lies `away` m from it. What the tilted direction shows is looked for as far away.
FN vec2 rippledUv(vec3 position, vec3 direction, float away, mat4 worldToMirror, vec2 smooth_)
{
    vec4 clip = worldToMirror * vec4(position + direction * away, 1.0f);
    return clip.w > 0.0f ? ndcToUv(vec2(clip) / clip.w) : smooth_;
}

SHARED_END
#endif
