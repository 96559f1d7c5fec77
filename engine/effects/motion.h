// Where surfaces were in the last frame: the objects that moved since say it themselves, the rest follows from the eye's own motion.
#ifndef AFTERGLOW_MOTION_H
#define AFTERGLOW_MOTION_H
#include "shaders/camera.h"
SHARED_BEGIN

// What a draw of motion.vert pushes.
struct MotionPush {
    mat4 objectToClip; // the jitter in it
    mat4 objectToLast; // the last frame's, without jitter
};

// The motion texture holds where a moved surface was: picture coordinates, depth, and one of these; 0: nothing moved here.
const float kMotionSeen = 1.0f;
const float kMotionBehind = 2.0f; // behind the last eye: the coordinates are outside of the picture

// The same of a point in the last frame's clip space.
FN vec4 placeThen(vec4 lastClip)
{
    if (!(lastClip.w > 0.0f)) return vec4(-1.0f, -1.0f, 0.0f, kMotionBehind);
    return vec4(ndcToUv(vec2(lastClip) / lastClip.w), lastClip.z / lastClip.w, kMotionSeen);
}

SHARED_END
#endif
