#include "engine/scene/accessor.hpp"
#include "engine/scene/fields.hpp"
#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
using nlohmann::json;

// An accessor without a buffer view holds zeros, as many as it says: nothing in the file pays for them.
constexpr std::uint64_t kLargestUnpaid = 1u << 20; // elements

enum Component { kByte = 5120, kUbyte = 5121, kShort = 5122, kUshort = 5123, kUint = 5125, kFloat = 5126 };

std::uint64_t bytesOf(std::uint64_t component)
{
    switch (component) {
    case kByte:
    case kUbyte:
        return 1;
    case kShort:
    case kUshort:
        return 2;
    case kUint:
    case kFloat:
        return 4;
    default:
        throw Malformed("its component type " + std::to_string(component) + " is not one of glTF's");
    }
}

int componentsOf(const std::string& type)
{
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    if (type == "VEC4") return 4;
    throw Malformed("its type " + type + " is not a scalar or a vector");
}

// Where elements lie in a buffer.
struct Range {
    const std::uint8_t* data = nullptr; // null: all zero
    std::uint64_t stride = 0;           // bytes from one element to the next

    const std::uint8_t* at(std::size_t i) const { return data + i * stride; }
};

// The elements' range in the buffer view that `owner` (an accessor, or a part of its sparse) names.
Range rangeOf(const Document& document, const json& owner, std::uint64_t count, std::uint64_t elementBytes)
{
    const json& views = listOf(*document.json, "bufferViews");
    const auto viewIndex = index(owner, "bufferView", views.size());
    if (!viewIndex) {
        if (count > kLargestUnpaid) throw Malformed("it claims " + std::to_string(count) + " elements without a buffer view");
        return {};
    }
    const std::span<const std::uint8_t> bytes = viewBytes(document, *viewIndex);
    const std::uint64_t viewSize = bytes.size();
    const std::uint64_t offset = size(owner, "byteOffset", 0), stride = size(views[*viewIndex], "byteStride", elementBytes);
    const bool fits = stride >= elementBytes && stride <= 255 && count <= viewSize && offset <= viewSize &&
                      elementBytes <= viewSize - offset && (count - 1) * stride <= viewSize - offset - elementBytes;
    if (count > 0 && !fits) throw Malformed("its " + std::to_string(count) + " elements reach past the end of their buffer view");
    return {bytes.data() + offset, stride};
}

template <typename T>
T loaded(const std::uint8_t* bytes)
{
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

float numberAt(const std::uint8_t* bytes, std::uint64_t component, bool normalized)
{
    switch (component) {
    case kByte:
        return normalized ? std::max(float(loaded<std::int8_t>(bytes)) / 127.0f, -1.0f) : float(loaded<std::int8_t>(bytes));
    case kUbyte:
        return float(*bytes) / (normalized ? 255.0f : 1.0f);
    case kShort:
        return normalized ? std::max(float(loaded<std::int16_t>(bytes)) / 32767.0f, -1.0f) : float(loaded<std::int16_t>(bytes));
    case kUshort:
        return float(loaded<std::uint16_t>(bytes)) / (normalized ? 65535.0f : 1.0f);
    case kUint:
        return float(loaded<std::uint32_t>(bytes));
    default:
        return loaded<float>(bytes);
    }
}

std::uint32_t integerAt(const std::uint8_t* bytes, std::uint64_t component)
{
    switch (component) {
    case kUbyte:
        return *bytes;
    case kUshort:
        return loaded<std::uint16_t>(bytes);
    case kUint:
        return loaded<std::uint32_t>(bytes);
    default:
        throw Malformed("its component type is no unsigned integer");
    }
}

// Calls store(element, bytes) for each element of the accessor that is not zero by default: the dense ones, then the sparse ones.
template <typename Store>
void visit(const Document& document, const json& accessor, std::uint64_t count, std::uint64_t elementBytes, const Store& store)
{
    const Range dense = rangeOf(document, accessor, count, elementBytes);
    if (dense.data)
        for (std::size_t i = 0; i < count; ++i) store(i, dense.at(i));

    const json& sparse = member(accessor, "sparse");
    if (sparse.is_null()) return;
    const std::uint64_t replaced = size(sparse, "count", 0);
    if (replaced > count) throw Malformed("it replaces more elements than it has");
    const json &where = member(sparse, "indices"), &what = member(sparse, "values");
    const std::uint64_t component = size(where, "componentType", 0);
    const Range indices = rangeOf(document, where, replaced, bytesOf(component)), values = rangeOf(document, what, replaced, elementBytes);
    if (!indices.data || !values.data) throw Malformed("its sparse part names no buffer view");
    for (std::size_t i = 0; i < replaced; ++i) {
        const std::uint32_t element = integerAt(indices.at(i), component);
        if (element >= count)
            throw Malformed("its sparse part replaces element " + std::to_string(element) + " of " + std::to_string(count));
        store(element, values.at(i));
    }
}

// Says which accessor a problem is about.
template <typename Read>
auto named(const Document& document, std::size_t accessor, const Read& read)
{
    try {
        return read(listOf(*document.json, "accessors")[accessor]);
    } catch (const Malformed& problem) {
        throw Malformed("accessor " + std::to_string(accessor) + ": " + problem.what());
    }
}
}

std::span<const std::uint8_t> viewBytes(const Document& document, std::size_t view)
{
    const json& source = listOf(*document.json, "bufferViews").at(view);
    const auto bufferIndex = index(source, "buffer", document.buffers.size());
    if (!bufferIndex) throw Malformed("buffer view " + std::to_string(view) + " names no buffer");
    const std::vector<std::uint8_t>& buffer = document.buffers[*bufferIndex];
    const std::uint64_t offset = size(source, "byteOffset", 0), length = size(source, "byteLength", 0);
    if (offset > buffer.size() || length > buffer.size() - offset)
        throw Malformed("buffer view " + std::to_string(view) + " reaches past the end of its buffer");
    return {buffer.data() + offset, length};
}

Numbers readNumbers(const Document& document, std::size_t accessor)
{
    return named(document, accessor, [&](const json& source) {
        const std::uint64_t component = size(source, "componentType", 0), bytes = bytesOf(component), count = size(source, "count", 0);
        const bool normalized = flag(source, "normalized", false);
        const int components = componentsOf(text(source, "type"));
        rangeOf(document, source, count, bytes * components); // before anything is allocated
        Numbers numbers{count, components, std::vector<float>(count * components)};
        visit(document, source, count, bytes * components, [&](std::size_t i, const std::uint8_t* element) {
            for (int c = 0; c < components; ++c) numbers.values[i * components + c] = numberAt(element + c * bytes, component, normalized);
        });
        return numbers;
    });
}

std::vector<std::uint32_t> readIndices(const Document& document, std::size_t accessor)
{
    return named(document, accessor, [&](const json& source) {
        const std::uint64_t component = size(source, "componentType", 0), count = size(source, "count", 0);
        if (text(source, "type") != "SCALAR") throw Malformed("indices are not scalars");
        rangeOf(document, source, count, bytesOf(component));
        std::vector<std::uint32_t> indices(count);
        visit(document, source, count, bytesOf(component),
              [&](std::size_t i, const std::uint8_t* element) { indices[i] = integerAt(element, component); });
        return indices;
    });
}
}
