// The ray through a pixel: from the eye to what the depth buffer holds there.
#ifndef AFTERGLOW_VIEW_RAY_H
#define AFTERGLOW_VIEW_RAY_H
#include "shaders/camera.h"
SHARED_BEGIN

struct ViewRay {
    vec3 origin;    // the eye, or its plane for an orthographic one
    vec3 direction; // unit, away from the eye
    float distance; // m along it to the surface; kFloatMax: the sky
};

const float kEyeFromNear = 2.0f;

// `eye`: w = 1 its position, w = 0 the direction towards an orthographic eye, w = kEyeFromNear a position too, but the ray begins at the
// near plane. Reversed depth, 0 is the sky.
FN ViewRay viewRay(vec2 uv, float depth, mat4 clipToWorld, vec4 eye)
{
    ViewRay ray;
    ray.distance = kFloatMax;
    if (eye.w > 0.0f) {
        // Depth 0 is a direction, w = 0; or, before an oblique near plane, a point on the way that the eye looks back along, w < 0
        vec4 away = clipToWorld * vec4(uvToNdc(uv), 0.0f, 1.0f);
        ray.origin = eye.w < kEyeFromNear ? vec3(eye) : worldFromDepth(uv, 1.0f, clipToWorld);
        ray.direction = normalize(vec3(away) - vec3(eye) * away.w);
        if (depth > 0.0f) ray.distance = length(worldFromDepth(uv, depth, clipToWorld) - ray.origin);
    } else {
        ray.origin = worldFromDepth(uv, 1.0f, clipToWorld);
        ray.direction = -vec3(eye);
        if (depth > 0.0f) ray.distance = length(worldFromDepth(uv, depth, clipToWorld) - ray.origin);
    }
    return ray;
}

SHARED_END
#endif
