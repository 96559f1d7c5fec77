// The tree of probes, made quick to walk down: an even grid of boxes, each of which names what of the tree lies in it.
#pragma once
#include "engine/baked/probe_tree.hpp"
#include "shaders/gpu_baked.h"

namespace afterglow
{
struct QuickTree {
    ProbeGrid grid;
    std::vector<int> starts;      // of each box: a node, or ~cell
    std::vector<ProbeNode> nodes; // those of the tree, then those of boxes: planes that miss a box are left out there
};
// A walk from there ends in the same cell as one from the root, whatever the rounding of either.
QuickTree quickTree(const ProbeTree& tree);
}
