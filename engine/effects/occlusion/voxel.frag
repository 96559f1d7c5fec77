#version 460
// Cones through the level's voxels, whether the screen shows what stands there or not. A cone's sample is as wide as the cone is there;
// what it meets closes it by the share of its area.
#include "engine/effects/occlusion/seen.glsl"

layout(constant_id = kOcclusionVoxelMips) const uint kMips = 0u;
layout(set = 1, binding = 3) uniform sampler3D voxelTexture;

// A surface fills the samples of its own voxels: up to half a voxel to their centres and one more to where the filter ends.
const float kLift = 1.5; // voxels over the surface, where the cones start

// Beyond the outermost voxels there are empty ones: the filter fades into them. `at` in voxels of the sample's width, of which there are
// `count`.
float withinBorder(vec3 at, vec3 count)
{
    vec3 inside = clamp(1.0 - max(0.5 - at, at + 0.5 - count), 0.0, 1.0);
    return inside.x * inside.y * inside.z;
}

float hiddenAlong(SeenPoint p, vec3 way, float within)
{
    vec3 start = p.face * (kLift * frame.voxelEdge);
    vec3 toUnit = 1.0 / (vec3(textureSize(voxelTexture, 0)) * frame.voxelEdge);
    float hidden = 0.0, t = 0.0;
    while (t < frame.p.range && hidden < 1.0) {
        float mip = clamp(floor(log2(max(2.0 * t * frame.p.aperture / frame.voxelEdge, 1.0))), 0.0, float(kMips) - 1.0);
        float wide = frame.voxelEdge * exp2(mip);
        float end = min(t + wide, frame.p.range);
        vec3 at = start + way * mix(t, end, within);
        vec3 unit = (p.position + at - frame.voxelLower) * toUnit;
        // What is too low may be the surface itself, in the voxels of a wide sample
        float share = clamp(2.0 * (dot(at, p.face) / wide - (kLift - 0.5)), 0.0, 1.0);
        share *= withinBorder(unit / toUnit / wide, vec3(textureSize(voxelTexture, 0)) * exp2(-mip));
        if (share > 0.0) hidden += share * dot(textureLod(voxelTexture, unit, mip).rgb, abs(way)) * (end - t) / wide;
        t = end;
    }
    return min(hidden, 1.0);
}

void main()
{
    SeenPoint p;
    if (!seenPoint(p) || kMips == 0u) return;
    Frame local = makeFrame(p.normal);
    float turn = turnOf(ivec2(gl_FragCoord.xy), 0), within = turnOf(ivec2(gl_FragCoord.xy), 2);
    float hidden = 0.0;
    for (uint k = 0u; k < frame.p.cones; ++k) {
        // Cosine by cosine, around by the golden section
        float u = (float(k) + within) / float(frame.p.cones), angle = kTwoPi * fract(float(k) * 0.6180340 + turn);
        hidden += hiddenAlong(p, toWorld(local, vec3(sqrt(u) * cos(angle), sqrt(u) * sin(angle), sqrt(1.0 - u))), within);
    }
    seen.x = 1.0 - hidden / float(frame.p.cones);
}
