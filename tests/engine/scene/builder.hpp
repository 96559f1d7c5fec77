// Tiny levels for the tests of this folder: glTF as JSON and a buffer, written as .glb or .gltf into a folder that goes with the test.
#pragma once
#include "engine/core/error.hpp"
#include "engine/scene/scene.hpp"
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace afterglow::test
{
using nlohmann::json;

inline void write(const std::filesystem::path& path, const std::vector<std::uint8_t>& bytes)
{
    std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
}

inline std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

// The JSON chunk and, when there is one, the binary chunk, each padded to four bytes.
inline std::vector<std::uint8_t> container(std::string text, std::vector<std::uint8_t> buffer)
{
    text.resize((text.size() + 3) / 4 * 4, ' ');
    buffer.resize((buffer.size() + 3) / 4 * 4, 0);
    std::vector<std::uint8_t> file;
    const auto word = [&](std::size_t value) {
        for (int shift = 0; shift < 32; shift += 8) file.push_back(std::uint8_t(value >> shift));
    };
    word(0x46546C67); // glTF
    word(2);
    word(20 + text.size() + (buffer.empty() ? 0 : 8 + buffer.size()));
    word(text.size());
    word(0x4E4F534A);
    file.insert(file.end(), text.begin(), text.end());
    if (buffer.empty()) return file;
    word(buffer.size());
    word(0x004E4942);
    file.insert(file.end(), buffer.begin(), buffer.end());
    return file;
}

class LevelTest : public ::testing::Test
{
protected:
    json gltf = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", json::array()}}}}};
    std::vector<std::uint8_t> buffer;
    std::filesystem::path folder;

    void SetUp() override
    {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        folder = std::filesystem::temp_directory_path() /
                 (std::string("afterglow_") + info->test_suite_name() + "_" + info->name() + "_" + std::to_string(getpid())) / "level";
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder.parent_path()); }

    std::size_t add(const char* list, json element)
    {
        gltf[list].push_back(std::move(element));
        return gltf[list].size() - 1;
    }
    json& extras() { return gltf["scenes"][0]["extras"]; }

    std::size_t view(const void* data, std::size_t size)
    {
        buffer.resize((buffer.size() + 3) / 4 * 4, 0);
        const std::size_t offset = buffer.size();
        buffer.resize(offset + size);
        std::memcpy(buffer.data() + offset, data, size);
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
    }

    // One accessor over its own buffer view. Component types: 5120 byte, 5121 ubyte, 5122 short, 5123 ushort, 5125 uint, 5126 float.
    template <typename T>
    std::size_t accessor(const std::vector<T>& values, int componentType, const char* type, bool normalized = false)
    {
        const std::size_t components = std::string(type) == "SCALAR" ? 1 : std::size_t(type[3] - '0');
        json source = {{"bufferView", view(values.data(), values.size() * sizeof(T))},
                       {"componentType", componentType},
                       {"count", values.size() / components},
                       {"type", type}};
        if (normalized) source["normalized"] = true;
        return add("accessors", source);
    }
    std::size_t floats(const std::vector<float>& values, const char* type) { return accessor(values, 5126, type); }
    std::size_t indices(const std::vector<std::uint32_t>& values) { return accessor(values, 5125, "SCALAR"); }

    // A primitive of these positions, without normals unless given.
    json primitive(const std::vector<float>& positions) { return {{"attributes", {{"POSITION", floats(positions, "VEC3")}}}}; }
    json triangle() { return primitive({0, 0, 0, 1, 0, 0, 0, 1, 0}); }

    std::size_t mesh(json one) { return add("meshes", {{"name", "Wall"}, {"primitives", {std::move(one)}}}); }

    // A root of the scene.
    std::size_t node(json source)
    {
        const std::size_t i = add("nodes", std::move(source));
        gltf["scenes"][0]["nodes"].push_back(i);
        return i;
    }
    std::size_t place(json one, json source = json::object())
    {
        source["mesh"] = mesh(std::move(one));
        return node(std::move(source));
    }

    std::vector<std::uint8_t> glb()
    {
        if (!buffer.empty()) gltf["buffers"] = {{{"byteLength", buffer.size()}}};
        return container(gltf.dump(), buffer);
    }
    std::filesystem::path written(const std::vector<std::uint8_t>& file, const char* name = "level.glb")
    {
        write(folder / name, file);
        return folder / name;
    }
    Scene load() { return loadLevel(written(glb())); }

    // The sentence of the Error that loading throws, which is of bad input; empty when it loads.
    std::string sentence(const std::filesystem::path& path)
    {
        try {
            loadLevel(path);
        } catch (const Error& error) {
            EXPECT_EQ(error.exit, Exit::badInput);
            return error.what();
        }
        return "";
    }
    std::string sentence() { return sentence(written(glb())); }
};

inline ::testing::AssertionResult near(vec3 a, vec3 b, float tolerance = 1e-6f)
{
    if (length(a - b) <= tolerance) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << a.x << " " << a.y << " " << a.z << " is not " << b.x << " " << b.y << " " << b.z;
}

inline std::size_t triangles(const Scene& scene) { return scene.indices.size() / 3; }
inline int count(const Scene& scene, const char* key) { return scene.dropped.contains(key) ? scene.dropped.at(key) : 0; }
}
