// The lit picture on its way through the passes that change what surfaces send.
#pragma once
#include "engine/effects/layers.hpp"

namespace afterglow
{
struct Lit {
    Texture radiance; // scene-linear, toward the eye, RGBA16F; a = 0 where the sky shows, or a mirror that is added later
    Texture mirrored; // the part of it that the interfaces mirror, RGBA16F, a = 0: none ever; absent unless a pass or the layers ask for it
    Buffer frame;     // what lighting knows of the frame (shading.h)
};
}
