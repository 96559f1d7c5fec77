// Which objects are solids: bodies whose inside no light reaches. A point that sees their backs all around lies in the dark for good, where
// the backs of an open sheet, or of a room whose faces all look outwards, say nothing of the kind.
#pragma once
#include "baker/tracer.hpp"
#include <span>

namespace afterglow
{
struct SurfacePlace {
    vec3 position, normal;
};

enum class Stand {
    open,
    inside, // a solid of two-sided triangles: whoever is in it sees its walls
    unseen  // a solid whose walls are not drawn from inside
};

// Found by following paths from every kind of light there is: an object is a solid unless more than a hundredth of those that meet it meet
// its back. The same for the same level, whatever the seed or the thread count of a bake.
class Solids
{
public:
    explicit Solids(const LightTransport& transport);

    // The ray met a solid's back: it started inside.
    bool meetsInside(const Ray& ray, const Hit& hit) const;

    // Of what is seen from a point of space, the share that is a solid's back. Nobody outside sees one. Whoever sees a quarter lies in one: what is
    // sunk into a solid hides a part of its walls, and shows its own front.
    double shareInside(vec3 position) const;
    bool hold(vec3 position) const { return shareInside(position) >= 0.25; }

    // Where rays that leave points of a surface begin; points that lie close together are asked together. Glass, water and cut-outs are no
    // solids.
    std::vector<Stand> standsOf(std::span<const SurfacePlace> points) const;

    const std::vector<bool>& byObject() const { return solid_; }

private:
    const World& world_;
    std::vector<bool> solid_; // by object
};
}
