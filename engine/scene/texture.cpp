#include "engine/scene/texture.hpp"
#include "engine/core/error.hpp"
#include "engine/core/jobs.hpp"
#include "engine/scene/accessor.hpp"
#include "engine/scene/fields.hpp"
#include "shaders/color.h"
#include <cmath>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr std::uint64_t kNearest = 9728, kClampToEdge = 33071, kMirroredRepeat = 33648, kRepeat = 10497; // of glTF's samplers

Wrap wrapOf(const json& sampler, const char* key)
{
    const std::uint64_t mode = size(sampler, key, kRepeat);
    return mode == kClampToEdge ? Wrap::clamp : mode == kMirroredRepeat ? Wrap::mirror : Wrap::repeat;
}

std::string imageName(const json& image, std::size_t i)
{
    const std::string uri = text(image, "uri");
    if (!uri.empty() && !uri.starts_with("data:")) return "the image \"" + uri + "\"";
    const std::string name = text(image, "name");
    return name.empty() ? "image " + std::to_string(i) : "the image \"" + name + "\"";
}

Image8 decoded(const Document& document, std::optional<std::size_t> source)
{
    const json& images = listOf(*document.json, "images");
    if (!source) throw Malformed("a texture names no image that is read here (.png, .jpg)");
    const std::string name = imageName(images[*source], *source);
    std::span<const std::uint8_t> bytes;
    if (const auto view = index(images[*source], "bufferView", listOf(*document.json, "bufferViews").size()))
        bytes = viewBytes(document, *view);
    else if (*source < document.images.size())
        bytes = document.images[*source];
    if (bytes.empty()) throw Malformed(name + " is missing");
    return decodeImage8(bytes.data(), bytes.size(), name);
}

int wrapped(int i, int n, Wrap wrap)
{
    if (wrap == Wrap::clamp) return std::clamp(i, 0, n - 1);
    const int period = wrap == Wrap::mirror ? 2 * n : n;
    const int inside = ((i % period) + period) % period;
    return inside < n ? inside : period - 1 - inside;
}
}

std::array<std::uint8_t, 4> neutralTexel(Slot slot)
{
    switch (slot) {
    case Slot::baseColor:
        return {188, 188, 188, 255}; // albedo 0.5
    case Slot::metallicRoughness:
        return {0, 255, 0, 255};
    case Slot::normal:
        return {128, 128, 255, 255};
    default:
        return {0, 0, 0, 255};
    }
}

TextureRef noTexture() { return {.texture = -1, .uvSet = 0, .matrix = vec4(1, 0, 0, 1), .offset = vec2(0.0f)}; }

TextureRef readTextureRef(const Document& document, const json& info, Slot slot, TextureIndex& known, Scene& scene)
{
    TextureRef ref = noTexture();
    const json& textures = listOf(*document.json, "textures");
    const auto found = index(info, "index", textures.size());
    if (!found) return ref;

    const json& transform = extension(info, "KHR_texture_transform");
    const std::uint64_t uvSet = size(transform, "texCoord", size(info, "texCoord", 0));
    ref.uvSet = uvSet == 1 ? 1 : 0;
    if (uvSet > 1) scene.warnings.push_back("a texture reads TEXCOORD_" + std::to_string(uvSet) + ", and only 0 and 1 are read: 0 is used");
    // Scale, then rotate counter-clockwise as seen with v downwards, then move.
    const double angle = number(transform, "rotation", 0.0), c = std::cos(angle), s = std::sin(angle);
    const dvec2 scale = pair(transform, "scale", dvec2(1.0));
    ref.matrix = vec4(dvec4(c * scale.x, -s * scale.x, s * scale.y, c * scale.y));
    ref.offset = vec2(pair(transform, "offset", dvec2(0.0)));
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(ref.matrix[i]) || !std::isfinite(ref.offset[i % 2])) throw Malformed("a texture transform is not finite");

    const json &source = textures[*found], &images = listOf(*document.json, "images"), &samplers = listOf(*document.json, "samplers");
    const TextureKey key{index(source, "source", images.size()), index(source, "sampler", samplers.size()), slot};
    const auto [place, isNew] = known.try_emplace(key, int(scene.textures.size()));
    ref.texture = place->second;
    if (!isNew) return ref;
    const json& sampler = key.sampler ? samplers[*key.sampler] : member(source, "");
    SceneTexture texture;
    texture.name = text(source, "name", key.image ? text(images[*key.image], "name") : "");
    texture.srgb = slot == Slot::baseColor || slot == Slot::emissive;
    texture.wrapU = wrapOf(sampler, "wrapS");
    texture.wrapV = wrapOf(sampler, "wrapT");
    texture.nearest = size(sampler, "magFilter", 0) == kNearest;
    scene.textures.push_back(std::move(texture));
    return ref;
}

void decodeTextures(const Document& document, const TextureIndex& known, Scene& scene)
{
    struct Job {
        TextureKey key;
        int texture;
        std::string problem;
    };
    std::vector<Job> jobs;
    for (const auto& [key, texture] : known) jobs.push_back({key, texture, ""});
    parallelFor(jobs.size(), /* threads= */ 0, [&](std::size_t i) {
        Job& job = jobs[i];
        SceneTexture& texture = scene.textures[job.texture];
        try {
            texture.image = decoded(document, job.key.image);
        } catch (const std::runtime_error& error) { // Error or Malformed: the level can be shown without it
            job.problem = error.what();
            const auto texel = neutralTexel(job.key.slot);
            texture.image = {1, 1, 4, {texel.begin(), texel.end()}};
        }
    });
    for (const Job& job : jobs) {
        if (job.problem.empty()) continue;
        ++scene.dropped["textures that cannot be read"];
        scene.warnings.push_back(job.problem + ": a neutral colour stands in for it");
    }
}

vec4 texel(const SceneTexture& texture, int x, int y)
{
    const Image8& image = texture.image;
    const std::size_t row = wrapped(y, image.height, texture.wrapV), column = wrapped(x, image.width, texture.wrapU);
    const std::uint8_t* code = &image.pixels[(row * image.width + column) * 4];
    const vec4 value = vec4(code[0], code[1], code[2], code[3]) / 255.0f;
    return texture.srgb ? vec4(srgbDecode(vec3(value)), value.w) : value;
}
}
