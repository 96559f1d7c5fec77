// Truth: a picture path traced on the GPU, by ray queries or ray programs. What a frame of it is told, and what of a level it does not have
// to ask for.
#ifndef AFTERGLOW_TRUTH_H
#define AFTERGLOW_TRUTH_H
#include "shaders/path.h"
#include "shaders/picture.h"
SHARED_BEGIN

const uint kMostTruthSamples = 1u << 24u; // a float counts them exactly

struct TruthParameters {
    uint samples;     // paths of a pixel, 1 .. kMostTruthSamples
    uint seed;        // another seed, other noise
    uint bounces;     // surfaces that scatter
    uint scatterings; // in media, of one path; 1: single scattering
    uint perFrame;    // paths of a pixel in one frame, 1 ..
};
FN TruthParameters defaultTruthParameters()
{
    PathSettings limits = defaultPathSettings();
    return TruthParameters(64u, 1u, limits.maxBounces, limits.maxCollisions, 1u);
}

// All that the picture depends on but its level: while it stays the same, samples add up.
struct TruthFrame {
    Picture picture;
    PathSettings limits;
    vec3 skyTint;
    float skyRotation;
    uint media;
    uint lights;
    uint emitters;
};

struct TruthPush {
    uint first; // samples that are there already
    uint count; // to be added
};

struct WipePush {
    float line; // px from the left
};
const float kWipeLine = 2.0f; // px

// Specialization constants: what the level has none of is compiled out of the paths.
const uint kTruthLights = 0u;
const uint kTruthEmitters = 1u;
const uint kTruthSky = 2u; // 0: uniform, 1: an image, 2: an image that is not black
const uint kTruthMedia = 3u;
const uint kTruthGlow = 4u; // some medium emits
const uint kTruthPortals = 5u;

const uint kTruthGroup = 8u; // threads of a work group across and down

// The wavefront. Slots hold a path each, and begin the next one when theirs has ended; queues name the slots whose turn it is, or their
// shadow rays.
const uint kMostSlots = 1u << 17u; // 33 MB at 252 B; on lavapipe 2^13, 2^15 and 2^17 take the same CPU time within 6 % (cornell, 512x384)
const uint kWaveGroup = 64u;       // threads of a work group: whole subgroups on any device, which have 4 to 64
const uint kShadowQueue = 2u;      // 0 and 1: the paths that go on, in turns
struct WaveQueue {
    uint groups[3]; // as an indirect dispatch reads them
    uint count;
};
struct WavePush {
    TruthPush samples;
    uint slots;
    uint from; // the queue of paths that is read; the other one is filled
};
const uint kPathVectors = 6u; // uvec4 of a path
struct ShadowRay {
    vec3 origin;
    vec3 direction;
    float far;
    vec3 carried; // light, and what of it has passed
};

SHARED_END
#endif
