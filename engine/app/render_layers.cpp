#include "engine/app/render_layers.hpp"

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

// `count` channels from `first` on.
Image channels(const Image& image, int first, int count)
{
    Image part(image.width, image.height, count);
    for (std::size_t i = 0; i < std::size_t(image.width) * image.height; ++i)
        for (int c = 0; c < count; ++c) part.pixels[i * count + c] = image.pixels[i * image.channels + first + c];
    return part;
}
}

void outputLayers(Graph& graph, const Pictures& pictures)
{
    graph.output(pictures.radiance);
    for (const Part& part : kLight)
        if (const Texture& texture = pictures.layers.*part.texture) graph.output(texture);
    if (pictures.layers.occlusion) graph.output(pictures.layers.occlusion);
    graph.output(pictures.layers.surface);
    graph.output(pictures.layers.ids);
}

std::vector<Layer> downloadLayers(const Executor& executor, const Pictures& pictures)
{
    const Image beauty = channels(executor.download(pictures.radiance), 0, 3);
    std::vector<Layer> layers = {{"", beauty}, {"beauty", beauty}};
    for (const Part& part : kLight) {
        const Texture& texture = pictures.layers.*part.texture;
        layers.push_back({part.name, texture ? channels(executor.download(texture), 0, 3) : Image(beauty.width, beauty.height, 3)});
    }
    if (const Texture& open = pictures.layers.occlusion)
        layers.push_back({"ao", channels(executor.download(open), 0, 1), /* exact= */ false, "Y"});
    const Image surface = executor.download(pictures.layers.surface);
    layers.push_back({"depth", channels(surface, 3, 1), /* exact= */ true, "Z"});
    layers.push_back({"normal", channels(surface, 0, 3), /* exact= */ true, "XYZ"});
    const Image ids = executor.download(pictures.layers.ids);
    layers.push_back({"object_id", channels(ids, 0, 1), /* exact= */ true, "X"});
    layers.push_back({"material_id", channels(ids, 1, 1), /* exact= */ true, "X"});
    return layers;
}
}
