// Numbers that have a name. The only pi of the house.
#ifndef AFTERGLOW_CONSTANTS_H
#define AFTERGLOW_CONSTANTS_H
#include "shaders/glsl.h"
SHARED_BEGIN

const float kPi = 3.14159265358979f;
const float kTwoPi = 6.28318530717959f;
const float kHalfPi = 1.57079632679490f;
const float kInvPi = 0.318309886183791f;
const float kInvTwoPi = 0.159154943091895f;
const float kInvFourPi = 0.0795774715459477f;

const float kHalfMax = 65504.0f;            // largest finite binary16: clamp before the conversion, never after
const float kFloatMax = 3.402823466e38f;    // largest finite binary32
const float kOneMinusEpsilon = 0.99999994f; // 1 - 2^-24, the largest float below 1: no random number reaches 1

SHARED_END
#endif
