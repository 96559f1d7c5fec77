#include "engine/scene/scene.hpp"

namespace afterglow
{
namespace
{
std::string counted(std::size_t count, const char* one, const char* many)
{
    return (count == 0 ? "no" : std::to_string(count)) + " " + (count == 1 ? one : many);
}
}

std::string describe(const Scene& scene)
{
    std::size_t triangles = 0;
    for (const Object& object : scene.objects)
        for (const Primitive& primitive : scene.meshes[object.mesh].primitives) triangles += primitive.indexCount / 3;

    std::string paragraph = scene.path.filename().string() + ": " + counted(triangles, "triangle", "triangles") + " in " +
                            counted(scene.objects.size(), "object", "objects") + " of " + counted(scene.meshes.size(), "mesh", "meshes") +
                            ", " + counted(scene.materials.size(), "material", "materials") + ", " +
                            counted(scene.textures.size(), "texture", "textures") + ", " + counted(scene.lights.size(), "light", "lights") +
                            ", " + counted(scene.cameras.size(), "camera", "cameras");
    if (!scene.media.empty()) paragraph += ", " + counted(scene.media.size(), "medium", "media");
    if (!scene.sky.image.pixels.empty())
        paragraph += ", an image as sky";
    else
        paragraph += scene.sky.radiance == vec3(0.0f) ? ", a black sky" : ", a uniform sky";
    if (!scene.dropped.empty()) {
        paragraph += "; dropped or clamped:";
        const char* separator = " ";
        for (const auto& [what, count] : scene.dropped) {
            paragraph += separator + std::to_string(count) + " " + what;
            separator = ", ";
        }
    }
    return paragraph + ".";
}
}
