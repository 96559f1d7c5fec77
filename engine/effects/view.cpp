#include "engine/effects/view.hpp"
#include "engine/core/error.hpp"
#include "shaders/camera.h"

namespace afterglow
{
View makeView(const Camera& camera, uvec2 size)
{
    View view;
    view.size = size;
    const float aspect = camera.aspect > 0.0f ? camera.aspect : float(size.x) / float(size.y);
    const vec3 position(camera.toWorld[3]);
    const vec3 backward = normalize(vec3(camera.toWorld[2]));
    mat4 projection(1.0f);
    if (camera.fovY > 0.0f) {
        if (!validPerspective(camera.fovY, aspect, camera.nearPlane))
            throw Error("camera '" + camera.name + "' has no picture: its field of view, aspect or near plane is out of range");
        projection = perspectiveReversed(camera.fovY, aspect, camera.nearPlane);
        view.eye = vec4(position, 1.0f);
    } else {
        const float far_ = 1e4f; // m; an orthographic depth is linear and needs an end
        if (!validOrthographic(camera.orthoHeight, aspect, camera.nearPlane, far_))
            throw Error("camera '" + camera.name + "' has no picture: its height, aspect or near plane is out of range");
        projection = orthographicReversed(0.5f * camera.orthoHeight * aspect, 0.5f * camera.orthoHeight, camera.nearPlane, far_);
        view.eye = vec4(backward, 0.0f);
    }
    // In double: far from the origin the product of two float inverses would tremble
    const dmat4 worldToClip = dmat4(projection) * inverse(dmat4(camera.toWorld));
    view.worldToClip = mat4(worldToClip);
    view.clipToWorld = mat4(inverse(worldToClip));
    return view;
}

bool mayBeSeen(const mat4& worldToClip, const vec3& lower, const vec3& upper)
{
    int outside[5] = {};
    for (int corner = 0; corner < 8; ++corner) {
        const vec3 p(corner & 1 ? upper.x : lower.x, corner & 2 ? upper.y : lower.y, corner & 4 ? upper.z : lower.z);
        const vec4 c = worldToClip * vec4(p, 1.0f);
        outside[0] += c.x < -c.w;
        outside[1] += c.x > c.w;
        outside[2] += c.y < -c.w;
        outside[3] += c.y > c.w;
        outside[4] += c.z > c.w;
    }
    for (int count : outside)
        if (count == 8) return false;
    return true;
}
}
