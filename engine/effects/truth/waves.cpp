// The wavefront: paths begin, then meet, scatter, ask their lights and end, all of them step by step, until none is left.
#include "engine/effects/truth/waves.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
// Steps of one submission, even: the host asks between them whether any path is left. On lavapipe 2, 8 and 32 take the same CPU time within
// 6 % (cornell, 256x256, 6 paths a pixel).
constexpr int kStepsTogether = 8;

constexpr VkDeviceSize groupsOf(uint queue) { return queue * sizeof(WaveQueue); }

struct Wave {
    const PathTracing& paths;
    Buffer queues, queued, vectors, hits, shadows;
    uint slots;

    Pass pass(const std::string& name, uint from) const
    {
        Pass made = paths.graph.compute("truth." + name, "engine/effects/truth/" + name + ".comp");
        return made.push(WavePush{paths.added, slots, from});
    }
    // Of these each is given all of the memory, so that one text declares it.
    Pass kernel(const std::string& name, uint from) const
    {
        Pass made = pass(name, from);
        return give(made, paths).modify(queues).modify(queued).modify(vectors).modify(hits).modify(shadows);
    }
    void begin() const
    {
        Pass made = pass("begin", 0);
        give(made, paths).write(queues).write(queued).write(vectors).write(hits).write(shadows).dispatch(uvec2(slots, 1));
    }
    void step(uint from) const
    {
        pass("turn", from).modify(queues).dispatch(uvec2(1));
        kernel("extend", from).dispatch(queues, groupsOf(from));
        kernel("shade", from).dispatch(queues, groupsOf(from));
        kernel("shadow", from).dispatch(queues, groupsOf(kShadowQueue));
        kernel("close", from).dispatch(queues, groupsOf(from));
    }
};
}

Texture traceWaves(const PathTracing& paths)
{
    Graph& graph = paths.graph;
    const uvec2 size = paths.samples.of.picture.size;
    const Texture sum = graph.import(paths.samples.sum), mean = graph.texture("truth", VK_FORMAT_R32G32B32A32_SFLOAT, size);
    if (paths.added.count > 0) {
        const uint slots = std::min(size.x * size.y, kMostSlots);
        const auto buffer = [&](const char* name, VkDeviceSize bytes) { return graph.buffer(std::string("truth.") + name, bytes); };
        const Wave wave{paths,
                        buffer("queues", (kShadowQueue + 1) * sizeof(WaveQueue)),
                        buffer("queued", VkDeviceSize(slots) * (2 + kDirectCategories) * sizeof(uint)),
                        buffer("paths", VkDeviceSize(slots) * kPathVectors * sizeof(uvec4)),
                        buffer("hits", VkDeviceSize(slots) * sizeof(Hit)),
                        buffer("shadow rays", VkDeviceSize(slots) * kDirectCategories * sizeof(ShadowRay)),
                        slots};
        wave.begin();
        graph.repeat(wave.queues, [&] {
            for (int i = 0; i < kStepsTogether; ++i) wave.step(uint(i) % 2);
        });
    }
    graph.compute("truth.mean", "engine/effects/truth/mean.comp").modify(sum).write(mean).push(paths.added).dispatch(size);
    return mean;
}
}
