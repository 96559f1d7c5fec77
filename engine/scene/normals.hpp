// Normals and tangents where the file has none or broken ones: unit length, perpendicular, never NaN.
#pragma once
#include "shaders/scene.h"
#include <vector>

namespace afterglow
{
using shared::Vertex;

// Makes every normal a unit vector; one that is no direction becomes the mean of its triangles' normals. Returns how many were none.
int completeNormals(std::vector<Vertex>& vertices, const std::vector<shared::uint>& indices);

// Tangents along +u, weighted by the corner's angle as MikkTSpace does; a vertex between mirrored halves of a texture is split.
// Vertices whose texture coordinates have no direction keep a zero tangent for completeTangents().
void computeTangents(std::vector<Vertex>& vertices, std::vector<shared::uint>& indices);

// Makes every tangent a unit vector perpendicular to the normal, any one where it is no direction. Returns how many were none.
int completeTangents(std::vector<Vertex>& vertices);
}
