// What shadows take, pixel by pixel: the picture with them over that without.
#pragma once
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class LitShare : public Drawn
{
protected:
    uint grey() { return scene.materials.empty() ? addMaterial(scene, matte(vec3(0.64f))) : 0u; }
    // `half` m of floor to each side; seen from above picture x runs along +x, picture y along +z.
    void floor(float half = 5.0f) { addQuad(scene, vec3(-half, 0, -half), vec3(0, 0, 2 * half), vec3(2 * half, 0, 0), grey()); }

    // Each pixel's radiance with the shadows of `parts` over that without; 1 where no light falls.
    Image litShareOf(const Camera& camera, const DrawnParts& parts)
    {
        const Image without = radiance(camera);
        Image with = radiance(camera, parts);
        for (std::size_t i = 0; i < with.pixels.size(); ++i)
            with.pixels[i] = without.pixels[i] > 0.0f ? with.pixels[i] / without.pixels[i] : 1.0f;
        return with;
    }
    // A room with a lamp in it, in 16 x 16 pixels, its triangles drawn `off` px beside their places.
    Image litInSnappedRoom(const DrawnParts& parts, vec2 off)
    {
        if (scene.objects.empty()) {
            addRoom(scene, vec3(-2), vec3(2), grey());
            addLight(scene, pointLight(vec3(0.1f, 0.2f, 0.3f), vec3(5.0f)));
        }
        size = {16, 16};
        cornersOff = off;
        return litShareOf(lookAt(vec3(-1.5f, -1.2f, 1.5f), vec3(2, 1, -2), 1.8f), parts);
    }

    // A floor under a roof, its far rim before the sky: how many of the floor's pixels, the rim's included, are lit.
    int litUnderRoof(const DrawnParts& parts, int& asked)
    {
        floor(2.0f);
        addQuad(scene, vec3(-20, 1, -20), vec3(40, 0, 0), vec3(0, 0, 40), grey());
        addLight(scene, sunLight(vec3(0, -1, 0), vec3(3.0f)));
        size = {96, 64};
        const Camera camera = lookAt(vec3(0.3f, 0.4f, 1.9f), vec3(0, 0.2f, -2), 1.0f);
        const Image with = radiance(camera, parts);
        const View view = makeView(camera, size);
        int lit = 0;
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x) {
                const vec2 uv((float(x) + 0.5f) / float(size.x), (float(y) + 0.5f) / float(size.y));
                const ViewRay ray = viewRay(uv, 0.0f, view.clipToWorld, view.eye);
                const vec3 p = ray.origin - ray.direction * (ray.origin.y / ray.direction.y);
                if (ray.direction.y >= 0.0f || max(abs(p.x), abs(p.z)) > 2.0f) continue;
                ++asked;
                lit += with.at(x, y)[0] > 0.0f;
            }
        return lit;
    }
    // What the share is where a point of the world is seen.
    float litAt(const Image& lit, const Camera& camera, vec3 world) const
    {
        const vec4 clip = makeView(camera, size).worldToClip * vec4(world, 1.0f);
        const ivec2 pixel((vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(size));
        return lit.at(pixel.x, pixel.y)[0];
    }
    // The first pixels below `floor`, for a message.
    static std::string darker(const Image& image, float floor)
    {
        std::string words;
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                if (image.at(x, y)[0] < floor && ++count <= 4)
                    words += std::to_string(image.at(x, y)[0]) + " at " + std::to_string(x) + ' ' + std::to_string(y) + "; ";
        return words + std::to_string(count) + " pixels";
    }
    static float least(const Image& image)
    {
        float result = 1.0f;
        for (int i = 0; i < image.width * image.height; ++i) result = std::min(result, image.pixels[std::size_t(i) * image.channels]);
        return result;
    }
};
}
