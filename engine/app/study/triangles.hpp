// What a triangle more costs a ray, and what a raster: time against the number of triangles, of a level made for it (clutter.hpp). Rays are
// incoherent: from a random point of the surfaces, cosine-distributed.
#pragma once
#include "engine/app/study/study.hpp"

namespace afterglow
{
// The sweeps of the subject `triangles`.
std::vector<Sweep> triangleSweeps();

// All points of one of them. `gpu`: null where there is no device, for those by the CPU alone.
Curve timedCurve(Gpu* gpu, const Sweep& sweep, const Advance& advance);
}
