// What paths ask of a level beside what rays meet (shaders/transport.h): every light of it, its sky in full range, its portals.
// Uploaded only when something traces paths; a raster frame needs none of it.
#pragma once
#include "engine/upload/gpu_scene.hpp"

namespace afterglow
{
struct GpuPaths {
    GpuBuffer lights;              // Light: all of the level's, whatever a bake holds
    GpuBuffer emitters, densities; // Emitter; its density by the tracer's triangle. As the three that follow absent when there are none
    GpuBuffer skyRows;             // SkyTable::rows
    GpuImage sky;                  // rgb radiance, a SkyTable::columns; fp32: a sun is brighter than a half float can say
    GpuBuffer portals, portalOf;   // Portal; by instance
    uint lightCount = 0, emitterCount = 0;
    vec3 skyTint{0.0f}; // radiance of a uniform sky, factor of the image
    float skyRotation = 0.0f;
};

// `rays`: of the same `placed`.
GpuPaths uploadPaths(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed, const GpuRays& rays);
}
