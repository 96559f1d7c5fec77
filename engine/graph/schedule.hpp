// A graph compiled, still plain data: which passes live, which images they share, which barriers stand before each. No Vulkan call.
#pragma once
#include "engine/graph/graph.hpp"
#include "engine/graph/state.hpp"

namespace afterglow
{
// One real image or buffer of the frame. Transients of the same shape whose lives do not overlap share one.
struct Physical {
    std::uint32_t resource = kNoResource; // the first one that it holds
    VkImageUsageFlags imageUsage = 0;
    std::uint64_t bytes = 0;           // 0 for what is not the frame's own
    std::uint32_t first = 0, last = 0; // scheduled passes
};

struct Barrier {
    std::uint32_t physical = kNoResource;
    ImageRange range; // images: counts are never 0 here
    State before, after;
};

struct ScheduledPass {
    std::uint32_t pass = 0;        // into Graph::passes
    std::vector<Barrier> barriers; // before it
};

struct Schedule {
    std::vector<ScheduledPass> passes;
    std::vector<Barrier> last; // after all of them: everything that stays returns to its rest
    std::vector<Physical> physicals;
    std::vector<std::uint32_t> physicalOf; // resource -> physical, kNoResource: culled
    std::vector<std::string> culled;       // names of passes that nothing depends on
};

// Throws Error when a pass reads what nothing wrote.
Schedule compile(const Graph& graph);

// The steps of compile, each tested alone.
std::vector<bool> livePasses(const Graph& graph);
void placeResources(const Graph& graph, Schedule& schedule);
void deriveBarriers(const Graph& graph, Schedule& schedule);
}
