// A level as rays meet it: world-space triangles under an Embree tree (sealed in world.cpp), and what stands at each hit.
#pragma once
#include "baker/lanes.hpp"
#include "engine/scene/scene.hpp"
#include "shaders/ray.h"
#include <memory>
#include <vector>

namespace afterglow
{
struct Wavelengths;

enum class Content { everything, staticOnly }; // a bake leaves out objects with ag_static = false

class World
{
public:
    World(const Scene& scene, Content content);
    ~World();
    World(const World&) = delete;

    Hit closestHit(const Ray& ray) const;

    // The same for a packet of up to kPacket rays. Those that start close together and point alike (`coherent`: first bounces of
    // neighbouring texels) are traced 2 to 4 times as fast.
    void closestHits(const Ray* rays, Hit* hits, int count, bool coherent = true) const;

    // Fraction of light that passes along the ray up to ray.far: 0 behind anything opaque, the tint of thin glass otherwise, Rec.709 or
    // at these wavelengths.
    vec3 transmittance(const Ray& ray, const Wavelengths* at = nullptr) const;

    // The same for a packet of up to kPacket rays, Rec.709.
    void transmittances(const Ray* rays, vec3* passed, int count) const;
    void transmittances(const RayLanes& rays, Lanes3& passed) const; // 1 where none is asked

    // Whether closestHit() would meet nothing up to ray.far: leaves `asked` at -1 where it would not.
    void unoccluded(RayLanes& rays) const;
    bool unoccluded(const Ray& ray) const;

    // The shading point of a hit; ray.direction says from where it is seen.
    Surface surfaceAt(const Ray& ray, const Hit& hit) const;

    struct Triangle {
        uint vertex[3]; // into vertices()
        uint material;
        uint object;
        uint instance; // of instances(scene)
    };
    const Scene& scene() const { return scene_; }
    const std::vector<Vertex>& vertices() const { return vertices_; } // world space
    const std::vector<Triangle>& triangles() const { return triangles_; }
    const std::vector<Instance>& placed() const { return placed_; }
    std::uint64_t bytes() const;                              // of all of it, Embree's tree included
    const std::vector<uint>& order() const { return order_; } // of each triangle its number among those of placed()
    const Material& materialOf(uint triangle) const { return scene_.materials[triangles_[triangle].material]; }

    // Normal of a triangle's front, as long as twice its area.
    vec3 front(uint triangle) const
    {
        const Triangle& t = triangles_[triangle];
        vec3 origin = vertices_[t.vertex[0]].position;
        return cross(vertices_[t.vertex[1]].position - origin, vertices_[t.vertex[2]].position - origin);
    }

    // Mean radiance that leaves the front of a triangle at a point of it, textures read (metEmission).
    vec3 emissionAt(uint triangle, vec2 barycentric) const;

private:
    struct Embree;
    bool letsThrough(uint triangle, vec2 barycentric, vec3 direction, const Wavelengths* at, vec3* tint) const;
    friend struct Embree;

    const Scene& scene_;
    std::vector<Instance> placed_;
    std::vector<uint> order_;
    std::vector<Vertex> vertices_;
    std::vector<Triangle> triangles_; // opaque ones first: only the others pay for a filter
    std::size_t opaque_ = 0;
    std::unique_ptr<Embree> embree_;
};
}
