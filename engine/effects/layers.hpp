// The parts of a picture, for compositing (`render --layers`). Passes that change the picture keep them in step with it:
//   direct + indirect + reflection + emission + fog = the picture, scene-linear, before bloom.
// In a picture that moves each part is gathered by its own neighbours (antialias), and the sum is no more than near.
#pragma once
#include "engine/effects/view.hpp"

namespace afterglow
{
// Of the picture's size; an empty one holds nothing in this frame.
struct Layers {
    Texture direct;     // RGBA16F: light that came straight from a lamp which the runtime draws
    Texture indirect;   // RGBA16F: what the matte base sends on of all other light
    Texture reflection; // RGBA16F: what the interfaces mirror of it
    Texture emission;   // RGBA16F: what surfaces send out by themselves, and the sky
    Texture fog;        // RGBA16F: what the air scatters toward the eye
    Texture
        occlusion; // R: visibility of the light from everywhere, 1 = open (occlusion/occlusion.hpp). `indirect` and `reflection` are dimmed
                   // by it already, where no lightmap holds the contact
    // Of the opaque surfaces at the pixels' centres
    Texture surface; // RGBA32F: normal in the world, depth along the view axis in m (layers.h)
    Texture ids;     // RG32F: 1 + the index of the object, 1 + that of its material; 0: the sky
    Texture motion;  // RGBA32F: px since the last frame, and to the next (layers.frag); absent while nothing moves
};

// The four parts that lighting makes, as attachments: reflection, direct, indirect, emission. On top of what is there.
void writeAll(Pass& pass, const Layers& layers);
void modifyAll(Pass& pass, const Layers& layers);

// Fills what is known of the surfaces; the G-buffer tells objects apart.
void surfaceLayers(Graph& graph, const View& view, const GBuffer& surfaces, const GpuScene& scene, Layers& layers);
}
