// Into which pieces others part the smooth surfaces of a mesh: where a floor goes through under walls, the floor of the dark room is one,
// and what lies outside in the sun another. Each piece gets texels of its own.
#pragma once
#include "baker/cuts.hpp"
#include <functional>

namespace afterglow
{
struct PiecedMesh {
    CutMesh mesh;
    std::vector<uint> piece; // of each triangle; 0: what nothing parts. Neighbours of different pieces share no chart
    bool parted = false;
};

struct SurfaceLight {
    double light = 0.0; // mean over a surface, in one unit for all
    bool roomy = false; // it is no crack in which a texel has no place
};
// On the surface of these triangles; none when it sees nothing but the inside of solids. Called from any thread.
using LightOn = std::function<std::optional<SurfaceLight>(const CutMesh& mesh, const std::vector<uint>& triangles)>;

// Cuts where one smooth surface is lit on one side of `lines` and next to dark on the other, and nowhere else: not about a chest on a
// floor, whose inside nobody sees, nor about a pen on a table.
PiecedMesh piecesOf(std::span<const Corners> triangles, std::span<const Lines> lines, double same, const LightOn& lightOn, int threads);
}
