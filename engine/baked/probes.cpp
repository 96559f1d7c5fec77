#include "engine/baked/probes.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/origin.hpp"
#include <glm/gtc/type_ptr.hpp>

namespace afterglow
{
// Number n of the 28 of a probe.
static float& number(ProbeVolume& volume, std::size_t probe, int n)
{
    return n < 27 ? volume.irradiance[probe].c[n / 3][n % 3] : volume.validity[probe];
}

// Calls visit(texel index, probe index, slab) for every texel of the texture, in its order.
template <class Visit>
static void forEachTexel(ivec3 count, Visit visit)
{
    const std::size_t probes = std::size_t(count.x) * std::size_t(count.y) * std::size_t(count.z);
    for (int slab = 0; slab < kProbeSlabs; ++slab)
        for (std::size_t probe = 0; probe < probes; ++probe) visit(std::size_t(slab) * probes + probe, probe, slab);
}

Ktx2 probeTexture(const ProbeVolume& volume, dvec3 origin)
{
    ProbeVolume copy = volume;
    std::vector<vec4> texels(volume.irradiance.size() * kProbeSlabs);
    forEachTexel(volume.count, [&](std::size_t texel, std::size_t probe, int slab) {
        for (int c = 0; c < 4; ++c) texels[texel][c] = number(copy, probe, 4 * slab + c);
    });
    Ktx2 texture;
    texture.format = holding(texels, Ktx2Format::rgba16f);
    texture.width = volume.count.x;
    texture.height = volume.count.y;
    texture.depth = volume.count.z * kProbeSlabs;
    texture.levels = {packTexels(texels, texture.format)};
    texture.keys["ag_name"] = volume.name;
    const dmat4 placed = toLevel(dmat4(volume.toWorld), origin);
    texture.keys["ag_to_world"] = numbersText({value_ptr(placed), 16});
    texture.keys["ag_quantity"] = "SH of irradiance / pi, 27 numbers and validity in 7 slabs along z";
    return texture;
}

ProbeVolume readProbes(const Ktx2& texture, const std::string& what, dvec3 origin)
{
    const bool floats = texture.format == Ktx2Format::rgba16f || texture.format == Ktx2Format::rgba32f;
    if (!floats || texture.depth == 0 || texture.depth % kProbeSlabs != 0 || texture.faces != 1)
        throw Error("cannot read " + what + ": it is not a probe volume");
    ProbeVolume volume;
    volume.count = ivec3(texture.width, texture.height, texture.depth / kProbeSlabs);
    const auto name = texture.keys.find("ag_name");
    if (name != texture.keys.end()) volume.name = name->second;
    volume.toWorld = mat4(fromLevel(glm::make_mat4(readNumbersText(texture, "ag_to_world", 16, what).data()), origin));

    const std::vector<vec4> texels = unpackTexels(texture.levels[0], texture.format);
    volume.irradiance.resize(texels.size() / kProbeSlabs);
    volume.validity.resize(texels.size() / kProbeSlabs);
    forEachTexel(volume.count, [&](std::size_t texel, std::size_t probe, int slab) {
        for (int c = 0; c < 4; ++c) number(volume, probe, 4 * slab + c) = texels[texel][c];
    });
    return volume;
}
}
