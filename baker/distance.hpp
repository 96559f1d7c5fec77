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

    double operator()(const dvec3& point) const; // to the nearest triangle; 0 when there is none

private:
    struct Node {
        dvec3 lower{1e300}, upper{-1e300};
        uint begin = 0, end = 0; // triangles
        uint children = 0;       // the first of two; 0: a leaf
    };
    void build(uint node);

    std::vector<Corners> triangles_;
    std::vector<Node> nodes_;
};

// Points of a surface about `spacing` apart, one or more inside each triangle.
std::vector<dvec3> samples(const std::vector<Corners>& surface, double spacing);
}
