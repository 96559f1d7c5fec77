// One pass as data: what it reads and writes, its shaders and state. Declared in one expression:
//   graph.compute("fog", "engine/effects/fog/fog.comp").read(depth).read(sunlight).write(foggy).push(FogPush{...}).dispatch(foggy.size());
#pragma once
#include "engine/gpu/pipeline.hpp"
#include "engine/graph/resource.hpp"
#include "engine/graph/use.hpp"
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace afterglow
{
class Draw; // draw.hpp: what a raster pass's function draws with

struct Access {
    std::uint32_t resource = kNoResource;
    std::uint32_t version = 0; // read: the version seen; written: the version made. Every write makes a new one.
    Use use = Use::sampled;
    bool partial = false; // written in part: the rest keeps the version before
    ImageRange range;     // textures
    ImageKind kind = ImageKind::flat;
    Sampler sampler = Sampler::nearest;
    glm::vec4 clear{0}; // color; depth takes x. 0 is infinitely far
};

enum class PassKind { compute, fullscreen, raster, trace, copy, fill };

// The programs of a pass that traces rays: `begin` (.rgen) runs once for each invocation; a ray that it traces says which of the others it
// means.
struct RayPrograms {
    std::string begin;
    std::vector<std::string> misses;
    std::vector<HitPrograms> hits;
};

struct PassData {
    std::string name;
    PassKind kind = PassKind::compute;
    std::vector<Access> accesses; // in the declared order
    PipelineKey key;              // shaders, constants, blend, depth state; the executor adds the formats
    std::vector<std::uint8_t> pushed;
    glm::uvec3 threads{0};     // compute, trace: invocations wanted; groups of compute follow from the shader's local_size
    VkDeviceSize groupsAt = 0; // compute that is dispatched by a buffer: where in it the groups stand
    std::function<void(Draw&)> draw;
    float biasConstant = 0, biasSlope = 0; // depth bias; reversed depth: negative moves away from the viewer
    std::uint32_t value = 0;               // fill
};

class Graph;

// The expression that declares a pass. Each call returns the same pass. Calls that do not fit its kind are programmer's errors.
class Pass
{
public:
    Pass(Graph& graph, std::uint32_t index) : graph_(graph), index_(index) {}

    // Bindings of set 1, numbered 0, 1, 2 ... in the order of these calls (attachments take no number).
    Pass& read(const Texture& texture, Sampler sampler = Sampler::nearest);
    Pass& read(const Buffer& buffer);
    Pass& write(const Buffer& buffer);  // wholly overwritten
    Pass& modify(const Buffer& buffer); // read and written

    // A texture written: compute, trace: the next binding, of which every texel is overwritten. Raster and full screen: the next colour
    // attachment, or the depth attachment if its format is depth. Raster starts from `clear` (0 is infinitely far); full screen overwrites
    // every pixel. An empty texture keeps its attachment's number and nothing is bound: what the shader writes there is lost.
    Pass& write(const Texture& texture, glm::vec4 clear = glm::vec4(0));
    Pass& modify(const Texture& texture); // the same, on top of what is there
    Pass& test(const Texture& depth);     // depth attachment, tested but not written (it may be sampled in the same pass)

    Pass& copyFrom(const Texture& texture) { return access(texture.index, Use::copyFrom, &texture); }
    Pass& copyTo(const Texture& texture) { return access(texture.index, Use::copyTo, &texture); }
    Pass& copyTo(const Buffer& buffer) { return access(buffer.index, Use::copyTo, nullptr); }

    Pass& specialize(std::uint32_t id, std::uint32_t value);
    Pass& specialize(std::uint32_t id, float value);
    Pass& specialize(std::uint32_t id, bool value);

    // Push constants as the shader's block declares them (scalar layout); the sizes must agree.
    template <typename T>
    Pass& push(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        return pushBytes(&value, sizeof(T));
    }
    Pass& pushBytes(const void* data, std::size_t bytes);

    Pass& dispatch(glm::uvec2 threads) { return dispatch(glm::uvec3(threads, 1)); } // at least so many invocations: bounds-check
    Pass& dispatch(glm::uvec3 threads);
    Pass& dispatch(const Buffer& groups, VkDeviceSize at); // work groups across, down and deep: three uints of the buffer, at this byte
    Pass& draw(std::function<void(Draw&)> function);       // raster: records the draws, called once when the pass runs
    Pass& bias(float constant, float slope);
    Pass& blend(Blend blend);

private:
    PassData& data();
    Pass& access(std::uint32_t resource, Use use, const Texture* texture, Sampler sampler = Sampler::nearest, glm::vec4 clear = {});
    Graph& graph_;
    std::uint32_t index_;
};
}
