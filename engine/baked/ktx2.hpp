// KTX 2.0, the container of every baked texture: 2D, arrays, 3D and cubes with mip levels, zstd inside, readable by any other program.
// This work is based on: the KTX 2.0 specification and the Khronos Data Format Specification 1.3.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace afterglow
{
// The VkFormat, as the file says it.
enum class Ktx2Format : std::uint32_t {
    r8 = 9,        // R8_UNORM
    rgba8 = 37,    // R8G8B8A8_UNORM
    srgba8 = 43,   // R8G8B8A8_SRGB
    rgba16f = 97,  // R16G16B16A16_SFLOAT
    rgba32f = 109, // R32G32B32A32_SFLOAT
    rgb9e5 = 123,  // E5B9G9R9_UFLOAT_PACK32
};

int texelBytes(Ktx2Format format);

// Level m has edges max(1, edge >> m), and holds tightly: layers, in them faces (+x -x +y -y +z -z), in them slices of z, rows from the
// top, texels; numbers little-endian.
struct Ktx2 {
    Ktx2Format format = Ktx2Format::rgba8;
    int width = 1;
    int height = 1;
    int depth = 0;  // 0: two-dimensional
    int layers = 0; // 0: not an array
    int faces = 1;  // 6: a cube
    std::vector<std::vector<std::uint8_t>> levels;
    std::map<std::string, std::string> keys; // key/value data; KTXwriter is added by the writer
};

// Bytes that a level must hold.
std::uint64_t levelBytes(const Ktx2& texture, int level);

std::vector<std::uint8_t> encodeKtx2(const Ktx2& texture);
void writeKtx2(const std::filesystem::path& path, const Ktx2& texture);

// Throws Error, before anything is allocated, when the file is foreign, truncated, of another version, or says sizes that it cannot hold;
// and when a level's checksum fails. `what` names the file in the sentence.
Ktx2 decodeKtx2(const std::vector<std::uint8_t>& bytes, const std::string& what);
Ktx2 readKtx2(const std::filesystem::path& path);
}
