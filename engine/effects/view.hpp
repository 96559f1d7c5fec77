// What the passes of a frame hand to each other beside textures: the eye, and the handles of the G-buffer.
#pragma once
#include "engine/effects/view_ray.h"
#include "engine/graph/graph.hpp"
#include "engine/upload/scene_set.hpp"

namespace afterglow
{
// One eye for one frame. World space is the level's.
struct View {
    mat4 worldToClip{1.0f}; // reversed depth, no far plane (shaders/camera.h)
    mat4 clipToWorld{1.0f};
    vec4 eye{0.0f, 0.0f, 0.0f, 1.0f}; // w = 1: position; w = 0, orthographic: the direction towards the eye
    uvec2 size{1280, 720};
    uint resting = 0;         // frames since anything moved, if they are gathered: the shown picture is the mean of one more
    uint frame = 0;           // seeds what differs from frame to frame; it counts only while something gathers the frames (antialias)
    vec2 jitter{0.0f};        // px, right and down: the pixel's sample stands so far from its centre. worldToClip and clipToWorld hold it
    float textureBias = 0.0f; // mips: what many samples a pixel allow of sharper textures, or a drawn picture smaller than the shown one
    float mayStray = 0.0f;    // px: how far from its place a coarser surface may be drawn; 0: nowhere
    dmat4 steady{1.0};        // worldToClip without the jitter: by it frames are compared
    dmat4 last{1.0};          // `steady` of the frame before
    bool fromNear = false;    // the world begins at the near plane: an eye behind a mirror or a portal
    std::vector<std::uint8_t> mirrored; // by draw: 1 where another eye draws what it mirrors; empty: nowhere

    // The eye as viewRay() takes it.
    vec4 rayEye() const { return fromNear && eye.w > 0.0f ? vec4(vec3(eye), kEyeFromNear) : eye; }
};

// Which of the frames that are gathered into one picture, and where in its pixels it samples (jitter.h).
struct FrameSample {
    uint frame = 0;
    vec2 jitter{0.0f}; // px
    uvec2 drawn{0};    // px, of the drawn picture; 0: as it is shown
    float textureBias = 0.0f;
    float mayStray = 0.0f; // px (View)
};

// `shown`: the size of the picture that comes of it; its pixels are square.
View makeView(const Camera& camera, uvec2 shown, const FrameSample& sample = {});

// worldToClip in double.
dmat4 jittered(const View& view);

// The same eye that looks through the centres of the pixels, of a picture of `size`.
View centred(View view, uvec2 size);

// Whether a world box may be seen: false only when it lies outside one plane of the clip volume.
bool mayBeSeen(const mat4& worldToClip, const vec3& lower, const vec3& upper);

// Whether all of a world box lies beyond the near plane, and the eye outside of it.
bool isBeyondNear(const mat4& worldToClip, const vec3& lower, const vec3& upper);

// A bound of how many pixels a step of one metre covers along either axis, from any point of the box that the picture shows; infinite where
// the box reaches the eye's plane.
float pixelsPerMetre(const View& view, const vec3& lower, const vec3& upper);

// What a step of depth is along the view, as depthApart() takes it (depth_apart.h).
vec2 metresOfDepth(const View& view);

// How wide a pixel is, m: at a distance of 1 m along the view of a perspective, everywhere of an orthographic eye.
float pixelWidth(const View& view);

// What geometry leaves behind (shaders/gbuffer.h).
struct GBuffer {
    Texture surface;  // RGBA32_UINT
    Texture depth;    // D32, reversed; 0: the sky
    Texture emission; // radiance that leaves by itself; absent when nothing emits
    Texture objects;  // R32_UINT: 1 + the index of the placed mesh; 0: the sky; absent unless something tells objects apart
    Texture facets;   // R8: roughness of the material, before the pixel's normals widen it; absent unless some metal is rough
};
}
