// The inside of a .glb as it is written: one binary chunk, the views and accessors that name its parts, and the container around both.
#pragma once
#include "engine/baked/bytes.hpp"
#include "engine/scene/document.hpp"
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

namespace afterglow
{
// glTF's numbers for component types and for what a view is used as.
enum class Component { u8 = 5121, u16 = 5123, u32 = 5125, f32 = 5126 };
enum class ViewTarget { none = 0, vertices = 34962, indices = 34963 };

struct BinaryChunk {
    Bytes bytes;
    std::shared_ptr<nlohmann::json> views, accessors; // arrays, as glTF's bufferViews and accessors
    std::map<std::size_t, std::size_t> copiedViews;   // of the level's file -> here

    BinaryChunk();
};

// Appends bytes as a view of their own, on four bytes; returns its index.
std::size_t addView(BinaryChunk& chunk, std::span<const std::uint8_t> bytes, ViewTarget target);

struct AccessorShape {
    Component component = Component::f32;
    const char* type = "SCALAR"; // or VEC2 ...
    std::size_t count = 0;
    bool normalized = false;
};
// An accessor over a view of its own; returns its index.
std::size_t addAccessor(BinaryChunk& chunk, std::span<const std::uint8_t> bytes, const AccessorShape& shape, ViewTarget target);

// Copies an accessor of the level's file, with the views it needs, into the chunk. Throws Malformed when they are not there.
std::size_t copyAccessor(BinaryChunk& chunk, const Document& level, std::size_t accessor);

// Puts the chunk's views, accessors and buffer into the JSON, and both into one file.
Bytes encodeGlb(nlohmann::json json, const BinaryChunk& chunk);
}
