#include "engine/upload/gpu_paths.hpp"
#include "engine/scene/emitters.hpp"
#include "engine/scene/picture.hpp"
#include "engine/scene/sky.hpp"
#include "engine/upload/storage.hpp"

namespace afterglow
{
static GpuImage uploadSky(Gpu& gpu, const Image& sky, const SkyTable& table)
{
    std::vector<vec4> texels(std::size_t(sky.width) * std::size_t(sky.height));
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const float* p = &sky.pixels[i * std::size_t(sky.channels)];
        texels[i] = vec4(p[0], p[1], p[2], table.columns[i]);
    }
    GpuImage image = gpu.memory.image("sky of paths", {.format = VK_FORMAT_R32G32B32A32_SFLOAT, .size = {sky.width, sky.height, 1}});
    gpu.memory.upload(image, texels.data(), texels.size() * sizeof(texels[0]));
    return image;
}

GpuPaths uploadPaths(Gpu& gpu, const Scene& scene, const std::vector<Instance>& placed, const GpuRays& rays)
{
    GpuPaths paths;
    paths.lights = storage(gpu, "lights of paths", scene.lights);
    paths.lightCount = uint(scene.lights.size());
    const EmitterTable table = emitterTable(scene, placed, rays.order);
    paths.emitters = storage(gpu, "emitters", table.emitters);
    paths.densities = storage(gpu, "emitter densities", table.density);
    paths.emitterCount = uint(table.emitters.size());
    paths.skyTint = scene.sky.radiance;
    paths.skyRotation = scene.sky.rotation;
    if (!scene.sky.image.pixels.empty()) {
        const SkyTable sky = skyTable(scene.sky.image);
        paths.sky = uploadSky(gpu, scene.sky.image, sky);
        paths.skyRows = storage(gpu, "sky rows", sky.rows);
    }
    const PortalTable portals = portalTable(scene);
    paths.portals = storage(gpu, "portals", portals.portals);
    if (paths.portals) paths.portalOf = storage(gpu, "portals by instance", portals.ofInstance);
    return paths;
}
}
