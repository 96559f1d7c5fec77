#include "engine/scene/placement.hpp"
#include "engine/scene/accessor.hpp"
#include "engine/scene/fields.hpp"
#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

dmat4 compose(dvec3 translation, dvec4 rotation, dvec3 scale) // rotation: quaternion x, y, z, w
{
    const double size = length(rotation);
    const dquat turn = size > 0.0 ? dquat(rotation.w / size, rotation.x / size, rotation.y / size, rotation.z / size) : dquat(1, 0, 0, 0);
    dmat4 m = mat4_cast(turn);
    for (int axis = 0; axis < 3; ++axis) m[axis] *= scale[axis];
    m[3] = dvec4(translation, 1.0);
    return m;
}
}

dmat4 localTransform(const json& node)
{
    const json& matrix = member(node, "matrix");
    if (matrix.is_null())
        return compose(triple(node, "translation", dvec3(0.0)), quadruple(node, "rotation", dvec4(0, 0, 0, 1)),
                       triple(node, "scale", dvec3(1.0)));
    if (!matrix.is_array() || matrix.size() != 16) throw Malformed("a node's matrix is not 16 numbers");
    dmat4 m;
    for (int i = 0; i < 16; ++i) {
        if (!matrix[i].is_number()) throw Malformed("a node's matrix is not 16 numbers");
        m[i / 4][i % 4] = matrix[i].get<double>();
    }
    for (int axis = 0; axis < 4; ++axis) m[axis][3] = axis == 3 ? 1.0 : 0.0; // affine
    return m;
}

std::vector<dmat4> copies(const Document& document, const json& node, std::size_t most)
{
    const json& attributes = member(extension(node, "EXT_mesh_gpu_instancing"), "attributes");
    if (attributes.is_null()) return {dmat4(1.0)};
    const json& accessors = listOf(*document.json, "accessors");
    std::size_t count = 0;
    for (const char* key : {"TRANSLATION", "ROTATION", "SCALE"})
        if (const auto accessor = index(attributes, key, accessors.size())) count = size(accessors[*accessor], "count", 0);
    if (count > most) throw Malformed("a node places " + std::to_string(count) + " copies, and " + std::to_string(most) + " is the most");

    const auto read = [&](const char* key, int components) {
        const auto accessor = index(attributes, key, accessors.size());
        Numbers numbers = accessor ? readNumbers(document, *accessor) : Numbers{};
        if (accessor && (numbers.components != components || numbers.count != count))
            throw Malformed(std::string("the copies' ") + key + " does not fit the others");
        return numbers;
    };
    const Numbers translation = read("TRANSLATION", 3), rotation = read("ROTATION", 4), scale = read("SCALE", 3);
    const auto at = [](const Numbers& numbers, std::size_t i, dvec4 fallback) {
        for (int c = 0; c < numbers.components; ++c) fallback[c] = double(numbers.values[i * numbers.components + c]);
        return fallback;
    };
    std::vector<dmat4> transforms(count);
    for (std::size_t i = 0; i < count; ++i)
        transforms[i] = compose(dvec3(at(translation, i, dvec4(0.0))), at(rotation, i, dvec4(0, 0, 0, 1)), dvec3(at(scale, i, dvec4(1.0))));
    return transforms;
}

bool invertible(const dmat4& toWorld)
{
    // Volume of the unit cube's image against the cube of its longest edge: 1 : 1000 in an axis is 1e-3, 1e-18 is flat to any float.
    constexpr double kFlattest = 1e-18;
    double longest = 0.0;
    for (int axis = 0; axis < 4; ++axis)
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(toWorld[axis][row])) return false;
    for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, length(dvec3(toWorld[axis])));
    if (!(longest > 0.0)) return false;
    return std::abs(determinant(dmat3(toWorld) * (1.0 / longest))) > kFlattest;
}

bool mirrors(const dmat4& toWorld) { return determinant(dmat3(toWorld)) < 0.0; }

const dmat4& reflection()
{
    static const dmat4 matrix(dvec4(-1, 0, 0, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, 0, 0, 1));
    return matrix;
}

void reflect(std::vector<Vertex>& vertices, std::vector<uint>& indices)
{
    for (Vertex& vertex : vertices) {
        vertex.position.x = -vertex.position.x;
        vertex.normal.x = -vertex.normal.x;
        vertex.tangent.x = -vertex.tangent.x;
        vertex.tangent.w = -vertex.tangent.w;
    }
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) std::swap(indices[i + 1], indices[i + 2]);
}
}
