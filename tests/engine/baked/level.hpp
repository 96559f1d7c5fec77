// A level of 1 m quads that meets everything a baked level must keep: a child under a turned parent, a mesh shared by two nodes, a mirrored
// node, instances, fog, a texture and a sky beside it, a light, a camera, a switched-off static, an animation.
#pragma once
#include "engine/baked/bytes.hpp"
#include "engine/core/file.hpp"
#include "engine/core/image.hpp"
#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
inline std::filesystem::path emptyFolder(const std::string& name)
{
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "afterglow_baked" / name;
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
    return path;
}

class LevelFile
{
public:
    std::filesystem::path write(const std::filesystem::path& folder)
    {
        writePictures(folder);
        nlohmann::json gltf = {{"asset", {{"version", "2.0"}, {"copyright", "a test"}}}, {"scene", 0}};
        const int quad = addQuad(), box = addBox(), times = addTimes(), turns = floats({0, 0, 0, 1, 0, 1, 0, 0}, "VEC4");
        gltf["meshes"] = {{{"name", "quad"}, {"extras", {{"author", "me"}}}, {"primitives", {primitive(quad, 0)}}},
                          {{"name", "plain"}, {"primitives", {primitive(quad, -1)}}},
                          {{"name", "box"}, {"primitives", {primitive(box, -1)}}}};
        const int places = floats({0, 0, 0, 3, 0, 0, 6, 0, 0}, "VEC3");
        gltf["nodes"] = {
            {{"name", "parent"}, {"rotation", {0, 0.70710678, 0, 0.70710678}}, {"children", {1, 2}}},
            {{"name", "child"}, {"mesh", 0}, {"translation", {1, 2, 3}}, {"extras", {{"ag_texels_per_metre", 4.0}, {"colour", "red"}}}},
            {{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"extras", {{"ag_radius_m", 0.25}}}},
            {{"name", "twin"}, {"mesh", 0}, {"translation", {-4, 0, 0}}, {"children", {4}}},
            {{"name", "eye"}, {"camera", 0}},
            {{"name", "mirrored"}, {"mesh", 1}, {"scale", {-2, 1, 1}}, {"extras", {{"ag_static", false}}}},
            {{"name", "row"}, {"mesh", 1}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", {{"TRANSLATION", places}}}}}}}},
            {{"name", "mist"}, {"mesh", 2}, {"extras", {{"ag_fog_scattering", {0.1, 0.1, 0.1}}, {"ag_fog_absorption", {0, 0, 0}}}}}};
        gltf["scenes"] = {
            {{"name", "main"}, {"nodes", {0, 3, 5, 6, 7}}, {"extras", {{"ag_sky_image", "pictures/dawn.hdr"}, {"ag_exposure_ev", -1.0}}}}};
        gltf["materials"] = {{{"name", "brick"},
                              {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"roughnessFactor", 0.5}}},
                              {"normalTexture", {{"index", 0}}},
                              {"extras", {{"ag_sigma_deg", 10.0}}}}};
        gltf["textures"] = {{{"source", 0}, {"sampler", 0}}};
        gltf["samplers"] = {{{"wrapS", 33071}}};
        gltf["images"] = {{{"uri", "pictures/wall%20paper.png"}}};
        gltf["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
        gltf["extensions"] = {{"KHR_lights_punctual", {{"lights", {{{"type", "point"}, {"intensity", 7.0}}}}}}};
        gltf["extensionsUsed"] = {"KHR_lights_punctual", "EXT_mesh_gpu_instancing"};
        gltf["animations"] = {{{"channels", {{{"sampler", 0}, {"target", {{"node", 5}, {"path", "rotation"}}}}}},
                               {"samplers", {{{"input", times}, {"output", turns}}}}}};
        gltf["accessors"] = accessors_;
        gltf["bufferViews"] = views_;
        gltf["buffers"] = {{{"uri", "level.bin"}, {"byteLength", bytes_.size()}}};
        writeFile(folder / "level.bin", bytes_.data(), bytes_.size());
        writeText(folder / "level.gltf", gltf.dump(1));
        return folder / "level.gltf";
    }

private:
    static void writePictures(const std::filesystem::path& folder)
    {
        std::filesystem::create_directories(folder / "pictures");
        Image8 paper;
        paper.width = 2, paper.height = 2;
        paper.pixels = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 8, 7, 255};
        writePng(folder / "pictures" / "wall paper.png", paper);
        Image sky(8, 4, 3);
        for (std::size_t i = 0; i < sky.pixels.size(); ++i) sky.pixels[i] = 0.5f + float(i);
        writeExr(folder / "pictures" / "dawn.hdr", sky);
    }

    int accessor(const Bytes& bytes, int component, const char* type, std::size_t count)
    {
        pad(bytes_, 4);
        views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", bytes.size()}});
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
        accessors_.push_back({{"bufferView", views_.size() - 1}, {"componentType", component}, {"type", type}, {"count", count}});
        return int(accessors_.size()) - 1;
    }
    int floats(const std::vector<float>& numbers, const std::string& type)
    {
        Bytes bytes;
        for (float number : numbers) putFloat(bytes, number);
        return accessor(bytes, 5126, type.c_str(), numbers.size() / (type == "SCALAR" ? 1 : std::size_t(type[3] - '0')));
    }
    int indices(const std::vector<std::uint16_t>& numbers)
    {
        Bytes bytes;
        for (std::uint16_t number : numbers) put<std::uint16_t>(bytes, number);
        return accessor(bytes, 5123, "SCALAR", numbers.size());
    }

    int addTimes()
    {
        const int times = floats({0, 1}, "SCALAR");
        accessors_.back()["min"] = {0};
        accessors_.back()["max"] = {1};
        return times;
    }

    // Positions, normals, uv and a colour; returns the accessor of the positions, the others follow it.
    int addQuad()
    {
        const int first = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
        accessors_.back()["min"] = {0, 0, 0};
        accessors_.back()["max"] = {1, 1, 0};
        floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
        floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
        accessor({255, 128, 0, 255, 255, 255, 255, 255, 1, 2, 3, 255, 255, 255, 255, 255}, 5121, "VEC4", 4);
        accessors_.back()["normalized"] = true;
        indices({0, 1, 2, 0, 2, 3});
        return first;
    }
    // A tetrahedron will do: its box is the fog's.
    int addBox()
    {
        const int first = floats({0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2}, "VEC3");
        accessors_.back()["min"] = {0, 0, 0};
        accessors_.back()["max"] = {2, 2, 2};
        floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
        floats({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
        accessor(Bytes(16, 255), 5121, "VEC4", 4);
        accessors_.back()["normalized"] = true;
        indices({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3});
        return first;
    }
    static nlohmann::json primitive(int first, int material)
    {
        nlohmann::json made = {
            {"attributes", {{"POSITION", first}, {"NORMAL", first + 1}, {"TEXCOORD_0", first + 2}, {"COLOR_0", first + 3}}},
            {"indices", first + 4}};
        if (material >= 0) made["material"] = material;
        return made;
    }

    Bytes bytes_;
    nlohmann::json views_ = nlohmann::json::array(), accessors_ = nlohmann::json::array();
};
}
