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

// Six bodies about the room, `thickness` m deep, that reach along the other axes by `reach` m beyond it; those across y by reach.y, and so on.
// They begin `into` m inside.
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

inline std::vector<DarkRoom> darkRooms()
{
    std::vector<DarkRoom> rooms;
    const auto begin = [&](const std::string& name) -> DarkRoom& { return rooms.emplace_back(darkRoom(name)); };
    const auto put = [](DarkRoom& room, const Shape& shape) { add(room.scene, shape, matte(0.5f)); };

    put(begin("one-sided sheet"), shell(0.0f));
    add(begin("double-sided sheet, front inwards").scene, shell(0.0f), doubleSided(matte(0.5f)));
    {
        DarkRoom& room = begin("double-sided sheet, front outwards, and a block");
        add(room.scene, brick(kRoomLower, kRoomUpper), doubleSided(matte(0.5f)));
        furnish(room, vec3(-0.4f, -0.9f, -0.3f), vec3(0.3f, 0.2f, 0.4f));
        put(room, plate(vec3(0.0f, -0.899f, 0.0f), 0.85f));
    }
    put(begin("walls of 1 cm"), shell(0.01f));
    put(begin("walls of 5 cm"), shell(0.05f));
    put(begin("walls of 10 cm"), shell(0.1f));
    rooms.push_back(houseOn("slabs of 5 cm that touch", 0.05f, 0.05f, 0.05f));
    rooms.push_back(houseOn("slabs of 1 cm that touch", 0.01f, 0.01f, 0.01f));
    addSlabs(begin("slabs that overlap").scene, 0.1f, vec3(0.1f, 0.1f, 0.03f));
    addSlabs(begin("slabs that overlap, corner in corner").scene, 0.1f, vec3(0.1f));
    addSlabs(begin("slabs that overlap in part").scene, 0.1f, vec3(0.05f));
    addSlabs(begin("slabs that overlap in part, thin").scene, 0.02f, vec3(0.01f));
    addSlabs(begin("slabs that touch only by an edge").scene, 0.05f, vec3(0.0f));
    {
        DarkRoom& room = begin("slabs that interpenetrate");
        addSlabs(room.scene, 0.1f, vec3(0.1f), 0.03f);
        room.dark = [](vec3 p) { return within(p, kRoomLower + 0.03f, kRoomUpper - 0.03f); };
    }
    {
        DarkRoom& room = begin("one-sided plates of their own");
        for (int axis = 0; axis < 3; axis++)
            for (float side : {-1.0f, 1.0f}) {
                const Shape faces = facesAcross(shell(0.0f), axis, true);
                Shape one{faces.positions, {}};
                for (std::size_t i = 0; i < faces.indices.size(); i += 3)
                    if ((faces.positions[faces.indices[i]][axis] > 0.0f) == (side > 0.0f))
                        one.indices.insert(one.indices.end(), faces.indices.begin() + std::ptrdiff_t(i),
                                           faces.indices.begin() + std::ptrdiff_t(i) + 3);
                put(room, one);
            }
    }
    for (float degrees : {60.0f, 30.0f, 10.0f}) {
        const float a = degrees * kPi / 180.0f;
        const std::vector<vec2> ring = {vec2(-0.7f, -0.6f), vec2(1.3f, -0.6f), vec2(-0.7f, -0.6f) + 2.0f * vec2(std::cos(a), std::sin(a))};
        DarkRoom& room = rooms.emplace_back(darkPrism("corner of " + std::to_string(int(degrees)) + " degrees", ring));
        put(room, flipped(prism(ring, -1.0f, 1.0f)));
    }
    {
        const std::vector<vec2> ring = {vec2(-0.7f, -0.6f), vec2(1.3f, -0.6f), vec2(0.3f, 0.3f)};
        DarkRoom& room = rooms.emplace_back(darkPrism("tent with walls of 5 cm", ring));
        put(room, flipped(prism(ring, -1.0f, 1.0f)));
        put(room, prism({vec2(-0.86f, -0.65f), vec2(1.46f, -0.65f), vec2(0.3f, 0.38f)}, -1.05f, 1.05f));
    }
    {
        DarkRoom& room = begin("normals that are round across hard edges");
        put(room, shell(0.0f));
        makeRound(room.scene, 0);
    }
    {
        DarkRoom& room = begin("round normals, walls of 5 cm");
        put(room, shell(0.05f));
        makeRound(room.scene, 0);
    }
    {
        DarkRoom& room = begin("rug, and furniture sunk into walls and floor");
        put(room, shell(0.1f));
        furnish(room, vec3(-0.6f, -0.9f, -0.5f), vec3(0.4f, -0.895f, 0.3f));
        furnish(room, vec3(-1.08f, -0.95f, -0.9f), vec3(-0.6f, 0.3f, -0.2f));
        furnish(room, vec3(0.5f, -0.93f, 0.4f), vec3(1.05f, -0.2f, 0.98f));
    }
    {
        DarkRoom& room = begin("pillar through floor and ceiling");
        put(room, shell(0.1f));
        furnish(room, vec3(-0.2f, -0.95f, -0.2f), vec3(0.13f, 1.15f, 0.13f));
    }
    {
        DarkRoom& room = begin("stairs");
        put(room, shell(0.05f));
        for (int i = 0; i < 4; i++)
            furnish(room, vec3(-0.5f + 0.3f * float(i), -0.9f, -0.4f), vec3(-0.2f + 0.3f * float(i), -0.7f + 0.2f * float(i), 0.4f));
    }
    {
        DarkRoom& room = begin("box within a box");
        put(room, shell(0.02f));
        put(room, brick(kRoomLower - 1.0f, kRoomUpper + 1.0f));
        add(room.scene, flipped(brick(kRoomLower - 0.95f, kRoomUpper + 0.95f)), matte(0.5f));
        add(room.scene, brick(vec3(1.5f, 0.0f, 0.0f), vec3(1.7f, 0.3f, 0.3f)), matte(0.0f));
        room.scene.materials.back().emission = vec3(100.0f);
    }
    {
        DarkRoom& room = begin("beside a bright room, one mesh");
        const vec3 lower(1.02f, -0.9f, -1.1f), upper(3.02f, 1.1f, 0.9f);
        Shape both = shell(0.0f);
        append(both, flipped(brick(lower, upper)));
        append(both, brick(kRoomLower - 0.05f, upper + 0.05f));
        put(room, both);
        add(room.scene, plate(vec3(2.0f, 1.0f, 0.0f), 0.3f, false), matte(0.0f));
        room.scene.materials.back().emission = vec3(50.0f);
    }
    {
        DarkRoom& room = begin("one wall, placed six times");
        const uint mesh = 0;
        add(room.scene, brick(vec3(-1.0f, -1.0f, 1.0f), vec3(1.0f, 1.0f, 1.05f)), matte(0.5f));
        room.scene.objects.clear();
        for (int axis = 0; axis < 3; axis++)
            for (double side : {-1.0, 1.0}) {
                dmat4 turn(0.0);
                turn[0][(axis + 1) % 3] = 1.0;
                turn[1][(axis + 2) % 3] = turn[2][axis] = side;
                turn[3] = dvec4(0.0, 0.0, 0.0, 1.0);
                addObject(room.scene, mesh, turn);
            }
        room.dark = [](vec3 p) { return within(p, vec3(-1.0f), vec3(1.0f)); };
    }
    {
        DarkRoom& room = begin("a half and its mirror image, of bodies that interpenetrate");
        Shape half, image;
        append(half, brick(vec3(-1.1f, -1.1f, -1.1f), vec3(0.0f, -1.0f, 1.1f)));
        append(half, brick(vec3(-1.1f, 1.0f, -1.1f), vec3(0.0f, 1.1f, 1.1f)));
        append(half, brick(vec3(-1.1f, -1.05f, -1.1f), vec3(0.0f, 1.05f, -1.0f)));
        append(half, brick(vec3(-1.1f, -1.05f, 1.0f), vec3(0.0f, 1.05f, 1.1f)));
        append(half, brick(vec3(-1.1f, -1.05f, -1.05f), vec3(-1.0f, 1.05f, 1.05f)));
        image = flipped(half);
        for (vec3& p : image.positions) p.x = -p.x;
        put(room, half);
        put(room, image);
        room.dark = [](vec3 p) { return within(p, vec3(-1.0f), vec3(1.0f)); };
    }
    {
        DarkRoom& room = begin("uneven scale");
        Shape unit = flipped(brick(vec3(-1.0f), vec3(1.0f)));
        append(unit, brick(vec3(-1.05f), vec3(1.05f)));
        put(room, unit);
        dmat4& place = room.scene.objects[0].toWorld;
        place[0][0] = 0.4, place[1][1] = 2.0, place[2][2] = 1.3;
        room.dark = [](vec3 p) { return within(p, vec3(-0.4f, -2.0f, -1.3f), vec3(0.4f, 2.0f, 1.3f)); };
    }
    {
        DarkRoom& room = begin("far from the origin");
        put(room, moved(shell(0.05f), vec3(300.0f, 20.0f, -500.0f)));
        room.dark = [](vec3 p) { return within(p - vec3(300.0f, 20.0f, -500.0f), kRoomLower, kRoomUpper); };
    }
    { // where the step that takes a ray off its surface is 8 mm
        const vec3 far(300.0f, 20.0f, -500.0f);
        const std::vector<vec2> ring = {vec2(-0.7f, -0.6f), vec2(1.3f, -0.6f), vec2(0.8f, 0.3f)};
        DarkRoom& room = rooms.emplace_back(darkPrism("tent far from the origin", ring));
        put(room, moved(flipped(prism(ring, -1.0f, 1.0f)), far));
        room.dark = [near = room.dark, far](vec3 p) { return near(p - far); };
    }
    rooms.push_back(houseOn("floor that runs through under walls of 60 cm", 0.6f, 1.0f, 0.6f));
    {
        DarkRoom& room = begin("floors that meet under a wall without thickness");
        put(room, shell(0.0f));
        for (const auto& [left, right] : {std::pair(kRoomLower.x - 2.0f, kRoomLower.x), {kRoomUpper.x, kRoomUpper.x + 2.0f}})
            put(room, facesAcross(flipped(brick(vec3(left, kRoomLower.y, kRoomLower.z), vec3(right, kRoomUpper.y + 1.0f, kRoomUpper.z))), 1,
                                  true));
    }
    rooms.push_back(houseOn("floor that runs through under walls of 10 cm", 0.1f, 1.0f, 0.1f));
    rooms.push_back(houseOn("floor that runs through under walls of 1 cm", 0.01f, 1.0f, 0.01f));
    rooms.push_back(houseOn("overhang of the roof", 0.1f, 0.1f, 0.7f));
    addSlabs(begin("slabs whose upright edges alone touch").scene, 0.05f, vec3(0.0f, 0.05f, 0.0f));
    {
        DarkRoom& room = begin("one-sided walls on a floor that runs through");
        put(room, facesAcross(shell(0.0f), 1, false));
        put(room, plate(vec3(0.0f, kRoomLower.y, 0.0f), 2.0f));
        put(room, plate(vec3(0.0f, kRoomUpper.y, 0.0f), 1.2f, false));
    }
    {
        DarkRoom& room = begin("beam through a wall");
        put(room, shell(0.05f));
        furnish(room, vec3(0.2f, 0.3f, -0.2f), vec3(1.7f, 0.5f, 0.0f));
    }
    for (DarkRoom& room : rooms) {
        const auto measure = [&](vec3& lower, vec3& upper) {
            lower = vec3(kFloatMax), upper = vec3(-kFloatMax);
            for (const Object& object : room.scene.objects)
                for (const Primitive& p : room.scene.meshes[object.mesh].primitives)
                    for (uint v = 0; v < p.vertexCount; v++) {
                        const vec3 at(object.toWorld * dvec4(dvec3(room.scene.vertices[p.firstVertex + v].position), 1.0));
                        lower = min(lower, at), upper = max(upper, at);
                    }
        };
        vec3 lower, upper;
        measure(lower, upper);
        put(room, plate(upper + vec3(2.0f, 0.0f, 0.0f), 0.5f)); // bright, whatever the room shows
        measure(room.scene.lower, room.scene.upper);
    }
    return rooms;
}
}
