// Which camera a picture is taken with, one of the file or one that sees the whole level, and what it projects.
#include "shaders/camera.h"
#include "engine/core/error.hpp"
#include "engine/scene/fields.hpp"
#include "engine/scene/lens.hpp"
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
constexpr const char* kNoPicture = "cameras that make no picture";

// Orthonormal axes that look along the matrix's -z with its y as up as may be; nothing when it has no such directions.
std::optional<mat4> rigid(const dmat4& m)
{
    const dvec3 back(m[2]), side = cross(dvec3(m[1]), back);
    if (!(length(back) > 0.0) || !(length(side) > 1e-9 * length(back) * length(dvec3(m[1])))) return std::nullopt;
    const dvec3 z = normalize(back), x = normalize(side), y = cross(z, x);
    return mat4(vec4(vec3(x), 0), vec4(vec3(y), 0), vec4(vec3(z), 0), vec4(vec3(m[3]), 1));
}

// From a corner, slightly above, far enough that the sphere around the level fits into the picture.
Camera overview(const Scene& scene)
{
    const vec3 centre = 0.5f * (scene.lower + scene.upper);
    const float radius = std::max(0.5f * length(scene.upper - scene.lower), 1e-6f); // m
    const vec3 from = normalize(vec3(0.6f, 0.45f, 1.0f));
    Camera camera;
    camera.name = "overview";
    const float distance = 1.1f * radius / std::sin(0.5f * camera.fovY);
    const dvec3 x = normalize(cross(dvec3(0, 1, 0), dvec3(from))), y = cross(dvec3(from), x);
    camera.toWorld = mat4(vec4(vec3(x), 0), vec4(vec3(y), 0), vec4(from, 0), vec4(centre + from * distance, 1));
    camera.nearPlane = 0.01f * distance;
    return camera;
}
}

std::optional<Camera> readCamera(const nlohmann::json& source, const dmat4& toWorld, Dropped& dropped)
{
    Camera camera;
    const auto placed = rigid(toWorld);
    bool valid = placed.has_value();
    camera.toWorld = placed.value_or(mat4(1.0f));
    if (text(source, "type") == "orthographic") {
        const nlohmann::json& lens = member(source, "orthographic");
        camera.fovY = 0.0f;
        camera.orthoHeight = float(2.0 * number(lens, "ymag", 0.0));
        camera.nearPlane = float(number(lens, "znear", 0.0));
        valid = valid && validOrthographic(camera.orthoHeight, 1.0f, camera.nearPlane, float(number(lens, "zfar", 0.0)));
    } else {
        const nlohmann::json& lens = member(source, "perspective");
        camera.fovY = float(number(lens, "yfov", 0.0));
        camera.nearPlane = float(number(lens, "znear", 0.0));
        valid = valid && validPerspective(camera.fovY, 1.0f, camera.nearPlane);
    }
    if (valid) return camera;
    ++dropped[kNoPicture];
    return std::nullopt;
}

Camera findCamera(const Scene& scene, const std::string& nameOrIndex)
{
    if (nameOrIndex.empty()) return scene.cameras.empty() ? overview(scene) : scene.cameras.front();
    for (const Camera& camera : scene.cameras)
        if (camera.name == nameOrIndex) return camera;
    std::size_t index = 0;
    const char* end = nameOrIndex.data() + nameOrIndex.size();
    const auto [stopped, problem] = std::from_chars(nameOrIndex.data(), end, index);
    if (problem == std::errc() && stopped == end && index < scene.cameras.size()) return scene.cameras[index];

    std::string names;
    for (const Camera& camera : scene.cameras) names += (names.empty() ? "" : ", ") + camera.name;
    const bool leftOut = scene.dropped.contains(kNoPicture);
    throw Error(scene.path.filename().string() + " has no camera \"" + nameOrIndex + "\"; it has " + (names.empty() ? "none" : names) +
                (leftOut ? ", and " + std::to_string(scene.dropped.at(kNoPicture)) +
                               " left out for a field of view, near plane or scale that makes no picture"
                         : ""));
}

mat4 projection(const Camera& camera, uvec2 picture)
{
    const float aspect = float(picture.x) / float(picture.y);
    if (camera.fovY > 0.0f) {
        if (!validPerspective(camera.fovY, aspect, camera.nearPlane))
            throw Error("camera '" + camera.name + "' has no picture: its field of view or near plane is out of range");
        return perspectiveReversed(camera.fovY, aspect, camera.nearPlane);
    }
    const float far_ = 1e4f; // m; an orthographic depth is linear and needs an end
    if (!validOrthographic(camera.orthoHeight, aspect, camera.nearPlane, far_))
        throw Error("camera '" + camera.name + "' has no picture: its height or near plane is out of range");
    return orthographicReversed(0.5f * camera.orthoHeight * aspect, 0.5f * camera.orthoHeight, camera.nearPlane, far_);
}
}
