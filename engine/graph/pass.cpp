// Declaring a pass: every call is checked when it is made, so that the mistake is found where it stands.
#include "engine/graph/pass.hpp"
#include "engine/core/error.hpp"
#include "engine/graph/graph.hpp"
#include <cstring>

namespace afterglow
{
PassData& Pass::data() { return graph_.passes[index_]; }

Pass& Pass::access(std::uint32_t resource, Use use, const Texture* texture, Sampler sampler, glm::vec4 clear)
{
    PassData& pass = data();
    Access made;
    made.resource = resource;
    made.use = use;
    made.sampler = sampler;
    made.clear = clear;
    if (texture) {
        made.range = texture->range;
        made.kind = texture->kind;
    }
    if (resource == kNoResource) {
        check((isBinding(use) && !writes(use)) || isColorUse(use),
              "pass " + pass.name + " writes to nothing: an empty handle may be read, or be an attachment that keeps its number");
        pass.accesses.push_back(made);
        return *this;
    }
    check(resource < graph_.resources.size(), "pass " + pass.name + " uses a resource of another graph");
    Resource& target = graph_.resources[resource];
    check(target.isBuffer == (texture == nullptr), "pass " + pass.name + " takes " + target.name + " for what it is not");
    made.version = target.version;
    if (writes(use)) {
        check(target.origin != Origin::historyPrevious && target.origin != Origin::uploaded,
              "pass " + pass.name + " writes " + target.name + ", which may only be read");
        // Writing a part keeps the rest: the versions before are needed still.
        if (texture && !reads(use) && resolve(made.range, target.shape) != whole(target.shape)) made.partial = target.version > 0;
        made.version = ++target.version;
    }
    pass.accesses.push_back(made);
    return *this;
}

Pass& Pass::read(const Texture& texture, Sampler sampler) { return access(texture.index, Use::sampled, &texture, sampler); }
Pass& Pass::read(const Buffer& buffer) { return access(buffer.index, Use::bufferRead, nullptr); }
Pass& Pass::write(const Buffer& buffer) { return access(buffer.index, Use::bufferWrite, nullptr); }
Pass& Pass::modify(const Buffer& buffer) { return access(buffer.index, Use::bufferModify, nullptr); }

static bool rasterizes(const PassData& pass) { return pass.kind == PassKind::raster || pass.kind == PassKind::fullscreen; }

Pass& Pass::write(const Texture& texture, glm::vec4 clear)
{
    if (!rasterizes(data())) return access(texture.index, Use::stored, &texture);
    return access(texture.index, isDepth(texture.format()) ? Use::depth : Use::color, &texture, Sampler::nearest, clear);
}

Pass& Pass::modify(const Texture& texture)
{
    if (!rasterizes(data())) return access(texture.index, Use::storedModify, &texture);
    return access(texture.index, isDepth(texture.format()) ? Use::depthModify : Use::colorModify, &texture);
}

Pass& Pass::test(const Texture& depth)
{
    check(rasterizes(data()), "pass " + data().name + " has no depth test: it is not a raster pass");
    data().key.depthWrite = false;
    return access(depth.index, Use::depthTest, &depth);
}

Pass& Pass::specialize(std::uint32_t id, std::uint32_t value)
{
    data().key.constants[id] = value;
    return *this;
}
Pass& Pass::specialize(std::uint32_t id, bool value) { return specialize(id, value ? 1u : 0u); }
Pass& Pass::specialize(std::uint32_t id, float value)
{
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof(bits));
    return specialize(id, bits);
}

Pass& Pass::pushBytes(const void* bytes, std::size_t size)
{
    const auto* from = static_cast<const std::uint8_t*>(bytes);
    data().pushed.assign(from, from + size);
    return *this;
}

Pass& Pass::dispatch(glm::uvec3 threads)
{
    check(data().kind == PassKind::compute || data().kind == PassKind::trace,
          "pass " + data().name + " cannot be dispatched: it neither computes nor traces");
    data().threads = threads;
    return *this;
}

Pass& Pass::dispatch(const Buffer& groups, VkDeviceSize at)
{
    check(data().kind == PassKind::compute, "pass " + data().name + " is dispatched by a buffer, and does not compute");
    data().groupsAt = at;
    return access(groups.index, Use::indirect, nullptr);
}

Pass& Pass::draw(std::function<void(Draw&)> function)
{
    check(data().kind == PassKind::raster, "pass " + data().name + " draws nothing of its own: it is not a raster pass");
    data().draw = std::move(function);
    return *this;
}

Pass& Pass::blend(Blend blend) { return data().key.blend = blend, *this; }
Pass& Pass::bias(float constant, float slope)
{
    data().key.depthBias = true;
    data().biasConstant = constant;
    data().biasSlope = slope;
    return *this;
}
}
