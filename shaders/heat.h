// A number as a colour: of maps of errors, and of whatever else a picture shows that is no light.
#ifndef AFTERGLOW_HEAT_H
#define AFTERGLOW_HEAT_H
#include "shaders/constants.h"
SHARED_BEGIN

// Five stops from black over violet to pale yellow, evenly brighter, in grey too: for 0 to 1.
FN vec3 heatColor(float at)
{
    float x = clamp(at, 0.0f, 1.0f) * 4.0f;
    if (x < 1.0f) return mix(vec3(0.0f, 0.0f, 0.02f), vec3(0.32f, 0.07f, 0.48f), x);
    if (x < 2.0f) return mix(vec3(0.32f, 0.07f, 0.48f), vec3(0.72f, 0.21f, 0.47f), x - 1.0f);
    if (x < 3.0f) return mix(vec3(0.72f, 0.21f, 0.47f), vec3(0.98f, 0.54f, 0.38f), x - 2.0f);
    return mix(vec3(0.98f, 0.54f, 0.38f), vec3(0.99f, 0.99f, 0.75f), x - 3.0f);
}

SHARED_END
#endif
