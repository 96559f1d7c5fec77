// What a level may not hold, found at import and counted in Scene::dropped by a name that a person understands: H01, H12 to H14, H36, H49
// of the hard cases. Behind import, no triangle is degenerate, no number is NaN, infinite or denormal, no albedo makes energy.
#pragma once
#include "engine/scene/scene.hpp"
#include <map>
#include <string>
#include <vector>

namespace afterglow
{
using Dropped = std::map<std::string, int>;

constexpr float kLargestCoordinate = 1e18f; // m: a squared distance stays a finite float

// The number itself when it is finite and within the bounds, else the nearest bound (NaN: the lower), counted under `key`. Denormals are 0.
float clamped(double value, float lower, float upper, Dropped& dropped, const char* key);
vec3 clamped(dvec3 value, float lower, float upper, Dropped& dropped, const char* key);

// Flat within the precision of its coordinates: two corners equal, or all three on a line. No triangle that is one float step high is.
bool degenerate(vec3 a, vec3 b, vec3 c);

// Flushes denormal coordinates, then removes the triangles (three corners each) with a corner that is not finite or beyond
// kLargestCoordinate, and the degenerate ones.
void dropBadTriangles(std::vector<vec3>& positions, std::vector<uint>& corners, Dropped& dropped);

// Replaces texels that are no radiance: NaN and negative ones by 0, infinite ones by the largest half, those beyond what a uniform sky may
// have by that. Neighbours are left alone.
constexpr float kLargestRadiance = 1e18f; // its square is a float
void repairRadiance(Image& image, Dropped& dropped);
}
