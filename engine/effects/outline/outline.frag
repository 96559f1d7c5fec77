#version 460
// The lines over the picture: those of the meshes as they were drawn, and those where two objects pass through each other.
#include "engine/effects/outline/outline.h"

layout(constant_id = kOutlineObjects) const bool kObjects = false;
layout(constant_id = kOutlineLayers) const bool kLayers = false;

layout(set = 1, binding = 0, scalar) readonly buffer Outline { OutlineFrame frame; };
layout(set = 1, binding = 1) uniform sampler2D linesTexture;
layout(set = 1, binding = 2) uniform usampler2D objectsTexture;
layout(set = 1, binding = 3) uniform sampler2D depthTexture;

// Premultiplied, blended over the picture and over its parts in the order of layers.hpp
layout(location = 0) out vec4 image;
layout(location = 1) out vec4 reflectionLayer;
layout(location = 2) out vec4 directLayer;
layout(location = 3) out vec4 indirectLayer;
layout(location = 4) out vec4 emissionLayer;
layout(location = 5) out vec4 fogLayer;

ivec2 inside(ivec2 pixel) { return clamp(pixel, ivec2(0), frame.size - 1); }
uint objectAt(ivec2 pixel) { return texelFetch(objectsTexture, inside(pixel), 0).r; }
float depthAt(ivec2 pixel) { return texelFetch(depthTexture, inside(pixel), 0).r; }

bool goesOn(ivec2 pixel, uint object) { return pixel == inside(pixel) && objectAt(pixel) == object; }

// Change of the depth to the next pixel, and how much it is another to the one after that, where the object goes on so far: kFloatMax where
// it does not at all, and for two pixels the change itself, which may lead across a fold.
vec2 changeTowards(ivec2 pixel, ivec2 step_, uint object, float depth)
{
    if (!goesOn(pixel + step_, object)) return vec2(kFloatMax);
    float next = depthAt(pixel + step_), change = next - depth;
    if (!goesOn(pixel + 2 * step_, object)) return vec2(change, abs(change));
    return vec2(change, abs(depthAt(pixel + 2 * step_) - next - change));
}

// Both per px along an axis, on the side where the object goes on straightest: the other may lead across a fold.
vec2 changeAlong(ivec2 pixel, ivec2 axis, uint object, float depth)
{
    vec2 ahead = changeTowards(pixel, axis, object, depth), behind = changeTowards(pixel, -axis, object, depth);
    if (behind.x < kFloatMax) behind.x = -behind.x;
    bool straight = ahead.y == behind.y ? abs(ahead.x) < abs(behind.x) : ahead.y < behind.y;
    return straight ? ahead : behind;
}

// x, y: the slope; z, w: its bend.
vec4 slopeAt(ivec2 pixel, uint object, float depth)
{
    vec2 x = changeAlong(pixel, ivec2(1, 0), object, depth), y = changeAlong(pixel, ivec2(0, 1), object, depth);
    return vec4(x.x, y.x, x.y, y.y);
}

// What is not known is as the other has it: two objects in one plane, of which single pixels show now this, now that, never meet.
vec2 known(vec2 slope, vec2 other)
{
    slope = mix(slope, other, equal(slope, vec2(kFloatMax)));
    return mix(slope, vec2(0.0), equal(slope, vec2(kFloatMax)));
}

// Distance of the pixel to the next place where its object meets another, px: they meet where the depths of both, continued, cross between
// two pixels. Where one stands before the other they do not, and the line is its silhouette.
float distanceToMeeting(ivec2 pixel)
{
    uint object = objectAt(pixel);
    if (object == 0u) return kFloatMax;
    float depth = depthAt(pixel), best = kFloatMax;
    vec4 own = vec4(0.0);
    bool asked = false;
    int reach = int(ceil((0.5 * max(frame.width, 1.0) + 0.5) * 1.42)); // along the axes, of a line that runs askew
    for (int direction = 0; direction < 4; ++direction) {
        ivec2 axis = (direction & 1) == 0 ? ivec2(direction - 1, 0) : ivec2(0, direction - 2);
        for (int s = 1; s <= reach; ++s) {
            ivec2 other = pixel + s * axis;
            uint neighbour = objectAt(other);
            if (neighbour == object) continue;
            if (neighbour == 0u) break;
            if (!asked) own = slopeAt(pixel, object, depth);
            asked = true;
            float otherDepth = depthAt(other);
            vec4 its = slopeAt(other, neighbour, otherDepth);
            vec2 bends = max(own.zw, its.zw);
            if (isFold(bends.x, vec2(own.x, its.x), depth) || isFold(bends.y, vec2(own.y, its.y), depth)) break;
            vec2 slope = known(own.xy, its.xy), otherSlope = known(its.xy, own.xy), step_ = vec2(other - pixel);
            float here = depth - (otherDepth - dot(otherSlope, step_)), there = depth + dot(slope, step_) - otherDepth;
            float bend = s == 1 ? kMeetingBend * length(slope - otherSlope) + dot(abs(vec2(axis)), bends) : 0.0;
            if (here >= -bend && there <= bend) best = min(best, meetingDistance(here, slope - otherSlope, depth));
            break;
        }
    }
    return best;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float covered = texelFetch(linesTexture, pixel, 0).r;
    if (kObjects && frame.width > 0.0) covered = max(covered, lineCoverage(distanceToMeeting(pixel), frame.width));
    if (!(covered > 0.0)) discard;
    image = vec4(frame.color * covered, covered);
    if (!kLayers) return;
    reflectionLayer = directLayer = indirectLayer = fogLayer = vec4(vec3(0.0), covered);
    emissionLayer = image;
}
