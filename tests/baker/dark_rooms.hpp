// Small levels in which a closed room without light stands in the open, under a sky of radiance 1: what must stay dark is known everywhere.
#pragma once
#include "dark_room.hpp"

namespace afterglow
{
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
