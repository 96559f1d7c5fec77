// A wall before the eye, for light on a single surface.
#pragma once
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
// 0.64 = (204 / 255)^2 is kept exactly by the G-buffer; radiance is kept as half floats, 2^-11.
constexpr float kHalfError = 2e-3f;

class BeforeWall : public Drawn
{
protected:
    // Across the view, 2 m away; its front faces the eye.
    Object& wall(const Material& material)
    {
        return addQuad(scene, vec3(-9, -9, -2), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, material));
    }
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1));
};
}
