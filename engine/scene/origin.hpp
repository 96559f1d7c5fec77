// Levels far from their own origin: behind import everything counts from a point near the level, Scene::origin, so that floats keep their
// digits. Files and people speak the level's own coordinates: these functions stand where one becomes the other.
#pragma once
#include "engine/scene/bounds.hpp"

namespace afterglow
{
// From where a level of these bounds counts: 0 for one that lies around its origin or beside it; else the middle of the box in whole
// metres, once it is further out than twice the box's diagonal, where floats would have lost two bits and more.
dvec3 originOf(const Box& box);

inline dmat4 fromLevel(dmat4 toWorld, dvec3 origin)
{
    toWorld[3] -= dvec4(origin, 0.0);
    return toWorld;
}
inline dmat4 toLevel(dmat4 toWorld, dvec3 origin)
{
    toWorld[3] += dvec4(origin, 0.0);
    return toWorld;
}
inline vec3 fromLevel(dvec3 position, dvec3 origin) { return vec3(position - origin); }
inline dvec3 toLevel(vec3 position, dvec3 origin) { return dvec3(position) + origin; }
}
