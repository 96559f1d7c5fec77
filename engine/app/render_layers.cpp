#include "engine/app/render_layers.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
struct Part {
    const char* name;
    const Texture Layers::*texture;
};
constexpr Part kLight[] = {{"direct", &Layers::direct},
                           {"indirect", &Layers::indirect},
                           {"reflection", &Layers::reflection},
                           {"emission", &Layers::emission},
                           {"fog", &Layers::fog}};

// Where this frame has nothing of a layer.
Image even(const Image& beauty, int count, float value)
{
    Image image(beauty.width, beauty.height, count);
    std::fill(image.pixels.begin(), image.pixels.end(), value);
    return image;
}

// What bloom adds to each pixel; less than nothing where it takes more than it brings.
Image addedByBloom(const Executor& executor, const Pictures& pictures, const Image& beauty)
{
    Image added = channels(executor.download(pictures.bloomed), 0, 3);
    for (std::size_t i = 0; i < added.pixels.size(); ++i) added.pixels[i] -= beauty.pixels[i];
    return added;
}
}

void outputLayers(Graph& graph, const Pictures& pictures)
{
    graph.output(pictures.radiance);
    graph.output(pictures.bloomed);
    for (const Part& part : kLight)
        if (const Texture& texture = pictures.layers.*part.texture) graph.output(texture);
    for (const Texture& texture : {pictures.layers.occlusion, pictures.layers.surface, pictures.layers.ids, pictures.layers.motion})
        if (texture) graph.output(texture);
}

std::vector<Layer> downloadLayers(const Executor& executor, const Pictures& pictures)
{
    const Image beauty = channels(executor.download(pictures.radiance), 0, 3);
    std::vector<Layer> layers = {{"", beauty}, {"beauty", beauty}};
    for (const Part& part : kLight) {
        const Texture& texture = pictures.layers.*part.texture;
        layers.push_back({part.name, texture ? channels(executor.download(texture), 0, 3) : even(beauty, 3, 0.0f)});
    }
    layers.push_back({"bloom", addedByBloom(executor, pictures, beauty)});
    const Texture &open = pictures.layers.occlusion, &motion = pictures.layers.motion;
    layers.push_back({"ao", open ? channels(executor.download(open), 0, 1) : even(beauty, 1, 1.0f)});
    const Image surface = executor.download(pictures.layers.surface);
    layers.push_back({"depth", channels(surface, 3, 1), /* exact= */ true, "Z"});
    layers.push_back({"normal", channels(surface, 0, 3), /* exact= */ true, "XYZ"});
    layers.push_back({"motion", motion ? executor.download(motion) : even(beauty, 4, 0.0f), /* exact= */ true, "XYZW"});
    const Image ids = executor.download(pictures.layers.ids);
    layers.push_back({"object_id", channels(ids, 0, 1), /* exact= */ true, "X"});
    layers.push_back({"material_id", channels(ids, 1, 1), /* exact= */ true, "X"});
    return layers;
}
}
