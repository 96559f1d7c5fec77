// A bake's irradiance probes in free space, against the light there: at points that nobody chose, and in a slice through the level.
#pragma once
#include "engine/app/study/study.hpp"

namespace afterglow
{
std::vector<Sweep> probeSweeps();

// All points of such a sweep, with pictures of the slice; `advance` hears of each.
Curve spaceCurve(Studio& studio, const Sweep& sweep, const Advance& advance);
}
