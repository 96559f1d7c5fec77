// Where in its pixel each frame samples: frame after frame, the samples of a picture cover the pixel evenly.
#ifndef AFTERGLOW_JITTER_H
#define AFTERGLOW_JITTER_H
#include "shaders/random.h"
SHARED_BEGIN

const uint kJitterSeed = 0x6a09e667u; // any number: it picks one of the scrambles

// Two numbers in [0, 1) whose 24 bits differ from `a` in the bits of `b`: it moves the points of a net without leaving the net.
FN vec2 shiftedBits(vec2 a, vec2 b)
{
    const float kScale = 16777216.0f; // 2^24
    return vec2(float(uint(a.x * kScale) ^ uint(b.x * kScale)), float(uint(a.y * kScale) ^ uint(b.y * kScale))) * (1.0f / kScale);
}

// Px from the pixel's centre, right and down, [-0.5, 0.5). Frame 0 samples the centre; any 2^k frames in a row, counted from a multiple of
// 2^k, hold one sample in each of 2^k boxes of equal area, whatever their shape (a scrambled (0,2)-sequence, shifted bit by bit).
FN vec2 jitterOf(uint frame)
{
    Sampler first = makeSampler(kJitterSeed, 0u);
    Sampler here = makeSampler(kJitterSeed, frame);
    return shiftedBits(shiftedBits(next2(here), next2(first)), vec2(0.5f)) - vec2(0.5f);
}

SHARED_END
#endif
