// What every stage of a bake shares, and how one of its units of work is done.
#pragma once
#include "baker/journal.hpp"
#include "baker/solids.hpp"
#include "baker/tracer.hpp"
#include "engine/core/progress.hpp"
#include <functional>
#include <initializer_list>
#include <memory>
#include <mutex>

namespace afterglow
{
struct LightLayers;

// What the light of a layer is called by in the files of bakes (key.hpp).
struct LayerKey {
    std::uint64_t number = 0; // of all that it depends on; 0: none
    std::uint64_t family = 0; // of the same, whatever stands where; of --light-layers alone the same
    bool asksForMoves() const { return family != number; }
};

struct BakeContext {
    const LightTransport& transport;
    const Solids solids;
    std::vector<Light> direct; // lights whose direct part the bake holds
    std::uint32_t seed = 1;
    int threads = 0;
    bool directional = false; // lightmaps say where their light comes from
    Progress& progress;
    Journal* journal = nullptr;              // none: nothing is kept
    bool streamed = false;                   // the light of tiles waits in the journal, not in memory
    bool caches = false;                     // paths may end at surfaces whose light is known
    std::shared_ptr<const LightCache> cache; // what is known; null: nothing
    bool tells = false;                      // paths of lightmaps tell what falls on the base of surfaces, for a cache
    LightLayers* layers = nullptr;           // of which lightmaps are the sum (light_layers.hpp); null: all light is one
    LayerKey layer;                          // of the light that is traced here; none: nothing is kept for a later bake
    const Journal* earlier = nullptr;        // what an earlier bake kept; null: nothing

    BakeContext(const LightTransport& t, Solids s, std::vector<Light> d, Progress& p)
        : transport(t), solids(std::move(s)), direct(std::move(d)), progress(p)
    {
    }

    void count(const RayCount& more)
    {
        std::lock_guard lock(counting_);
        rays_ += more;
    }
    const RayCount& rays() const { return rays_; } // no unit being done

private:
    std::mutex counting_;
    RayCount rays_;
};

// What a unit fills, as bytes.
using ByteSpan = std::span<std::uint8_t>;
template <class Result>
ByteSpan bytesOf(std::span<Result> result)
{
    static_assert(std::is_trivially_copyable_v<Result>);
    return {reinterpret_cast<std::uint8_t*>(result.data()), result.size_bytes()};
}

// Fills `result` from a journal; false: it holds no such unit, or one of another size.
bool recalled(const Journal& journal, const Unit& unit, std::initializer_list<ByteSpan> result, RayCount& rays);

// The same from the bake's own, which holds the unit. Throws Error when the disk did not take it.
void readBack(const BakeContext& context, const Unit& unit, std::initializer_list<ByteSpan> result);

// Fills `result` by `work`, which counts its rays, or from the journal that holds it already; tells `amount` of progress. From any thread.
void doUnit(BakeContext& context, const Unit& unit, std::initializer_list<ByteSpan> result, std::uint64_t amount,
            const std::function<void(RayCount& rays)>& work);
}
