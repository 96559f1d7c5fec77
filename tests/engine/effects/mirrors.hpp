// Floors that mirror and lamps that they show, for the tests of reflection.
#pragma once
#include "engine/effects/view_ray.h"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class Mirrors : public Drawn
{
protected:
    Mirrors() { size = {96, 64}; }

    static Material metal(float roughness)
    {
        Material m = matte(vec3(1.0f));
        m.flags = 0u;
        m.metallic = 1.0f;
        m.roughness = roughness;
        return m;
    }
    uint lamp(vec3 emission)
    {
        Material m = matte(vec3(0.0f));
        m.emission = emission;
        return addMaterial(scene, m);
    }
    // y = -1, wide, from under the eye to z.
    void floorTo(float z, const Material& m)
    {
        addQuad(scene, vec3(-60, -1, 4), vec3(120, 0, 0), vec3(0, 0, z - 4), addMaterial(scene, m));
    }
    // A wall of lamps at z = -10, bands 1 m high from the floor up to `top`; band k shines in bandColor(k).
    static vec3 bandColor(int k) { return vec3(1.0f + float(k % 2), 1.0f + float(k % 3), k == 0 ? 0.5f : 3.0f); }
    void bands(int top)
    {
        for (int k = 0; k < top; ++k) addQuad(scene, vec3(-60, -1 + k, -10), vec3(120, 0, 0), vec3(0, 1, 0), lamp(bandColor(k)));
    }
    const Camera camera = lookAt(vec3(0), vec3(0, -0.15f, -1), 0.9f);

    Image mirrored(const Camera& eye, DrawnParts parts = {})
    {
        parts.reflection = true;
        return radiance(eye, parts);
    }
    static vec3 at(const Image& image, int x, int y) { return vec3(image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]); }

    // Where the pixel's ray goes from the eye.
    ViewRay eyeRay(const Camera& eye, int x, int y) const
    {
        const View view = makeView(eye, size);
        return viewRay((vec2(x, y) + 0.5f) / vec2(size), 0.0f, view.clipToWorld, view.eye);
    }
    static vec3 onFloor(const ViewRay& ray) { return ray.origin + ray.direction * ((-1.0f - ray.origin.y) / ray.direction.y); }
};
}
