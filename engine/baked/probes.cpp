#include "engine/baked/probes.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include "shaders/gpu_baked.h"
#include <algorithm>
#include <array>
#include <cmath>

namespace afterglow
{
static constexpr std::size_t kEdge = 16384; // of a texture that others can read
static constexpr std::size_t kLeastRow = 64, kLeastTreeRow = 256;

static constexpr float kMostNumber = 16777216.0f; // up to which floats hold every integer

static std::size_t rowOf(std::size_t count, std::size_t least) { return std::max(least, (count + kEdge - 1) / kEdge); }

// The numbers of a probe in their order, for whoever writes or reads them.
template <class AnyProbe, class Place, class Each>
static void everyNumber(AnyProbe& probe, Place& place, int order, Each each)
{
    const auto vector = [&](auto& v) {
        for (int c = 0; c < 3; c++) each(v[c]);
    };
    for (int i = 0; i < (order + 1) * (order + 1); i++) vector(probe.irradiance.c[i]);
    if (order == 2) vector(probe.lobe), vector(probe.toward);
    vector(place);
}
static std::size_t texelsOfProbe(int order) { return order == 2 ? kTexelsOfProbe : 4; }

static std::string text(double number) { return numbersText({&number, 1}); }
static std::string text(dvec3 v)
{
    const double numbers[] = {v.x, v.y, v.z};
    return numbersText(numbers);
}
static std::size_t countAt(const Ktx2& texture, const char* key, const std::string& what)
{
    const double number = readNumbersText(texture, key, 1, what)[0];
    return number >= 0.0 && number < 1e9 ? std::size_t(number) : 0;
}
static dvec3 vectorAt(const Ktx2& texture, const char* key, const std::string& what)
{
    const std::vector<double> n = readNumbersText(texture, key, 3, what);
    return {n[0], n[1], n[2]};
}

std::vector<vec4> probeTexels(const ProbeTree& tree, std::span<const vec3> places, int order)
{
    const std::size_t each = texelsOfProbe(order);
    std::vector<vec4> texels(tree.probes.size() * each, vec4(0.0f));
    for (std::size_t i = 0; i < tree.probes.size(); i++) {
        std::size_t k = 4 * i * each;
        everyNumber(tree.probes[i], places[i], order, [&](float number) { texels[k / 4][int(k % 4)] = number, k++; });
    }
    return texels;
}

std::vector<vec4> probeTreeTexels(std::span<const ProbeNode> nodes, std::span<const ProbeCell> cells)
{
    check(nodes.size() < std::size_t(kMostNumber) && cells.size() < std::size_t(kMostNumber), "a float holds every number");
    std::vector<vec4> texels;
    for (const ProbeNode& node : nodes) {
        texels.push_back(vec4(node.normal, node.offset));
        texels.push_back(vec4(float(node.below), float(node.above), 0.0f, 0.0f));
    }
    for (const ProbeCell& cell : cells) {
        texels.push_back(vec4(cell.lower, cell.perExtent.x));
        texels.push_back(vec4(cell.perExtent.y, cell.perExtent.z, 0.0f, 0.0f));
        for (int k = 0; k < 8; k += 4)
            texels.push_back(vec4(float(cell.probe[k]), float(cell.probe[k + 1]), float(cell.probe[k + 2]), float(cell.probe[k + 3])));
    }
    return texels;
}

Ktx2 probeTexture(const ProbeTree& tree)
{
    vec3 lower(kFloatMax), upper(-kFloatMax);
    for (vec3 position : tree.positions) lower = min(lower, position), upper = max(upper, position);
    std::vector<vec3> places;
    for (vec3 position : tree.positions) places.push_back((position - lower) / max(upper - lower, vec3(1e-9f)));
    std::vector<vec4> texels = probeTexels(tree, places, tree.order);
    Ktx2 texture;
    const std::size_t row = rowOf(tree.probes.size(), kLeastRow);
    texture.width = int(row * texelsOfProbe(tree.order));
    texture.height = int((tree.probes.size() + row - 1) / row);
    texels.resize(std::size_t(texture.width) * std::size_t(texture.height), vec4(0.0f));
    texture.format = holding(texels, Ktx2Format::rgba16f);
    texture.levels = {packTexels(texels, texture.format)};
    texture.keys["ag_count"] = text(double(tree.probes.size()));
    texture.keys["ag_lower"] = text(dvec3(lower));
    texture.keys["ag_upper"] = text(dvec3(upper));
    texture.keys["ag_order"] = text(double(tree.order));
    if (!tree.stands.empty()) {
        std::string stands;
        for (ProbeStand stand : tree.stands) stands += char(stand);
        texture.keys["ag_stands"] = stands;
    }
    texture.keys["ag_quantity"] = tree.order == 2 ? "nine texels a probe: SH of irradiance / pi, a lobe, its axis, its place"
                                                  : "four texels a probe: SH of irradiance / pi, its place";
    return texture;
}

Ktx2 probeTreeTexture(const ProbeTree& tree, dvec3 origin)
{
    check(tree.probes.size() < std::size_t(kMostNumber), "a float holds every number");
    std::vector<vec4> texels = probeTreeTexels(tree.nodes, tree.cells);
    Ktx2 texture;
    const std::size_t row = rowOf(texels.size(), kLeastTreeRow);
    texture.width = int(row);
    texture.height = int((texels.size() + row - 1) / row);
    texels.resize(std::size_t(texture.width) * std::size_t(texture.height), vec4(0.0f));
    texture.format = Ktx2Format::rgba32f;
    texture.levels = {packTexels(texels, texture.format)};
    texture.keys["ag_nodes"] = text(double(tree.nodes.size()));
    texture.keys["ag_cells"] = text(double(tree.cells.size()));
    texture.keys["ag_origin"] = text(origin);
    texture.keys["ag_quantity"] = "two texels a node, then four a cell";
    return texture;
}

static void readLight(const Ktx2& texture, ProbeTree& tree, const std::string& what)
{
    const std::size_t count = countAt(texture, "ag_count", what);
    const std::vector<vec4> texels = unpackTexels(texture.levels[0], texture.format);
    tree.order = int(countAt(texture, "ag_order", what));
    const std::size_t each = texelsOfProbe(tree.order);
    if (count == 0 || tree.order < 1 || tree.order > 2 || count * each > texels.size())
        throw Error("cannot read " + what + ": it does not hold the probes that it counts; bake again");
    const vec3 lower(vectorAt(texture, "ag_lower", what)), upper(vectorAt(texture, "ag_upper", what));
    for (std::size_t i = 0; i < count; i++) {
        Probe probe{shZero(), vec3(0.0f), vec3(0.0f)};
        vec3 place;
        std::size_t k = 4 * i * each;
        everyNumber(probe, place, tree.order, [&](float& number) { number = texels[k / 4][int(k % 4)], k++; });
        tree.probes.push_back(probe);
        tree.positions.push_back(lower + (upper - lower) * place);
    }
    const auto stands = texture.keys.find("ag_stands");
    if (stands != texture.keys.end() && stands->second.size() == count)
        for (char stand : stands->second) tree.stands.push_back(ProbeStand(stand));
}

// A child that leads on, so that a walk ends: nodes stand after their parents.
static bool leadsOn(float child, std::size_t node, std::size_t nodes, std::size_t cells)
{
    if (!(std::abs(child) < kMostNumber) || child != std::floor(child)) return false;
    return child >= 0.0f ? std::size_t(child) > node && std::size_t(child) < nodes : std::size_t(~int(child)) < cells;
}

ProbeTree readProbes(const Ktx2& probes, const Ktx2& texture, const std::string& what, dvec3 origin)
{
    const bool floats = probes.format == Ktx2Format::rgba16f || probes.format == Ktx2Format::rgba32f;
    if (!floats || texture.format != Ktx2Format::rgba32f) throw Error("cannot read " + what + ": it is not a tree of probes");
    ProbeTree tree;
    readLight(probes, tree, what);
    const std::size_t nodes = countAt(texture, "ag_nodes", what), cells = countAt(texture, "ag_cells", what);
    const std::vector<vec4> texels = unpackTexels(texture.levels[0], texture.format);
    const Error broken("cannot read " + what + ": its tree leads nowhere; bake again");
    if (nodes == 0 || cells == 0 || nodes * kTexelsOfNode + cells * kTexelsOfCell > texels.size()) throw broken;
    const vec3 shift(vectorAt(texture, "ag_origin", what) - origin); // 0 unless another program moved the level
    for (std::size_t i = 0; i < nodes; i++) {
        const vec4 plane = texels[i * kTexelsOfNode], children = texels[i * kTexelsOfNode + 1];
        if (!leadsOn(children.x, i, nodes, cells) || !leadsOn(children.y, i, nodes, cells)) throw broken;
        tree.nodes.push_back({vec3(plane), plane.w + dot(vec3(plane), shift), int(children.x), int(children.y)});
    }
    for (std::size_t i = 0; i < cells; i++) {
        const vec4* texel = &texels[nodes * kTexelsOfNode + i * kTexelsOfCell];
        ProbeCell cell{vec3(texel[0]) + shift, vec3(texel[0].w, texel[1].x, texel[1].y), {}};
        for (int k = 0; k < 8; k++) {
            const float probe = texel[2 + k / 4][k % 4];
            if (!(probe >= 0.0f && probe < float(tree.probes.size()))) throw broken;
            cell.probe[k] = uint(probe);
        }
        tree.cells.push_back(cell);
    }
    for (vec3& position : tree.positions) position += shift;
    return tree;
}
}
