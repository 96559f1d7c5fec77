// Outlines: what may be chosen, what the passes know of the frame, and where two surfaces meet on the picture.
#ifndef AFTERGLOW_OUTLINE_H
#define AFTERGLOW_OUTLINE_H
#include "shaders/edge.h"
SHARED_BEGIN

struct OutlineParameters {
    float width;       // px of the picture, 0..64; 0: no line
    vec3 color;        // radiance
    uint kinds;        // kEdge...: those that are drawn
    float creaseAngle; // radians: faces that meet at less are a crease
};
FN OutlineParameters defaultOutlineParameters()
{
    OutlineParameters p;
    p.width = 0.0f;
    p.color = vec3(0.0f);
    p.kinds = kEveryEdge;
    p.creaseAngle = kCreaseDegrees * kPi / 180.0f;
    return p;
}

struct OutlineFrame {
    mat4 clipToWorld;
    vec4 eye; // as viewRay() takes it
    vec3 color;
    float width; // px of these passes
    uint kinds;
    uint media;    // that dim the lines on their way
    ivec2 size;    // of the picture, px
    vec2 steepest; // depth that a surface may lose from a pixel to the next but one: x of the depth, and y
};

struct EdgePush {
    mat4 objectToClip; // multiplied in double on the CPU
    vec4 eye;          // w = 1: position; 0: the direction towards an orthographic eye; in the object's space
};

// Specialization constants.
const uint kOutlineObjects = 0u; // lines where objects pass through each other
const uint kOutlineLayers = 1u;  // the parts of the picture lie below the lines, too: a line is emission

// How much of a pixel a line covers whose spine passes at that distance, px. The integral across the line is its width exactly, for a
// width of a pixel and more; a thinner one is a paler one.
FN float lineCoverage(float distance_, float width)
{
    return clamp(0.5f * max(width, 1.0f) + 0.5f - distance_, 0.0f, 1.0f) * min(width, 1.0f);
}

// The line in which two surfaces meet. The reversed depth of a plane is affine across the picture, so with `apart` the difference of two
// depths at a point and the gradients of both, per px, the distance of the point to where they agree is |apart| / |difference of
// gradients|. Gradients that agree but for rounding belong to one plane, which meets itself nowhere.
const float kOnePlane = 1e-5f; // of the depth, per px
FN float meetingDistance(float apart, vec2 gradients, float depth)
{
    float slope = length(gradients);
    return slope > kOnePlane * depth ? abs(apart) / slope : kFloatMax;
}

// How far from plane surfaces may be at the next pixel, beyond as much as they bend by at this one, as a share of that difference of
// gradients: a ball or a torus that dips into a table falls away faster and faster to the line where they meet. Farther off it would be a
// guess: thin strips grew teeth.
const float kMeetingBend = 0.5f;

// Whether one of two surfaces folds before it meets the other: by the bend of its slope against the slopes of both along the way. Of a
// strip of a pixel nothing is known, and balls that dip into floors bend by less.
const float kFold = 0.75f;
FN bool isFold(float bend, vec2 slopes, float depth) { return bend > kFold * max(abs(slopes.x), abs(slopes.y)) + kOnePlane * depth; }

// Whether what is drawn at `depth` can be seen among pixels of depths from `farthest` to `nearest`: in front of one of them, or as little
// behind as the surface itself falls away there, which is `steepest` (OutlineFrame) at most: what is nearer stands before it. The rest is
// rounding.
const float kLineSlope = 0.75f;
const float kLineRounding = 2e-5f;
FN bool lineIsSeen(float depth, float farthest, float nearest, vec2 steepest)
{
    float fall = min(nearest - farthest, steepest.x * farthest + steepest.y);
    return farthest <= depth * (1.0f + kLineRounding) + kLineSlope * fall;
}

SHARED_END
#endif
