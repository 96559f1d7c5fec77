// A graph compiled, in three steps.
#include "engine/graph/schedule.hpp"

namespace afterglow
{
Schedule compile(const Graph& graph)
{
    Schedule schedule;
    const std::vector<bool> live = livePasses(graph);
    for (std::uint32_t i = 0; i < live.size(); ++i) {
        if (live[i])
            schedule.passes.push_back({i, {}});
        else
            schedule.culled.push_back(graph.passes[i].name);
    }
    placeResources(graph, schedule);
    deriveBarriers(graph, schedule);
    return schedule;
}
}
