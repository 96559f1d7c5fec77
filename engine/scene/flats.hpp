// Flat surfaces in which the level is seen once more: mirrors (ag_mirror, metals of roughness 0) and portals (ag_portal).
// Both are a plane with a way through it: what lies beyond is the world mirrored, or the world before the portal's twin.
#pragma once
#include "engine/scene/scene.hpp"
#include <array>

namespace afterglow
{
enum class FlatKind { mirror, portal };

struct Flat {
    FlatKind kind = FlatKind::mirror;
    std::string name;               // of the first node
    dvec3 normal{0.0};              // unit, on the side from which it is looked at
    double offset = 0.0;            // m: normal . x = offset
    std::array<dvec3, 4> corners{}; // a rectangle of the plane that holds all of it
    std::vector<uint> surfaces;     // indices into instances(scene)
    bool rippled = false;           // a normal map tilts it
    bool twoSided = false;          // of metal: its back mirrors as its front does
    dmat4 through{1.0};        // a point before it -> where a straight way through it leads; affine and rigid, of a mirror a reflection
    double beyondOffset = 0.0; // m: what is seen through it has
    dvec3 beyond{0.0};         // beyond . x >= beyondOffset; unit
};

// Coplanar mirrors are one. A surface that says ag_mirror or ag_portal and is none of these is told in `refused`, with the reason.
struct Flats {
    std::vector<Flat> mirrors, portals;
    std::vector<std::pair<FlatKind, std::string>> refused;
};
Flats findFlats(const Scene& scene);
}
