// The walk down the tree of probes from the box that holds a point: it ends where one from the root ends, and is shorter.
#include "engine/baked/probe_read.hpp"
#include "engine/upload/probe_grid.hpp"
#include <gtest/gtest.h>
#include <random>

namespace afterglow
{
class ProbeGridTest : public ::testing::Test
{
protected:
    float between(float least, float most) { return least + (most - least) * float(engine() >> 8u) / 16777216.0f; }
    vec3 within(vec3 lower, vec3 upper)
    {
        const float x = between(lower.x, upper.x), y = between(lower.y, upper.y);
        return {x, y, between(lower.z, upper.z)};
    }

    // Parts a box by planes through points of it, every third of which is slanted; a cell's number is that of its box.
    int part(ProbeTree& tree, vec3 lower, vec3 upper, int depth)
    {
        if (depth == 0) {
            tree.cells.push_back({lower, 1.0f / (upper - lower), {}});
            return ~int(tree.cells.size() - 1);
        }
        const int axis = depth % 3;
        const vec3 through = within(mix(lower, upper, 0.3f), mix(lower, upper, 0.7f));
        vec3 normal(0.0f), below = upper, above = lower;
        normal[axis] = 1.0f;
        if (engine() % 3u == 0u) normal = normalize(normal + within(vec3(-0.3f), vec3(0.3f)));
        below[axis] = above[axis] = through[axis];
        const std::size_t node = tree.nodes.size();
        tree.nodes.push_back({normal, dot(normal, through), 0, 0});
        const int under = part(tree, lower, below, depth - 1), over = part(tree, above, upper, depth - 1);
        tree.nodes[node].below = under, tree.nodes[node].above = over;
        return int(node);
    }
    ProbeTree partedSpace(vec3 lower, vec3 upper)
    {
        ProbeTree tree;
        part(tree, lower, upper, 9);
        return tree;
    }

    // The cell, and how many planes were asked.
    template <typename Nodes>
    static std::pair<int, int> walk(const Nodes& nodes, int at, vec3 position)
    {
        int asked = 0;
        for (; at >= 0; asked++) {
            const ProbeNode& node = nodes[std::size_t(at)];
            at = dot(node.normal, position) > node.offset ? node.above : node.below;
        }
        return {at, asked};
    }

    std::mt19937 engine{7u};
};

TEST_F(ProbeGridTest, AWalkEndsWhereOneFromTheRootEnds)
{
    for (const vec3 middle : {vec3(0.0f), vec3(900.0f, -20.0f, 4000.0f)}) {
        const ProbeTree tree = partedSpace(middle - vec3(4, 2, 3), middle + vec3(4, 2, 3));
        const QuickTree quick = quickTree(tree);
        int before = 0, now = 0;
        for (int i = 0; i < 40000; i++) {
            const float reach = i % 8 == 0 ? 50.0f : 4.5f; // some of them far outside
            vec3 p = within(middle - reach, middle + reach);
            if (i % 2 == 0) { // in a plane, but for rounding
                const ProbeNode& node = tree.nodes[engine() % tree.nodes.size()];
                p += node.normal * (node.offset - dot(node.normal, p));
            }
            const auto root = walk(tree.nodes, 0, p);
            const auto box = walk(quick.nodes, quick.starts[std::size_t(probeGridBox(quick.grid, p))], p);
            ASSERT_EQ(root.first, box.first) << p.x << " " << p.y << " " << p.z;
            before += root.second, now += box.second;
        }
        EXPECT_LT(3 * now, before);
    }
}

// H83: a place that is none still finds a cell.
TEST_F(ProbeGridTest, NoPlaceIsOutsideOfTheBoxes)
{
    const ProbeTree tree = partedSpace(vec3(-1), vec3(1));
    const QuickTree quick = quickTree(tree);
    const float infinite = std::numeric_limits<float>::infinity();
    for (const float x : {std::nanf(""), infinite, -infinite, 1e38f, -1e38f}) {
        const int box = probeGridBox(quick.grid, vec3(x, 0.0f, x));
        ASSERT_GE(box, 0);
        ASSERT_LT(std::size_t(box), quick.starts.size());
        EXPECT_LT(walk(quick.nodes, quick.starts[std::size_t(box)], vec3(x, 0.0f, x)).first, 0);
    }
}

// One cell is all of space, with a flat box or without; its box may be a point.
TEST_F(ProbeGridTest, OneCellNeedsNoWalk)
{
    for (const vec3 perExtent : {vec3(1.0f), vec3(1.0f, 0.0f, 1.0f), vec3(0.0f)}) {
        ProbeTree tree;
        tree.cells = {{vec3(2.0f), perExtent, {}}};
        tree.nodes = {{vec3(0.0f), 0.0f, ~0, ~0}};
        const QuickTree quick = quickTree(tree);
        for (const int start : quick.starts) EXPECT_EQ(start, ~0);
    }
}
}
