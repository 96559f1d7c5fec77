#include "engine/baked/glb.hpp"
#include "engine/scene/accessor.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942; // glTF, JSON, BIN

BinaryChunk::BinaryChunk() : views(std::make_shared<json>(json::array())), accessors(std::make_shared<json>(json::array())) {}

std::size_t addView(BinaryChunk& chunk, std::span<const std::uint8_t> bytes, ViewTarget target)
{
    pad(chunk.bytes, 4);
    json view = {{"buffer", 0}, {"byteOffset", chunk.bytes.size()}, {"byteLength", bytes.size()}};
    if (target != ViewTarget::none) view["target"] = int(target);
    chunk.bytes.insert(chunk.bytes.end(), bytes.begin(), bytes.end());
    chunk.views->push_back(std::move(view));
    return chunk.views->size() - 1;
}

std::size_t addAccessor(BinaryChunk& chunk, std::span<const std::uint8_t> bytes, const AccessorShape& shape, ViewTarget target)
{
    const std::size_t view = addView(chunk, bytes, target);
    json accessor = {{"bufferView", view}, {"componentType", int(shape.component)}, {"type", shape.type}, {"count", shape.count}};
    if (shape.normalized) accessor["normalized"] = true;
    chunk.accessors->push_back(std::move(accessor));
    return chunk.accessors->size() - 1;
}

static std::size_t copyView(BinaryChunk& chunk, const Document& level, std::size_t index)
{
    const auto [copy, isNew] = chunk.copiedViews.try_emplace(index, chunk.views->size());
    if (!isNew) return copy->second;
    addView(chunk, viewBytes(level, index), ViewTarget::none);
    const json& view = level.json->at("bufferViews").at(index);
    for (const char* key : {"byteStride", "target"})
        if (view.contains(key)) chunk.views->back()[key] = view[key];
    return copy->second;
}

std::size_t copyAccessor(BinaryChunk& chunk, const Document& level, std::size_t index)
{
    json accessor = level.json->at("accessors").at(index);
    const auto follow = [&](json& owner) { owner["bufferView"] = copyView(chunk, level, owner["bufferView"].get<std::size_t>()); };
    if (accessor.contains("bufferView")) follow(accessor);
    if (accessor.contains("sparse")) {
        follow(accessor["sparse"]["indices"]);
        follow(accessor["sparse"]["values"]);
    }
    chunk.accessors->push_back(std::move(accessor));
    return chunk.accessors->size() - 1;
}

static void putChunk(Bytes& file, std::uint32_t type, std::span<const std::uint8_t> content, std::uint8_t filler)
{
    const std::size_t padded = (content.size() + 3) / 4 * 4;
    put32(file, std::uint32_t(padded));
    put32(file, type);
    file.insert(file.end(), content.begin(), content.end());
    file.resize(file.size() + padded - content.size(), filler);
}

Bytes encodeGlb(json document, const BinaryChunk& chunk)
{
    for (const char* key : {"bufferViews", "accessors", "buffers"}) document.erase(key);
    if (!chunk.views->empty()) {
        document["bufferViews"] = *chunk.views;
        document["buffers"] = {{{"byteLength", chunk.bytes.size()}}};
    }
    if (!chunk.accessors->empty()) document["accessors"] = *chunk.accessors;
    const std::string text = document.dump();

    Bytes file;
    put32(file, kMagic);
    put32(file, 2);
    put32(file, 0); // the length, when it is known
    putChunk(file, kJsonChunk, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, ' ');
    if (!chunk.views->empty()) putChunk(file, kBinaryChunk, chunk.bytes, 0);
    if (file.size() > 0xFFFFFFFFu) throw Malformed("it would be a .glb of more than 4 GiB, which the format cannot hold");
    for (std::size_t i = 0; i < 4; ++i) file[8 + i] = std::uint8_t(file.size() >> (8 * i));
    return file;
}
}
