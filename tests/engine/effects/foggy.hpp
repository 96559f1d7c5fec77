// A view through air, 5 m of it before a wall, for the tests of fog.
#pragma once
#include "shaders/phase.h"
#include "tests/engine/effects/drawn.hpp"
#include <algorithm>

namespace afterglow
{
class Fog : public Drawn
{
protected:
    void medium(vec3 scattering, vec3 absorption, float g, vec3 lower, vec3 upper)
    {
        Medium m{};
        m.scattering = scattering, m.absorption = absorption, m.g = g, m.lower = lower, m.upper = upper;
        scene.media.push_back(m);
    }
    void everywhere(vec3 scattering, vec3 absorption, float g) { medium(scattering, absorption, g, vec3(-INFINITY), vec3(INFINITY)); }
    // A lamp across the view, 5 m away.
    void lamp(vec3 emission)
    {
        Material m = matte(vec3(0.0f));
        m.emission = emission;
        addQuad(scene, vec3(-99, -99, -5), vec3(198, 0, 0), vec3(0, 198, 0), addMaterial(scene, m));
    }
    // The air that a mesh fills: planes of the box that is turned by 45 degrees about z, `half` m from its middle to each of four sides.
    void turnedBox(vec3 middle, float half)
    {
        for (const vec2 side : {vec2(1, 1), vec2(-1, 1), vec2(1, -1), vec2(-1, -1)}) {
            const vec3 normal = normalize(vec3(side, 0.0f));
            scene.mediumPlanes.push_back(vec4(normal, dot(normal, middle) + half));
        }
        scene.media.back().firstPlane = uint(scene.mediumPlanes.size()) - 4;
        scene.media.back().planeCount = 4;
    }
    FogParameters withSteps(uint steps) const
    {
        FogParameters p = defaultFogParameters();
        p.steps = steps;
        return p;
    }
    // Largest difference of two pictures.
    static float apart(const Image& a, const Image& b)
    {
        float largest = 0.0f;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) largest = std::max(largest, std::abs(a.pixels[i] - b.pixels[i]));
        return largest;
    }
    static bool finite(const Image& image)
    {
        return std::all_of(image.pixels.begin(), image.pixels.end(), [](float value) { return std::isfinite(value); });
    }
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1), 0.02f); // narrow: every ray is 5 m long
};
}
