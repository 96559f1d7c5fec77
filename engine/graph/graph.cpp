// Declaring a frame.
#include "engine/graph/graph.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
static Texture handleOf(const std::vector<Resource>& resources)
{
    Texture texture;
    texture.index = static_cast<std::uint32_t>(resources.size() - 1);
    texture.shape = resources.back().shape;
    texture.kind = texture.shape.kind;
    return texture;
}

static Buffer bufferOf(const std::vector<Resource>& resources)
{
    return {static_cast<std::uint32_t>(resources.size() - 1), resources.back().bytes};
}

Texture Graph::texture(const std::string& name, VkFormat format, glm::uvec2 size)
{
    return texture(name, ImageShape{format, glm::uvec3(size, 1)});
}

Texture Graph::texture(const std::string& name, const ImageShape& shape)
{
    check(shape.size.x && shape.size.y && shape.size.z && shape.mips && shape.layers, "texture " + name + " has no texels");
    Resource made;
    made.name = scope + name;
    made.shape = shape;
    resources.push_back(std::move(made));
    return handleOf(resources);
}

Buffer Graph::buffer(const std::string& name, VkDeviceSize bytes)
{
    Resource made;
    made.name = scope + name;
    made.isBuffer = true;
    made.bytes = bytes;
    resources.push_back(std::move(made));
    return bufferOf(resources);
}

Buffer Graph::uploadBytes(const std::string& name, const void* data, std::size_t bytes)
{
    const Buffer handle = buffer(name, bytes);
    const auto* from = static_cast<const std::uint8_t*>(data);
    resources.back().data.assign(from, from + bytes);
    resources.back().origin = Origin::uploaded;
    return handle;
}

Texture Graph::import(const GpuImage& image)
{
    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        if (resources[i].image != &image) continue;
        Texture known;
        known.index = i;
        known.shape = image.shape;
        known.kind = image.shape.kind;
        return known;
    }
    Resource made;
    made.name = image.name;
    made.origin = Origin::imported;
    made.shape = image.shape;
    made.image = &image;
    resources.push_back(std::move(made));
    return handleOf(resources);
}

Buffer Graph::import(const GpuBuffer& buffer)
{
    for (std::uint32_t i = 0; i < resources.size(); ++i)
        if (resources[i].buffer == &buffer) return {i, resources[i].bytes};
    Resource made;
    made.name = buffer.name;
    made.origin = Origin::imported;
    made.isBuffer = true;
    made.bytes = buffer.bytes;
    made.buffer = &buffer;
    resources.push_back(std::move(made));
    return bufferOf(resources);
}

History Graph::history(const std::string& name, VkFormat format, glm::uvec2 size)
{
    History pair{texture(name + ".previous", format, size), texture(name, format, size)};
    resources[pair.previous.index].origin = Origin::historyPrevious;
    resources[pair.previous.index].partner = pair.current.index;
    resources[pair.current.index].origin = Origin::historyCurrent;
    resources[pair.current.index].partner = pair.previous.index;
    return pair;
}

static PassData& add(std::vector<PassData>& passes, const std::string& name, PassKind kind, std::vector<std::string> shaders)
{
    PassData& made = passes.emplace_back();
    made.name = name;
    made.kind = kind;
    made.key.shaders = std::move(shaders);
    return made;
}

Pass Graph::last() { return Pass(*this, static_cast<std::uint32_t>(passes.size() - 1)); }

Pass Graph::compute(const std::string& name, const std::string& shader)
{
    add(passes, scope + name, PassKind::compute, {shader});
    return last();
}

Pass Graph::fullscreen(const std::string& name, const std::string& fragmentShader)
{
    add(passes, scope + name, PassKind::fullscreen, {"engine/gpu/fullscreen.vert", fragmentShader});
    return last();
}

Pass Graph::raster(const std::string& name, const std::string& vertexShader, const std::string& fragmentShader)
{
    PassData& made = add(passes, scope + name, PassKind::raster, {vertexShader});
    if (!fragmentShader.empty()) made.key.shaders.push_back(fragmentShader);
    return last();
}

Pass Graph::trace(const std::string& name, const RayPrograms& programs)
{
    PipelineKey& key = add(passes, scope + name, PassKind::trace, {programs.begin}).key;
    key.shaders.insert(key.shaders.end(), programs.misses.begin(), programs.misses.end());
    for (const HitPrograms& hit : programs.hits)
        for (const std::string& program : {hit.closest, hit.any})
            if (!program.empty() && std::find(key.shaders.begin(), key.shaders.end(), program) == key.shaders.end())
                key.shaders.push_back(program);
    key.hits = programs.hits;
    return last();
}

Pass Graph::copy(const std::string& name, const Texture& from, const Texture& to)
{
    add(passes, scope + name, PassKind::copy, {});
    Pass pass = last();
    const auto one = [](const Texture& t) { return t.mip(0).layer(0); };
    pass.copyFrom(one(from)).copyTo(one(to));
    return pass;
}

Pass Graph::fill(const std::string& name, const Buffer& buffer, std::uint32_t value)
{
    add(passes, scope + name, PassKind::fill, {}).value = value;
    Pass pass = last();
    pass.copyTo(buffer);
    return pass;
}

void Graph::repeat(const Buffer& left, const std::function<void()>& declare)
{
    const auto first = static_cast<std::uint32_t>(passes.size());
    declare();
    repeats.push_back({first, static_cast<std::uint32_t>(passes.size()), left.index});
    output(left);
}

void Graph::output(const Texture& texture)
{
    check(texture.index < resources.size(), "an output must be a texture of this graph");
    resources[texture.index].output = true;
}

void Graph::output(const Buffer& buffer)
{
    check(buffer.index < resources.size(), "an output must be a buffer of this graph");
    resources[buffer.index].output = true;
}
}
