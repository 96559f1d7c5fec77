// Images and buffers from frame to frame.
#include "engine/graph/kept.hpp"
#include <cstring>

namespace afterglow
{
static const GpuImage* takeImage(Memory& memory, Kept& kept, const Resource& resource, VkImageUsageFlags usage)
{
    for (const auto& candidate : kept.images) {
        if (candidate->taken || !(candidate->image.shape == resource.shape) || (candidate->image.usage & usage) != usage) continue;
        candidate->taken = true;
        return &candidate->image;
    }
    kept.images.push_back(std::make_unique<KeptImage>(KeptImage{memory.image(resource.name, resource.shape, usage), true}));
    return &kept.images.back()->image;
}

static const GpuBuffer* takeBuffer(Memory& memory, Kept& kept, const Resource& resource)
{
    constexpr VkBufferUsageFlags kUsage =
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
    const bool uploaded = resource.origin == Origin::uploaded;
    for (const auto& candidate : kept.buffers) {
        const GpuBuffer& buffer = candidate->buffer;
        if (candidate->taken || buffer.bytes < resource.bytes || buffer.bytes > 2 * resource.bytes + 64 ||
            uploaded != (buffer.mapped != nullptr))
            continue;
        candidate->taken = true;
        return &candidate->buffer;
    }
    GpuBuffer made = memory.buffer(resource.name, resource.bytes, kUsage, uploaded ? Where::host : Where::device);
    kept.buffers.push_back(std::make_unique<KeptBuffer>(KeptBuffer{std::move(made), true}));
    return &kept.buffers.back()->buffer;
}

// The pair of images of one name; `current` is the one that this frame writes.
static const GpuImage* takeHistory(Memory& memory, Kept& kept, const Graph& graph, const Resource& resource, VkImageUsageFlags usage)
{
    const bool previous = resource.origin == Origin::historyPrevious;
    const std::string& name = previous ? graph.resources[resource.partner].name : resource.name;
    KeptHistory& history = kept.histories[name];
    const GpuImage& first = history.images[0];
    if (!first || !(first.shape == resource.shape) || (first.usage & usage) != usage)
        for (GpuImage& image : history.images) image = memory.image(name, resource.shape, usage); // zero: there is no past yet
    else if (!history.taken)
        history.current ^= 1;
    history.taken = true;
    return &history.images[previous ? history.current ^ 1 : history.current];
}

Objects provide(Memory& memory, Kept& kept, const Graph& graph, const Schedule& schedule)
{
    for (const auto& image : kept.images) image->taken = false;
    for (const auto& buffer : kept.buffers) buffer->taken = false;
    for (auto& [name, history] : kept.histories) history.taken = false;

    Objects objects;
    objects.images.resize(schedule.physicals.size());
    objects.buffers.resize(schedule.physicals.size());
    for (std::size_t p = 0; p < schedule.physicals.size(); ++p) {
        const Physical& physical = schedule.physicals[p];
        const Resource& resource = graph.resources[physical.resource];
        if (resource.origin == Origin::imported) {
            objects.images[p] = resource.image;
            objects.buffers[p] = resource.buffer;
        } else if (resource.isBuffer) {
            objects.buffers[p] = takeBuffer(memory, kept, resource);
            if (resource.origin == Origin::uploaded) std::memcpy(objects.buffers[p]->mapped, resource.data.data(), resource.data.size());
        } else if (resource.origin == Origin::transient) {
            objects.images[p] = takeImage(memory, kept, resource, physical.imageUsage);
        } else {
            objects.images[p] = takeHistory(memory, kept, graph, resource, physical.imageUsage);
        }
    }
    // Off means no byte: what this frame did not take is freed.
    std::erase_if(kept.images, [](const auto& image) { return !image->taken; });
    std::erase_if(kept.buffers, [](const auto& buffer) { return !buffer->taken; });
    std::erase_if(kept.histories, [](const auto& entry) { return !entry.second.taken; });
    return objects;
}
}
