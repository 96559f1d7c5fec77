#include "baker/area.hpp"
#include "engine/core/error.hpp"
#include "shaders/sampling.h"
#include <algorithm>

namespace afterglow
{
Area::Area(const World& world, std::span<const float> densities) : world_(world)
{
    double sum = 0.0;
    for (uint t = 0; t < uint(world.triangles().size()); ++t) {
        const double density = densities.empty() ? 1.0 : double(densities[world.triangles()[t].material]);
        upTo_.push_back(sum += 0.5 * double(length(world.front(t))) * density);
    }
}

AreaPoint Area::point(Sampler& random) const
{
    check(whole() > 0.0, "there is an area to lie on");
    const double target = double(next1(random)) * whole();
    const std::size_t found = std::size_t(std::upper_bound(upTo_.begin(), upTo_.end(), target) - upTo_.begin());
    AreaPoint point{uint(std::min(found, upTo_.size() - 1)), sampleTriangle(next2(random)), vec3(0.0f)};
    for (int c = 0; c < 3; ++c)
        point.position += point.corners[c] * world_.vertices()[world_.triangles()[point.triangle].vertex[c]].position;
    return point;
}
}
