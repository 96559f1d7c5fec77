// Antialias: the jittered frames gathered into one picture, at the size that is shown. At rest it is their mean; in motion the past follows
// its surfaces, and is believed as far as the new frame's neighbours allow.
#pragma once
#include "engine/effects/layers.hpp"

namespace afterglow
{
// What the frames so far leave for the next one, beside their textures.
struct Gathered {
    uint frames = 0;  // so far
    uint resting = 0; // of them, since something moved
};

// How many frames nothing moves by this one: neither the eye nor a surface. 0: something moved, or it is the first.
uint restingFrames(const View& view, const GpuScene& scene, const Gathered& gathered);

struct ShownSize {
    uvec2 size{0};         // px of the result
    bool upscaled = false; // the image may be smaller
};

// RGBA32F: a = how many frames the pixel is the mean of. `scene`: what moved since the last frame. `layers`: gathered alike, where there
// are any, so that they still sum up to the picture.
Texture antialias(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, const Texture& image,
                  const ShownSize& shown, Gathered& gathered, Layers* layers = nullptr);
}
