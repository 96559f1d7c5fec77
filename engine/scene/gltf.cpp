// Opens a level: the only file that knows tinygltf, which checks the file's structure and resolves its buffers and images, embedded or
// beside it. Nothing of the file is trusted before container.cpp and the checks here have seen it.
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/scene/document.hpp"
#include "engine/scene/fields.hpp"
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace afterglow
{
namespace
{
using nlohmann::json;

constexpr std::size_t kLongestProblem = 200; // characters of what tinygltf says: it may quote a whole buffer
constexpr int kDeepestJson = 64;             // tinygltf walks extras by recursion

constexpr std::array kExtensions = {"KHR_lights_punctual",     "KHR_materials_emissive_strength", "KHR_materials_specular",
                                    "KHR_materials_ior",       "KHR_materials_transmission",      "KHR_materials_volume",
                                    "KHR_materials_unlit",     "KHR_materials_anisotropy",        "KHR_texture_transform",
                                    "EXT_mesh_gpu_instancing", "KHR_mesh_quantization",           "MSFT_lod"};

json parsed(const std::string& text)
{
    const auto shallow = [](int depth, json::parse_event_t, json&) {
        if (depth > kDeepestJson) throw Malformed("its JSON is nested too deeply");
        return true;
    };
    try {
        return json::parse(text, shallow);
    } catch (const json::exception&) {
        throw Malformed("the file is not glTF: its JSON cannot be parsed");
    }
}

void checkVersion(const json& gltf)
{
    if (!gltf.is_object() || !gltf.contains("asset") || !gltf["asset"].is_object() || !gltf["asset"].contains("version"))
        throw Malformed("the file is not glTF: it has no asset version");
    const json& version = gltf["asset"]["version"];
    if (!version.is_string() || !version.get<std::string>().starts_with("2.")) throw Malformed("the file is not glTF 2.0");
}

std::vector<std::string> unknownExtensions(const json& gltf, const char* list)
{
    std::vector<std::string> names;
    for (const json& entry : listOf(gltf, list)) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : entry.dump();
        if (std::find(kExtensions.begin(), kExtensions.end(), name) == kExtensions.end()) names.push_back(name);
    }
    return names;
}

void checkExtensions(const json& gltf)
{
    for (const std::string& name : unknownExtensions(gltf, "extensionsRequired")) {
        const bool compressed = name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression";
        throw Malformed("the file needs the glTF extension " + name + ", which Afterglow does not read; export it " +
                        (compressed ? "without mesh compression" : "without this extension"));
    }
}

// Every file that the level names lies in its folder; buffers must be there, an image may be missing (texture.cpp says so).
void checkFiles(const std::filesystem::path& level, const json& gltf)
{
    for (const char* kind : {"buffers", "images"}) {
        for (const json& resource : listOf(gltf, kind)) {
            const std::string uri = text(resource, "uri");
            if (uri.empty() || uri.starts_with("data:")) continue;
            const std::filesystem::path file = besideLevel(level, uri);
            if (kind == std::string_view("buffers") && !std::filesystem::is_regular_file(file))
                throw Malformed("its buffer \"" + uri + "\" is missing; keep the level's files together");
        }
    }
}

// tinygltf points into the buffer where an image lies before anybody asks whether it lies there.
void checkImages(const json& gltf)
{
    const json &images = listOf(gltf, "images"), &views = listOf(gltf, "bufferViews"), &buffers = listOf(gltf, "buffers");
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto view = index(images[i], "bufferView", views.size());
        if (!view) continue;
        const auto buffer = index(views[*view], "buffer", buffers.size());
        const std::uint64_t bytes = buffer ? size(buffers[*buffer], "byteLength", 0) : 0;
        const std::uint64_t offset = size(views[*view], "byteOffset", 0), length = size(views[*view], "byteLength", 0);
        if (offset >= bytes || length > bytes - offset)
            throw Malformed("image " + std::to_string(i) + " reaches past the end of its buffer");
    }
}

// tinygltf reads through these: regular files in the level's folder (`data` is the level's path), nothing else.
bool readable(const std::string& file, void* data)
{
    const auto& level = *static_cast<const std::filesystem::path*>(data);
    const std::filesystem::path folder = std::filesystem::weakly_canonical(std::filesystem::absolute(level).parent_path());
    const std::filesystem::path inside = std::filesystem::weakly_canonical(file).lexically_relative(folder);
    return !inside.empty() && *inside.begin() != ".." && std::filesystem::is_regular_file(file);
}

bool read(std::vector<unsigned char>* bytes, std::string* problem, const std::string& file, void* data)
{
    if (!readable(file, data)) return false;
    try {
        *bytes = readFile(file);
    } catch (const Error& error) {
        *problem = error.what();
        return false;
    }
    return true;
}

std::string asItIs(const std::string& path, void*) { return path; }
bool neverWrite(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }

// Newer tinygltf also asks for a file's size.
void answerSize(auto& files)
{
    if constexpr (requires { files.GetFileSizeInBytes; })
        files.GetFileSizeInBytes = [](std::size_t* size, std::string*, const std::string& file, void* data) {
            *size = readable(file, data) ? std::size_t(std::filesystem::file_size(file)) : 0;
            return true;
        };
}

// Keeps an image's file as it is; one in a buffer view stays there, its range not yet checked.
bool keepBytes(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size, void*)
{
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}
}

Document openDocument(const std::filesystem::path& path)
{
    const std::vector<std::uint8_t> file = readFile(path);
    const std::string text = jsonText(file);
    Document document{.path = path, .json = std::make_shared<const json>(parsed(text))};
    checkVersion(*document.json);
    checkExtensions(*document.json);
    document.unread = unknownExtensions(*document.json, "extensionsUsed");
    checkFiles(path, *document.json);
    checkImages(*document.json);

    tinygltf::FsCallbacks files{};
    files.FileExists = readable;
    files.ExpandFilePath = asItIs;
    files.ReadWholeFile = read;
    files.WriteWholeFile = neverWrite;
    files.user_data = &document.path;
    answerSize(files);

    tinygltf::TinyGLTF reader;
    reader.SetFsCallbacks(files);
    reader.SetImageLoader(keepBytes, nullptr);
    tinygltf::Model model;
    std::string problem, remark;
    bool valid = false;
    const std::string folder = std::filesystem::absolute(path).parent_path().string();
    try {
        valid = isBinary(file) ? reader.LoadBinaryFromMemory(&model, &problem, &remark, file.data(), unsigned(file.size()), folder)
                               : reader.LoadASCIIFromString(&model, &problem, &remark, text.data(), unsigned(text.size()), folder);
    } catch (const std::exception& exception) {
        problem = exception.what();
    }
    if (!valid) throw Malformed("the file is not valid glTF: " + problem.substr(0, std::min(problem.find('\n'), kLongestProblem)));

    for (tinygltf::Buffer& buffer : model.buffers) document.buffers.push_back(std::move(buffer.data));
    for (tinygltf::Image& image : model.images) document.images.push_back(std::move(image.image));
    return document;
}
}
