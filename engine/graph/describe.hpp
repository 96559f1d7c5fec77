// A frame in words, for `afterglow graph`: a line a pass (reads, writes, bytes, ms), or Graphviz.
#pragma once
#include "engine/graph/executor.hpp"

namespace afterglow
{
std::string describe(const FrameStats& stats);
std::string describeDot(const Graph& graph, const Schedule& schedule);
}
