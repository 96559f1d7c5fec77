// Which real image or buffer holds which resource. Two transients of one shape share a place when their lives do not overlap.
#include "engine/graph/schedule.hpp"
#include <algorithm>

namespace afterglow
{
// Each live resource as if it had a place of its own.
static std::vector<Physical> lives(const Graph& graph, const Schedule& schedule)
{
    std::vector<Physical> result(graph.resources.size());
    for (std::uint32_t p = 0; p < schedule.passes.size(); ++p)
        for (const Access& access : graph.passes[schedule.passes[p].pass].accesses) {
            if (access.resource == kNoResource) continue;
            Physical& life = result[access.resource];
            if (life.resource == kNoResource) life.first = p;
            life.resource = access.resource;
            life.last = p;
            life.imageUsage |= factsOf(access.use).imageUsage;
        }
    // What a repeated pass uses is used until the last repetition is over
    for (const Repeat& repeat : graph.repeats) {
        const auto isIn = [&](const ScheduledPass& scheduled) { return scheduled.pass >= repeat.first && scheduled.pass < repeat.last; };
        const auto from = std::find_if(schedule.passes.begin(), schedule.passes.end(), isIn);
        const auto first = std::uint32_t(from - schedule.passes.begin());
        const auto last = first + std::uint32_t(std::count_if(from, schedule.passes.end(), isIn)) - 1;
        for (Physical& life : result)
            if (life.resource != kNoResource && life.first <= last && life.last >= first)
                life.first = std::min(life.first, first), life.last = std::max(life.last, last);
    }
    const auto end = static_cast<std::uint32_t>(schedule.passes.size());
    for (std::uint32_t r = 0; r < result.size(); ++r) {
        const Resource& resource = graph.resources[r];
        if (resource.output) result[r].resource = r;
        if (resource.output || resource.origin != Origin::transient) result[r].last = end;
        if (resource.origin != Origin::imported) result[r].bytes = resource.isBuffer ? resource.bytes : imageBytes(resource.shape);
    }
    // Both sides of a history live when either does.
    for (std::uint32_t r = 0; r < result.size(); ++r) {
        const std::uint32_t partner = graph.resources[r].partner;
        if (partner == kNoResource || result[r].resource == kNoResource) continue;
        result[partner].resource = partner;
        result[r].imageUsage = result[partner].imageUsage = result[r].imageUsage | result[partner].imageUsage;
    }
    return result;
}

static bool fits(const Graph& graph, const Physical& place, const Physical& life)
{
    const Resource& a = graph.resources[place.resource];
    const Resource& b = graph.resources[life.resource];
    if (a.origin != Origin::transient || b.origin != Origin::transient || a.isBuffer != b.isBuffer || place.last >= life.first)
        return false;
    return a.isBuffer ? a.bytes == b.bytes : a.shape == b.shape;
}

void placeResources(const Graph& graph, Schedule& schedule)
{
    const std::vector<Physical> all = lives(graph, schedule);
    std::vector<std::uint32_t> order;
    for (std::uint32_t r = 0; r < all.size(); ++r)
        if (all[r].resource != kNoResource) order.push_back(r);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return all[a].first < all[b].first; });

    schedule.physicalOf.assign(all.size(), kNoResource);
    for (const std::uint32_t r : order) {
        const auto shared = std::find_if(schedule.physicals.begin(), schedule.physicals.end(),
                                         [&](const Physical& place) { return fits(graph, place, all[r]); });
        schedule.physicalOf[r] = static_cast<std::uint32_t>(shared - schedule.physicals.begin());
        if (shared == schedule.physicals.end()) {
            schedule.physicals.push_back(all[r]);
            continue;
        }
        shared->last = all[r].last;
        shared->imageUsage |= all[r].imageUsage;
    }
}
}
