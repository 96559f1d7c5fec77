// The level as rays meet it on the GPU, for shaders/trace.glsl: its triangles placed in the world, in an order that makes a good tree.
// Built only when something that the plan keeps traces rays, on a device that can.
#pragma once
#include "engine/gpu/acceleration_structure.hpp"
#include "engine/gpu/gpu.hpp"
#include "engine/scene/scene.hpp"

namespace afterglow
{
// A placed mesh that has a structure of its own.
struct RayMesh {
    Instance instance; // as it was when the structure was built, in the world
    uint number;       // of it among all instances
    std::size_t place; // of its structure in GpuRays::placed
};

struct GpuRays {
    std::vector<AccelerationStructure> structures; // of the placed meshes
    AccelerationStructure level;                   // all of them; absent: nothing to meet
    bool filtered = false;                         // some triangle may let rays through
    GpuBuffer triangles;                           // RayTriangle, as Hit::triangle counts them
    GpuBuffer instances;                           // Instance
    std::vector<PlacedStructure> placed;           // the structures as `level` holds them
    std::vector<RayMesh> meshes;
    explicit operator bool() const { return bool(level); }
};

// `placed`: as uploadScene takes them. Throws Error (exit 3) when the level has more triangles than the device's trees take.
GpuRays buildRays(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed);

// Puts an object elsewhere: its structures stay, the level's is built anew in its place, between frames. In a level of so many meshes that
// they share structures (acceleration.cpp), rays meet it where it was.
void move(Gpu& gpu, GpuRays& rays, uint object, const mat4& toWorld);
}
