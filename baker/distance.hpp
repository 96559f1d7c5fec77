// How far two surfaces lie apart: distances of points to triangles, through a tree of boxes.
#pragma once
#include "shaders/glsl.h"
#include <array>
#include <span>
#include <vector>

namespace afterglow
{
using namespace shared;

using Corners = std::array<dvec3, 3>; // of a triangle

class DistanceTree
{
public:
    explicit DistanceTree(std::vector<Corners> triangles);

    struct Place {
        uint triangle = 0; // as they were given
        dvec3 point{0.0};
        double distance = 0.0;
    };
    Place nearest(const dvec3& point) const;     // on the nearest triangle; there must be one
    double operator()(const dvec3& point) const; // to the nearest triangle; 0 when there is none

    // Calls with each triangle whose box lies no further than `reach` from that of the given one.
    template <typename Visit>
    void near(const Corners& corners, double reach, Visit visit) const
    {
        Box wanted;
        for (const dvec3& p : corners) wanted.add(p);
        wanted.lower -= reach, wanted.upper += reach;
        std::vector<uint> open(1, 0u);
        while (!open.empty()) {
            const Node& node = nodes_[open.back()];
            open.pop_back();
            if (!node.box.meets(wanted)) continue;
            if (node.children != 0) open.insert(open.end(), {node.children + 1, node.children});
            for (uint i = node.begin; i < (node.children == 0 ? node.end : node.begin); ++i) {
                Box box;
                for (const dvec3& p : given_[triangles_[i]]) box.add(p);
                if (box.meets(wanted)) visit(triangles_[i]);
            }
        }
    }

private:
    struct Box {
        dvec3 lower{1e300}, upper{-1e300};
        void add(const dvec3& p) { lower = min(lower, p), upper = max(upper, p); }
        dvec3 nearest(const dvec3& p) const { return clamp(p, lower, upper); }
        bool meets(const Box& b) const { return all(lessThanEqual(lower, b.upper)) && all(lessThanEqual(b.lower, upper)); }
    };
    struct Node {
        Box box;
        uint begin = 0, end = 0; // triangles
        uint children = 0;       // the first of two; 0: a leaf
    };
    void build(uint node);

    std::vector<Corners> given_;
    std::vector<uint> triangles_; // in the order of the leaves
    std::vector<Node> nodes_;
};

// Points of a triangle about `spacing` apart, one or more: the weights of its corners.
std::vector<dvec3> samples(const Corners& triangle, double spacing);

// Of every triangle of a surface.
std::vector<dvec3> samples(const std::vector<Corners>& surface, double spacing);
}
