// Flying: a camera moved and turned by what the person did.
#pragma once
#include "engine/gpu/window.hpp"
#include "engine/scene/scene.hpp"

namespace afterglow
{
// Ahead is where the camera looks, up is the world's +Y. Turning takes the roll off. `speed` in m/s.
Camera flown(Camera camera, const Controls& controls, float speed);

// A fifth of the level's diagonal a second, in m/s, within what suits a person.
float flyingSpeed(const Scene& scene);
}
