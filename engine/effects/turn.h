// Sixteen pixels of a square of 4 x 4 look in sixteen ways, and so do the sixteen around any pixel: their mean is one even set.
#ifndef AFTERGLOW_TURN_H
#define AFTERGLOW_TURN_H
#include "shaders/glsl.h"
SHARED_BEGIN

// 0..15, each once in a square of 4 x 4, in an order in which neighbours lie far apart (Bayer's); `salt` gives another order.
FN uint turnIndex(ivec2 at, int salt)
{
    int x = at.x & 3, y = at.y & 3, d = x ^ y;
    int order = ((d & 1) << 3) | ((y & 1) << 2) | (d & 2) | (y >> 1);
    return uint((order * (2 * salt + 1) + 5 * salt) & 15);
}
FN float turnOf(ivec2 at, int salt) { return (float(turnIndex(at, salt)) + 0.5f) / 16.0f; }

SHARED_END
#endif
