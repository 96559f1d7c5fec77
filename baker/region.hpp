// A convex piece of space, as the polygons that bound it.
#pragma once
#include "engine/scene/scene.hpp"
#include <vector>

namespace afterglow
{
using Polygon = std::vector<dvec3>;

struct Region {
    struct Face {
        dvec3 normal;  // outwards, unit length
        double offset; // m: the region lies where dot(normal, x) <= offset
        bool wall;     // something is there
        Polygon corners;
    };
    std::vector<Face> faces; // none: the region is empty

    bool empty() const { return faces.empty(); }
    dvec3 lower() const;
    dvec3 upper() const;
    dvec3 middle() const { return 0.5 * (lower() + upper()); } // of its bounds
    double volume() const;
    bool holds(dvec3 position) const;
};

Region boxRegion(dvec3 lower, dvec3 upper);

// The part with dot(normal, x) <= offset. Pieces thinner than `thin` m are empty.
Region clipped(const Region& region, dvec3 normal, double offset, bool wall, double thin);

// The polygon in which a plane cuts a region.
Polygon sectionOf(const Region& region, dvec3 normal, double offset);

// The part of a polygon with dot(normal, x) <= offset.
Polygon clipped(const Polygon& polygon, dvec3 normal, double offset);

// The part of a polygon that lies within a region, further than `margin` m from its faces.
Polygon within(const Region& region, Polygon polygon, double margin);

double area(const Polygon& polygon);
}
