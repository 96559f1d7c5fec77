#include "engine/baked/ktx2.hpp"
#include "engine/baked/bytes.hpp"
#include "engine/baked/ktx2_descriptor.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <cstring>
#include <memory>
#include <zstd.h>

namespace afterglow
{
static constexpr std::uint8_t kMagic[12] = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
constexpr std::size_t kHeaderBytes = 80; // magic, nine numbers, index of the three data blocks
constexpr std::size_t kLevelEntryBytes = 24;
constexpr std::uint32_t kNoCompression = 0, kZstd = 2;
// Of a noisy page of 2048 x 2048 it leaves 39 % of the bytes, in 1.0 s; level 6 leaves 41 % in 0.5 s, level 12 leaves 38 % in 3.4 s.
constexpr int kZstdLevel = 9;
constexpr std::size_t kZstdPart = 1 << 20;           // bytes: about a tenth of a second
constexpr std::uint64_t kLargestZstdRatio = 1 << 16; // a block of 128 KiB takes at least 4 bytes: whoever claims more is lying
constexpr std::uint32_t kLargestEdge = 16384, kLargestLayers = 2048;

int texelBytes(Ktx2Format format)
{
    switch (format) {
    case Ktx2Format::r8:
        return 1;
    case Ktx2Format::rgba8:
    case Ktx2Format::srgba8:
    case Ktx2Format::rgb9e5:
        return 4;
    case Ktx2Format::rgba16f:
        return 8;
    case Ktx2Format::rgba32f:
        return 16;
    }
    return 0; // a number from a file that is none of ours
}

// Bytes of one number of a texel, for readers that swap.
static std::uint32_t typeSize(Ktx2Format format)
{
    switch (format) {
    case Ktx2Format::rgba16f:
        return 2;
    case Ktx2Format::rgba32f:
    case Ktx2Format::rgb9e5:
        return 4;
    default:
        return 1;
    }
}

std::uint64_t levelBytes(const Ktx2& t, int level)
{
    const auto edge = [level](int size) { return std::uint64_t(std::max(1, size >> level)); };
    return edge(t.width) * edge(t.height) * edge(t.depth) * std::uint64_t(std::max(1, t.layers)) * std::uint64_t(t.faces) *
           std::uint64_t(texelBytes(t.format));
}

// ---- Writing ------------------------------------------------------------------------------------------------------------------------

static Bytes compressed(const Bytes& plain)
{
    const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(), ZSTD_freeCCtx);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kZstdLevel);
    ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1); // a flipped bit is found by the reader
    ZSTD_CCtx_setPledgedSrcSize(context.get(), plain.size());
    Bytes packed(ZSTD_compressBound(plain.size()));
    ZSTD_outBuffer out{packed.data(), packed.size(), 0};
    ZSTD_inBuffer in{plain.data(), 0, 0};
    do { // a part at a time: a large page takes seconds
        stopIfInterrupted();
        in.size = std::min(in.size + kZstdPart, plain.size());
        const std::size_t left = ZSTD_compressStream2(context.get(), &out, &in, in.size == plain.size() ? ZSTD_e_end : ZSTD_e_continue);
        check(ZSTD_isError(left) == 0, ZSTD_getErrorName(left));
    } while (in.pos < plain.size());
    packed.resize(out.pos);
    return packed;
}

static Bytes keyValueData(std::map<std::string, std::string> keys)
{
    keys["KTXwriter"] = "afterglow " AFTERGLOW_VERSION;
    Bytes bytes;
    for (const auto& [key, value] : keys) { // a map: sorted by code point, as the specification asks
        put32(bytes, std::uint32_t(key.size() + value.size() + 2));
        for (const std::string* text : {&key, &value}) {
            bytes.insert(bytes.end(), text->begin(), text->end());
            bytes.push_back(0);
        }
        pad(bytes, 4);
    }
    return bytes;
}

std::vector<std::uint8_t> encodeKtx2(const Ktx2& t)
{
    check(!t.levels.empty(), "a texture has at least one level");
    const Bytes descriptor = dataFormatDescriptor(t.format), keys = keyValueData(t.keys);
    const std::size_t descriptorAt = kHeaderBytes + kLevelEntryBytes * t.levels.size(), keysAt = descriptorAt + descriptor.size();

    // The smallest level comes first in the file, so that a stream can begin to show something.
    Bytes data;
    std::vector<std::uint64_t> offsets(t.levels.size()), sizes(t.levels.size());
    for (std::size_t m = t.levels.size(); m-- > 0;) {
        check(t.levels[m].size() == levelBytes(t, int(m)), "a level holds as many bytes as its size says");
        const Bytes packed = compressed(t.levels[m]);
        offsets[m] = keysAt + keys.size() + data.size();
        sizes[m] = packed.size();
        data.insert(data.end(), packed.begin(), packed.end());
    }

    Bytes file(std::begin(kMagic), std::end(kMagic));
    for (std::uint32_t number :
         {std::uint32_t(t.format), typeSize(t.format), std::uint32_t(t.width), std::uint32_t(t.height), std::uint32_t(t.depth),
          std::uint32_t(t.layers), std::uint32_t(t.faces), std::uint32_t(t.levels.size()), kZstd, std::uint32_t(descriptorAt),
          std::uint32_t(descriptor.size()), std::uint32_t(keysAt), std::uint32_t(keys.size())})
        put32(file, number);
    put64(file, 0); // no global data
    put64(file, 0);
    for (std::size_t m = 0; m < t.levels.size(); ++m) {
        put64(file, offsets[m]);
        put64(file, sizes[m]);
        put64(file, t.levels[m].size());
    }
    for (const Bytes* block : {&descriptor, &keys, static_cast<const Bytes*>(&data)}) file.insert(file.end(), block->begin(), block->end());
    return file;
}

