// What a picture's brightness is, and what it is shown as: the exposure that a display chooses, and by which errors are judged.
#ifndef AFTERGLOW_EXPOSURE_H
#define AFTERGLOW_EXPOSURE_H
#include "shaders/color.h"
SHARED_BEGIN

const float kMiddleGrey = 0.18f;     // what the mean luminance of a picture is shown as: the mean of its logarithm
const float kDarkestCounted = 1e-5f; // luminance below it is no part of the mean: the void around a level does not brighten it

SHARED_END
#endif
