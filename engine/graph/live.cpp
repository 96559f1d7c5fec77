// Which passes live: those that an output depends on, directly or through what the next frame reads.
#include "engine/core/error.hpp"
#include "engine/graph/schedule.hpp"
#include <set>

namespace afterglow
{
// (resource, version) pairs that somebody needs.
using Needed = std::set<std::pair<std::uint32_t, std::uint32_t>>;

static Needed roots(const Graph& graph)
{
    Needed needed;
    for (std::uint32_t r = 0; r < graph.resources.size(); ++r) {
        const Resource& resource = graph.resources[r];
        const bool outlives = resource.output || resource.origin == Origin::imported; // writing what lives outside is an effect of its own
        if (outlives && resource.version > 0) needed.insert({r, resource.version});
        check(!resource.output || resource.version > 0 || resource.origin != Origin::transient,
              "output " + resource.name + " is never written");
    }
    return needed;
}

static bool isNeeded(const PassData& pass, const Needed& needed)
{
    for (const Access& access : pass.accesses)
        if (writes(access.use) && needed.contains({access.resource, access.version})) return true;
    return false;
}

static void needInputs(const Graph& graph, const PassData& pass, Needed& needed)
{
    for (const Access& access : pass.accesses) {
        if (access.resource == kNoResource) continue;
        const Resource& resource = graph.resources[access.resource];
        const bool keepsOld = writes(access.use) && (reads(access.use) || access.partial);
        if (!reads(access.use) && !keepsOld) continue;
        const std::uint32_t version = keepsOld ? access.version - 1 : access.version;
        check(version > 0 || resource.origin != Origin::transient,
              "pass " + pass.name + " reads " + resource.name + ", which nothing wrote");
        needed.insert({access.resource, version});
        // What is read of the last frame must be written in this one, for the next.
        if (resource.origin == Origin::historyPrevious) needed.insert({resource.partner, graph.resources[resource.partner].version});
    }
}

std::vector<bool> livePasses(const Graph& graph)
{
    std::vector<bool> live(graph.passes.size(), false);
    Needed needed = roots(graph);
    // Backwards, so that needs are known before their makers are met; again while histories add needs.
    for (std::size_t before = ~std::size_t(0); before != needed.size();) {
        before = needed.size();
        for (std::size_t i = graph.passes.size(); i-- > 0;) {
            if (!isNeeded(graph.passes[i], needed)) continue;
            live[i] = true;
            needInputs(graph, graph.passes[i], needed);
        }
    }
    return live;
}
}
