// The ray through a pixel: from the eye to what the depth buffer holds there.
#ifndef AFTERGLOW_VIEW_RAY_H
#define AFTERGLOW_VIEW_RAY_H
#include "shaders/camera.h"
#include "shaders/frame.h"
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

FN vec3 directionToEye(vec3 position, vec4 eye) { return normalize(vec3(eye) - position * eye.w); }

// The normal of the face under a pixel, on the side of the eye, from how its position changes to the next pixels. A guess across a
// silhouette.
FN vec3 faceNormal(vec3 across, vec3 down, vec3 normal, vec3 toEye)
{
    vec3 face = safeNormalize(cross(across, down), normal);
    return dot(face, toEye) < 0.0f ? -face : face;
}

// How far off its surface a point may lie that was read back from the depth buffer, m. A perspective's depth is interpolated to 2^-24 of
// its greatest, which lies at a plane's nearest point; an orthographic one has steps of 2^-24 of the whole depth, twice rounded.
// `distance_`: of the view ray. Experiment: a quarter of either leaves specks on planes from 0.1 to 1000 m before the eye.
FN float depthRounding(float distance_, mat4 clipToWorld, vec4 eye)
{
    const float kOfDistance = 1.52587890625e-5f;  // 2^-16
    const float kOfDepth = 2.384185791015625e-7f; // 2^-22
    return eye.w > 0.0f ? kOfDistance * distance_ : kOfDepth * length(vec3(clipToWorld[2]));
}

// The same by how rasterisers place corners: on 256ths of a pixel along either axis, which shifts a whole triangle by up to half of that,
// m. `beside`: where the next pixel's ray has the depth of `position`. Experiment: on an Nvidia H100 walls of a picture of 64 pixels shadow
// themselves without it.
FN float cornerRounding(vec3 position, vec3 beside) { return distance(position, beside) * (1.0f / 256.0f); }

// The same along both axes, of the pixel at `uv`, whose step is `pixel`: an oblique near plane tilts the planes of one depth, and before a
// mirror on the floor a corner that lies lower by a 512th of a pixel moves a wall by far more than one that lies beside its place. Half a
// step along both moves it by no more than a whole one along the worse.
FN float cornerRounding(vec3 position, vec2 uv, vec2 pixel, float depth, mat4 clipToWorld)
{
    return max(cornerRounding(position, worldFromDepth(uv + vec2(pixel.x, 0.0f), depth, clipToWorld)),
               cornerRounding(position, worldFromDepth(uv + vec2(0.0f, pixel.y), depth, clipToWorld)));
}

// Toward the eye, which sees the point: so it leaves its surface whatever that is, were the face a guess across a silhouette and the shading
// normal bent. By as much as along the normal of the flatter of the two, down to 86 degrees between it and the eye.
FN vec3 towardEye(vec3 normal, vec3 face, vec3 toEye)
{
    const float kFlattest = 0.0625f;
    return toEye / clamp(min(dot(normal, toEye), dot(face, toEye)), kFlattest, 1.0f);
}

// A point that a pixel shows, for rays that leave it.
struct PixelPoint {
    vec3 position;      // as its depth says, world
    float cornerError;  // m, cornerRounding() of it
    vec3 normal;        // shading normal
    vec3 face;          // of the surface itself, both on the side of the eye
    float distance;     // m, of the view ray
    float meetingError; // m, by how much rays may miss the plane of any triangle of its material: a pixel does not tell which it shows
};

// Where a ray may leave it: past all that keeps it from lying on its surface, and the surface from being met there.
FN vec3 leaving(IN(PixelPoint) p, mat4 clipToWorld, vec4 eye)
{
    float off = depthRounding(p.distance, clipToWorld, eye) + p.cornerError + p.meetingError;
    vec3 up = p.normal / max(dot(p.normal, p.face), 0.5f); // where the two disagree wildly the face is no more than a guess
    return leaving(p.position, off, up);
}

SHARED_END
#endif