void writeKtx2(const std::filesystem::path& path, const Ktx2& texture)
{
    const Bytes file = encodeKtx2(texture);
    writeFile(path, file.data(), file.size());
}

// ---- Reading ------------------------------------------------------------------------------------------------------------------------

// A range of the file, and whether the file has it.
struct Range {
    std::uint64_t offset, length;
};
static bool inside(const Range& range, std::size_t fileBytes)
{
    return range.offset <= fileBytes && range.length <= fileBytes - range.offset;
}

static std::map<std::string, std::string> readKeys(const std::uint8_t* at, std::uint64_t length, const std::string& damaged)
{
    std::map<std::string, std::string> keys;
    while (length >= 4) {
        const std::uint64_t size = get32(at);
        if (size > length - 4) throw Error(damaged + "its key/value data is longer than it says");
        const char* text = reinterpret_cast<const char*>(at + 4);
        const std::string_view entry(text, std::size_t(size));
        const std::size_t end = entry.find('\0');
        if (end == std::string_view::npos) throw Error(damaged + "a key has no end");
        std::string_view value = entry.substr(end + 1);
        if (value.ends_with('\0')) value.remove_suffix(1);
        keys[std::string(entry.substr(0, end))] = value;
        const std::uint64_t step = std::min(length, 4 + (size + 3) / 4 * 4);
        at += step, length -= step;
    }
    return keys;
}

static Bytes readLevel(const std::uint8_t* at, std::uint64_t stored, std::uint64_t plain, std::uint32_t scheme, const std::string& damaged)
{
    if (scheme == kNoCompression) {
        if (stored != plain) throw Error(damaged + "a level holds other bytes than its size says");
        return Bytes(at, at + stored);
    }
    if (plain > stored * kLargestZstdRatio || ZSTD_getFrameContentSize(at, std::size_t(stored)) != plain)
        throw Error(damaged + "a level unpacks to another size than the file says");
    Bytes level(plain);
    const std::size_t got = ZSTD_decompress(level.data(), level.size(), at, std::size_t(stored));
    if (ZSTD_isError(got) != 0 || got != plain) throw Error(damaged + "a level does not unpack");
    return level;
}

Ktx2 decodeKtx2(const std::vector<std::uint8_t>& bytes, const std::string& what)
{
    const std::string damaged = "cannot read " + what + ": ";
    const auto demand = [&](bool holds, const char* sentence) {
        if (!holds) throw Error(damaged + sentence);
    };
    demand(bytes.size() >= sizeof kMagic && std::equal(std::begin(kMagic), std::end(kMagic), bytes.begin()), "it is not a KTX 2.0 file");
    demand(bytes.size() >= kHeaderBytes, "it is truncated");
    const auto number = [&](std::size_t index) { return get32(&bytes[sizeof kMagic + 4 * index]); };

    const std::uint32_t width = number(2), height = number(3), depth = number(4), layers = number(5), faces = number(6), levels = number(7);
    const std::uint32_t scheme = number(8), edge = std::max({width, height, depth});
    Ktx2 t;
    t.format = Ktx2Format(number(0));
    demand(texelBytes(t.format) > 0, "it has a texel format that is not read here");
    demand(number(1) == typeSize(t.format), "its type size is not that of its format");
    demand(scheme == kNoCompression || scheme == kZstd, "it is compressed by a scheme other than zstd");
    demand(width > 0 && height > 0 && edge <= kLargestEdge && layers <= kLargestLayers, "its size is out of range");
    demand(faces == 1 || (faces == 6 && width == height && depth == 0), "its faces make no cube");
    demand(depth == 0 || layers == 0, "it is an array of 3D textures, which is not read here");
    demand(levels >= 1 && levels <= 15 && (edge >> (levels - 1)) > 0, "it has more mip levels than its size");
    t.width = int(width), t.height = int(height), t.depth = int(depth), t.layers = int(layers), t.faces = int(faces);

    const Range descriptor{number(9), number(10)}, keys{number(11), number(12)};
    demand(inside({kHeaderBytes, levels * kLevelEntryBytes}, bytes.size()) && inside(descriptor, bytes.size()) &&
               inside(keys, bytes.size()),
           "it is truncated");
    demand(descriptor.length >= 44 && get32(&bytes[std::size_t(descriptor.offset)]) == descriptor.length,
           "its format descriptor is damaged");
    t.keys = readKeys(bytes.data() + keys.offset, keys.length, damaged);

    // Every range is checked before the first level is unpacked.
    std::vector<Range> ranges;
    for (std::uint32_t m = 0; m < levels; ++m) {
        const std::uint8_t* entry = &bytes[kHeaderBytes + m * kLevelEntryBytes];
        ranges.push_back({get64(entry), get64(entry + 8)});
        demand(inside(ranges.back(), bytes.size()), "it is truncated");
        demand(get64(entry + 16) == levelBytes(t, int(m)), "a level holds other bytes than its size says");
    }
    for (std::uint32_t m = 0; m < levels; ++m)
        t.levels.push_back(readLevel(bytes.data() + ranges[m].offset, ranges[m].length, levelBytes(t, int(m)), scheme, damaged));
    return t;
}

Ktx2 readKtx2(const std::filesystem::path& path) { return decodeKtx2(readFile(path), path.string()); }
}
