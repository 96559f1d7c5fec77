#include "engine/effects/bloom/bloom.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
// float32: a hundredth of a pixel's light must not be lost on the way, and half floats are no cheaper to fetch (lavapipe).
constexpr VkFormat kLevelFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

bool uneven(uvec2 fine, uvec2 coarse) { return fine != coarse * 2u; }

// The picture, then each level half as large: at least one of them.
std::vector<Texture> down(Graph& graph, const Texture& image, uint coarsest)
{
    std::vector<Texture> levels{image};
    do {
        const Texture fine = levels.back();
        const std::string name = "bloom.down." + std::to_string(levels.size());
        levels.push_back(graph.texture(name, kLevelFormat, (fine.size() + 1u) / 2u));
        graph.fullscreen(name, "engine/effects/bloom/down.frag")
            .read(fine)
            .write(levels.back())
            .specialize(kBloomUneven, uneven(fine.size(), levels.back().size()))
            .specialize(kBloomFirst, levels.size() == 2);
    } while (std::max(levels.back().size().x, levels.back().size().y) > coarsest);
    return levels;
}
}

Texture bloom(Graph& graph, const Texture& image, const BloomParameters& parameters)
{
    check(parameters.coarsest > 0, "the coarsest level of a bloom has a size");
    const std::vector<Texture> levels = down(graph, image, parameters.coarsest);
    Texture glare = levels.back();
    for (std::size_t level = levels.size() - 1; level-- > 0;) {
        const Texture own = levels[level], coarse = glare;
        const std::string name = level == 0 ? "bloom" : "bloom.up." + std::to_string(level);
        glare = graph.texture(name, level == 0 ? image.format() : kLevelFormat, own.size());
        graph.fullscreen(name, "engine/effects/bloom/up.frag")
            .read(own)
            .read(coarse)
            .write(glare)
            .specialize(kBloomUneven, uneven(own.size(), coarse.size()))
            .specialize(kBloomFirst, level == 0)
            .push(BloomPush{level == 0 ? parameters.strength : parameters.spread});
    }
    return glare;
}
}
