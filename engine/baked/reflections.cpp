#include "engine/baked/reflections.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include "engine/scene/origin.hpp"

namespace afterglow
{
Ktx2 reflectionTexture(const ReflectionProbe& probe, dvec3 origin)
{
    Ktx2 texture;
    texture.width = texture.height = probe.size;
    texture.faces = 6;
    std::vector<std::vector<vec4>> mips;
    texture.format = Ktx2Format::rgba16f;
    for (const std::vector<vec3>& mip : probe.mips) {
        std::vector<vec4>& texels = mips.emplace_back();
        for (const vec3& texel : mip) texels.push_back(vec4(texel, 1.0f));
        if (holding(texels, texture.format) == Ktx2Format::rgba32f) texture.format = Ktx2Format::rgba32f;
    }
    for (const std::vector<vec4>& texels : mips) texture.levels.push_back(packTexels(texels, texture.format));
    const dvec3 p = toLevel(probe.position, origin), lower = toLevel(probe.boxLower, origin), upper = toLevel(probe.boxUpper, origin);
    texture.keys["KTXorientation"] = "rd";
    texture.keys["ag_name"] = probe.name;
    texture.keys["ag_position"] = numbersText(std::vector<double>{p.x, p.y, p.z});
    texture.keys["ag_box"] = numbersText(std::vector<double>{lower.x, lower.y, lower.z, upper.x, upper.y, upper.z});
    texture.keys["ag_quantity"] = "radiance, linear Rec.709, prefiltered by GGX: roughness = mip / (mips - 1)";
    return texture;
}

ReflectionProbe readReflection(const Ktx2& texture, const std::string& what, dvec3 origin)
{
    const bool floats = texture.format == Ktx2Format::rgba16f || texture.format == Ktx2Format::rgba32f;
    if (!floats || texture.faces != 6 || texture.layers != 0) throw Error("cannot read " + what + ": it is not a reflection probe");
    ReflectionProbe probe;
    const auto name = texture.keys.find("ag_name");
    if (name != texture.keys.end()) probe.name = name->second;
    const std::vector<double> p = readNumbersText(texture, "ag_position", 3, what), box = readNumbersText(texture, "ag_box", 6, what);
    probe.position = fromLevel(dvec3(p[0], p[1], p[2]), origin);
    probe.boxLower = fromLevel(dvec3(box[0], box[1], box[2]), origin);
    probe.boxUpper = fromLevel(dvec3(box[3], box[4], box[5]), origin);
    probe.size = texture.width;
    for (const std::vector<std::uint8_t>& level : texture.levels) {
        std::vector<vec3>& mip = probe.mips.emplace_back();
        for (const vec4& texel : unpackTexels(level, texture.format)) mip.push_back(vec3(texel));
    }
    return probe;
}
}
