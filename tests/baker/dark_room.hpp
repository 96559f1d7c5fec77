// Small levels in which a closed room without light stands in the open, under a sky of radiance 1: what must stay dark is known everywhere.
#pragma once
#include "shaders/frame.h"
#include "shapes.hpp"
#include <functional>
#include <string>

namespace afterglow
{
struct DarkRoom {
    std::string name;
    Scene scene;
    std::function<bool(vec3)> dark; // whether a point of the air lies in the closed room
};

const vec3 kRoomLower(-1.03f, -0.9f, -1.1f), kRoomUpper(0.97f, 1.1f, 0.9f); // m; in line with no texel

// A box from corner to corner: what is given twice is the same number twice.
inline Shape brick(vec3 lower, vec3 upper)
{
    Shape shape = box(vec3(2.0f));
    for (vec3& p : shape.positions) p = mix(lower, upper, greaterThan(p, vec3(0.0f)));
    return shape;
}

// The faces of a box but those across an axis, or only those.
inline Shape facesAcross(const Shape& shape, int axis, bool across)
{
    Shape result{shape.positions, {}};
    for (std::size_t i = 0; i < shape.indices.size(); i += 3) {
        const uint* t = &shape.indices[i];
        const vec3 n = cross(shape.positions[t[1]] - shape.positions[t[0]], shape.positions[t[2]] - shape.positions[t[0]]);
        if ((n[axis] != 0.0f) == across) result.indices.insert(result.indices.end(), t, t + 3);
    }
    return result;
}

// A ring, counterclockwise in x and y, drawn out along z.
inline Shape prism(const std::vector<vec2>& ring, float back, float front)
{
    Shape shape;
    const uint n = uint(ring.size());
    for (uint i = 0; i < n; i++) {
        const vec2 a = ring[i], b = ring[(i + 1) % n];
        append(shape, {{vec3(a, front), vec3(a, back), vec3(b, back), vec3(b, front)}, {0, 1, 2, 0, 2, 3}});
    }
    for (uint end = 0; end < 2; end++) {
        Shape cap;
        for (const vec2& p : ring) cap.positions.push_back(vec3(p, end == 0 ? front : back));
        for (uint i = 1; i + 1 < n; i++) cap.indices.insert(cap.indices.end(), {0, i, i + 1});
        append(shape, end == 0 ? cap : flipped(cap));
    }
    return shape;
}

inline bool within(vec3 p, vec3 lower, vec3 upper) { return all(greaterThan(p, lower)) && all(lessThan(p, upper)); }

inline DarkRoom darkRoom(const std::string& name)
{
    DarkRoom room{name, {}, [](vec3 p) { return within(p, kRoomLower, kRoomUpper); }};
    room.scene.sky.radiance = vec3(1.0f);
    return room;
}

// Its interior is a ring drawn out along z from -1 to 1.
inline DarkRoom darkPrism(const std::string& name, const std::vector<vec2>& ring)
{
    DarkRoom room = darkRoom(name);
    room.dark = [ring](vec3 p) {
        for (std::size_t i = 0; i < ring.size(); i++) {
            const vec2 along = ring[(i + 1) % ring.size()] - ring[i], to = vec2(p) - ring[i];
            if (along.x * to.y <= along.y * to.x) return false;
        }
        return abs(p.z) < 1.0f;
    };
    return room;
}

// Normals as if the mesh were round: one for each point, across its hard edges too.
inline void makeRound(Scene& scene, uint mesh)
{
    const Primitive& p = scene.meshes[mesh].primitives[0];
    Vertex* v = &scene.vertices[p.firstVertex];
    std::vector<vec3> sums(p.vertexCount, vec3(0.0f));
    for (uint i = 0; i < p.vertexCount; i++)
        for (uint j = 0; j < p.vertexCount; j++)
            if (v[i].position == v[j].position && dot(v[i].normal, v[j].normal) > -0.5f) sums[i] += v[j].normal;
    for (uint i = 0; i < p.vertexCount; i++) v[i].normal = safeNormalize(sums[i], v[i].normal);
}

// Inner and outer faces of walls of a thickness in m; 0: the inner faces alone.
inline Shape shell(float thickness)
{
    Shape shape = flipped(brick(kRoomLower, kRoomUpper));
    if (thickness > 0.0f) append(shape, brick(kRoomLower - thickness, kRoomUpper + thickness));
    return shape;
}

// Six bodies about the room, `thickness` m deep, that reach along the other axes by `reach` m beyond it; those across y by reach.y, and so
// on. They begin `into` m inside.
inline void addSlabs(Scene& scene, float thickness, vec3 reach, float into = 0.0f)
{
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++) {
            vec3 lower = kRoomLower - reach[axis], upper = kRoomUpper + reach[axis];
            lower[axis] = side == 0 ? kRoomLower[axis] - thickness : kRoomUpper[axis] - into;
            upper[axis] = side == 0 ? kRoomLower[axis] + into : kRoomUpper[axis] + thickness;
            add(scene, brick(lower, upper), matte(0.5f));
        }
}

// Floor slab, walls on it, and a ceiling over them: floor and ceiling reach beyond the walls by `eaves`.
inline DarkRoom houseOn(const std::string& name, float wall, float floorReach, float eaves)
{
    DarkRoom room = darkRoom(name);
    const vec3 out(wall, 0.0f, wall), reach(floorReach, 0.0f, floorReach), eave(eaves, 0.0f, eaves), deep(0.0f, 0.2f, 0.0f);
    const auto withY = [](vec3 p, float y) { return vec3(p.x, y, p.z); };
    add(room.scene, brick(kRoomLower - reach - deep, withY(kRoomUpper + reach, kRoomLower.y)), matte(0.5f));
    add(room.scene, brick(withY(kRoomLower - eave, kRoomUpper.y), kRoomUpper + eave + deep), matte(0.5f));
    for (int side = 0; side < 2; side++) {
        const vec3 a = kRoomLower - out, b = kRoomUpper + out;
        add(room.scene, side == 0 ? brick(a, vec3(kRoomLower.x, kRoomUpper.y, b.z)) : brick(vec3(kRoomUpper.x, a.y, a.z), b), matte(0.5f));
        add(room.scene,
            side == 0 ? brick(vec3(kRoomLower.x, a.y, a.z), vec3(kRoomUpper.x, b.y, kRoomLower.z))
                      : brick(vec3(kRoomLower.x, a.y, kRoomUpper.z), vec3(kRoomUpper.x, b.y, b.z)),
            matte(0.5f));
    }
    return room;
}

// A body in a room, or through its walls: its inside is not the room's air.
inline void furnish(DarkRoom& room, vec3 lower, vec3 upper)
{
    add(room.scene, brick(lower, upper), matte(0.5f));
    room.dark = [air = room.dark, lower, upper](vec3 p) { return air(p) && !within(p, lower, upper); };
}

inline Material doubleSided(Material material)
{
    material.flags |= kMaterialDoubleSided;
    return material;
}
}
