// Shapes whose edges and faces are known, as meshes of a toy level.
#pragma once
#include "tests/engine/upload/toy_level.hpp"
#include <array>
#include <cmath>

namespace afterglow
{
using Triangles = std::vector<std::array<uint, 3>>;

enum class Normals { smooth, ofFaces }; // ofFaces: every face has vertices of its own

// Positions about the origin; a smooth normal is the direction from there.
inline Object& addSolid(Scene& scene, const std::vector<vec3>& positions, const Triangles& faces, uint material,
                        Normals normals = Normals::smooth)
{
    Primitive primitive{uint(scene.vertices.size()), 0, uint(scene.indices.size()), uint(3 * faces.size()), material};
    const auto add = [&](vec3 position, vec3 normal) {
        const vec3 tangent = normalize(cross(std::abs(normal.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0), normal));
        scene.vertices.push_back({position, normal, vec4(tangent, 1.0f), vec2(0), vec2(0), 0xffffffffu});
    };
    if (normals == Normals::smooth)
        for (const vec3& p : positions) add(p, normalize(p));
    for (const auto& face : faces) {
        const vec3 normal = normalize(cross(positions[face[1]] - positions[face[0]], positions[face[2]] - positions[face[0]]));
        for (const uint corner : face) {
            scene.indices.push_back(normals == Normals::smooth ? corner : uint(scene.vertices.size()) - primitive.firstVertex);
            if (normals == Normals::ofFaces) add(positions[corner], normal);
        }
    }
    primitive.vertexCount = uint(scene.vertices.size()) - primitive.firstVertex;
    scene.meshes.push_back({"solid", {primitive}});
    Object object;
    object.name = "solid " + std::to_string(scene.objects.size());
    object.mesh = uint(scene.meshes.size() - 1);
    scene.objects.push_back(object);
    return scene.objects.back();
}

inline Object& addTetrahedron(Scene& scene, uint material)
{
    return addSolid(scene, {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, material);
}

inline Object& addOctahedron(Scene& scene, uint material)
{
    Triangles faces;
    for (const uint x : {0u, 1u})
        for (const uint y : {2u, 3u})
            for (const uint z : {4u, 5u}) // an even number of negative axes keeps the winding
                faces.push_back((x + y + z) % 2 == 0 ? std::array{x, y, z} : std::array{y, x, z});
    return addSolid(scene, {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}, faces, material);
}

// Two units wide. `ofFaces`: 36 vertices at 8 places.
inline Object& addCube(Scene& scene, uint material, Normals normals = Normals::ofFaces)
{
    std::vector<vec3> corners;
    for (uint i = 0; i < 8; ++i) corners.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    return addSolid(scene, corners,
                    {{4, 5, 7},
                     {4, 7, 6},
                     {1, 0, 2},
                     {1, 2, 3},
                     {5, 1, 3},
                     {5, 3, 7},
                     {0, 4, 6},
                     {0, 6, 2},
                     {6, 7, 3},
                     {6, 3, 2},
                     {0, 1, 5},
                     {0, 5, 4}},
                    material, normals);
}

inline Object& addIcosahedron(Scene& scene, uint material)
{
    const float g = 0.5f * (1.0f + std::sqrt(5.0f));
    std::vector<vec3> p = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                           {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    return addSolid(scene, p,
                    {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                     {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}},
                    material);
}

// Of radius 1: rings of quads, with a seam of uv down one side (its vertices stand twice at one place) and smooth normals.
inline Object& addSphere(Scene& scene, uint material, uint around = 48)
{
    const uint down = around / 2;
    std::vector<vec3> positions;
    for (uint row = 0; row <= down; ++row)
        for (uint column = 0; column <= around; ++column) {
            const float polar = kPi * float(row) / float(down), azimuth = kTwoPi * float(column % around) / float(around);
            const float ring = row == 0 || row == down ? 0.0f : std::sin(polar);
            positions.emplace_back(ring * std::sin(azimuth), std::cos(polar), ring * std::cos(azimuth));
        }
    Triangles faces;
    for (uint row = 0; row < down; ++row)
        for (uint column = 0; column < around; ++column) {
            const uint a = row * (around + 1) + column, b = a + around + 1;
            if (row > 0) faces.push_back({a, b, a + 1});
            if (row + 1 < down) faces.push_back({a + 1, b, b + 1});
        }
    return addSolid(scene, positions, faces, material);
}
}
