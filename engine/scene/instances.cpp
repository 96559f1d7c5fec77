#include "engine/scene/scene.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
// The cofactors of the linear part: its inverse transpose times its determinant, which is positive (no object mirrors), so the direction is
// the same and nothing is divided. Scaled to a largest entry of 1, so that it neither underflows nor overflows as float.
mat3 normalMatrix(const dmat3& m)
{
    const dmat3 cofactors(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(cofactors[column][row]));
    return mat3(cofactors * (1.0 / largest));
}
}

std::vector<Instance> instances(const Scene& scene)
{
    std::vector<Instance> all;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        for (const Primitive& primitive : scene.meshes[object.mesh].primitives) {
            Instance instance{};
            instance.toWorld = mat4x3(object.toWorld);
            instance.normalToWorld = normalMatrix(dmat3(object.toWorld));
            instance.firstIndex = primitive.firstIndex;
            instance.indexCount = primitive.indexCount;
            instance.firstVertex = primitive.firstVertex;
            instance.material = primitive.material;
            instance.flags = (object.isStatic ? kInstanceStatic : 0) | (object.mirror ? kInstanceMirror : 0);
            instance.object = uint(i);
            instance.lightmap = -1;
            all.push_back(instance);
        }
    }
    return all;
}
}
