#include "engine/baked/bytes.hpp"
#include "engine/baked/ktx2.hpp"
#include "engine/core/error.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static Ktx2 filled(Ktx2 texture, int levels)
{
    unsigned state = 1;
    for (int m = 0; m < levels; ++m) {
        Bytes level(std::size_t(levelBytes(texture, m)));
        for (std::uint8_t& byte : level) byte = std::uint8_t((state = state * 1664525u + 1013904223u) >> 24);
        texture.levels.push_back(std::move(level));
    }
    return texture;
}

static Ktx2 cube()
{
    return filled({.format = Ktx2Format::rgba16f, .width = 8, .height = 8, .faces = 6, .keys = {{"ag_name", "hall"}}}, 4);
}

static void expectEqual(const Ktx2& a, const Ktx2& b)
{
    EXPECT_EQ(a.format, b.format);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.layers, b.layers);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.levels, b.levels);
}

TEST(Ktx2, comes_back_to_the_bit_in_every_format_and_shape)
{
    for (Ktx2Format format :
         {Ktx2Format::r8, Ktx2Format::rgba8, Ktx2Format::srgba8, Ktx2Format::rgba16f, Ktx2Format::rgba32f, Ktx2Format::rgb9e5}) {
        const Ktx2 shapes[] = {filled({.format = format, .width = 13, .height = 5}, 1),
                               filled({.format = format, .width = 16, .height = 8, .layers = 3}, 5),
                               filled({.format = format, .width = 3, .height = 4, .depth = 14}, 1),
                               filled({.format = format, .width = 8, .height = 8, .faces = 6}, 4)};
        for (const Ktx2& texture : shapes) expectEqual(decodeKtx2(encodeKtx2(texture), "test"), texture);
    }
}

TEST(Ktx2, keeps_its_keys_and_signs_itself)
{
    const Ktx2 back = decodeKtx2(encodeKtx2(cube()), "test");
    EXPECT_EQ(back.keys.at("ag_name"), "hall");
    EXPECT_EQ(back.keys.at("KTXwriter").find("afterglow "), 0u);
}

// Sections 3.1 to 3.11 of the KTX 2.0 specification, byte by byte.
TEST(Ktx2, is_laid_out_as_the_specification_says)
{
    const Bytes file = encodeKtx2(cube());
    const std::uint8_t magic[] = {0xAB, 0x4B, 0x54, 0x58, 0x20, 0x32, 0x30, 0xBB, 0x0D, 0x0A, 0x1A, 0x0A};
    EXPECT_TRUE(std::equal(std::begin(magic), std::end(magic), file.begin()));
    const std::uint32_t header[] = {97, 2, 8, 8, 0, 0, 6, 4, 2}; // format, type size, width, height, depth, layers, faces, levels, zstd
    for (std::size_t i = 0; i < std::size(header); ++i) EXPECT_EQ(get32(&file[12 + 4 * i]), header[i]) << i;

    const std::uint32_t descriptorAt = get32(&file[48]), descriptorBytes = get32(&file[52]), keysAt = get32(&file[56]),
                        keysBytes = get32(&file[60]);
    EXPECT_EQ(descriptorAt, 80u + 24u * 4u);
    EXPECT_EQ(descriptorBytes, 4u + 24u + 16u * 4u);
    EXPECT_EQ(keysAt, descriptorAt + descriptorBytes);
    EXPECT_EQ(keysAt % 4, 0u);
    EXPECT_EQ(get64(&file[64]), 0u); // no global data
    EXPECT_EQ(get64(&file[72]), 0u);

    // Levels lie one after the other from the smallest to the largest, up to the end of the file.
    std::uint64_t at = keysAt + keysBytes;
    for (std::size_t m = 4; m-- > 0;) {
        EXPECT_EQ(get64(&file[80 + 24 * m]), at) << m;
        at += get64(&file[88 + 24 * m]);
        EXPECT_EQ(get64(&file[96 + 24 * m]), 6u * (8u >> m) * (8u >> m) * 8u);
    }
    EXPECT_EQ(at, file.size());

    // Keys are sorted, each entry is its length, key, 0, value, 0, padded to four bytes.
    std::string last;
    for (std::size_t k = keysAt; k < keysAt + keysBytes; k += (4 + get32(&file[k]) + 3) / 4 * 4) {
        const std::string key = reinterpret_cast<const char*>(&file[k + 4]);
        EXPECT_LT(last, key);
        last = key;
    }
}

// The table of VK_FORMAT_E5B9G9R9_UFLOAT_PACK32 in the Data Format Specification: mantissa and exponent, three times.
TEST(Ktx2, describes_the_shared_exponent)
{
    const Bytes file = encodeKtx2(filled({.format = Ktx2Format::rgb9e5, .width = 2, .height = 2}, 1));
    const std::uint8_t* at = &file[get32(&file[48])];
    const std::uint32_t expected[] = {4 + 24 + 6 * 16, 0, (24 + 6 * 16) << 16 | 2, 1 << 16 | 1 << 8 | 1, 0, 4, 0};
    for (std::size_t i = 0; i < std::size(expected); ++i) EXPECT_EQ(get32(at + 4 * i), expected[i]) << i;
    for (std::uint32_t c = 0; c < 3; ++c) {
        const std::uint8_t* sample = at + 28 + 32 * c;
        EXPECT_EQ(get32(sample), c << 24 | 8u << 16 | 9 * c);
        EXPECT_EQ(get32(sample + 8), 0u);
        EXPECT_EQ(get32(sample + 12), 8448u);
        EXPECT_EQ(get32(sample + 16), (0x20u | c) << 24 | 4u << 16 | 27u);
        EXPECT_EQ(get32(sample + 24), 15u);
        EXPECT_EQ(get32(sample + 28), 31u);
    }
}

TEST(Ktx2, cut_anywhere_is_refused)
{
    const Bytes file = encodeKtx2(cube());
    for (std::size_t size = 0; size < file.size(); size += size < 512 ? 1 : 64)
        EXPECT_THROW(decodeKtx2(Bytes(file.begin(), file.begin() + std::ptrdiff_t(size)), "test"), Error) << size;
}

TEST(Ktx2, with_a_flipped_bit_is_refused_or_read_never_worse)
{
    const Bytes file = encodeKtx2(cube());
    const std::size_t levels = get32(&file[56]) + get32(&file[60]);
    std::size_t refused = 0, inLevels = 0;
    for (std::size_t bit = 0; bit < 8 * file.size(); bit += bit < 8 * levels ? 1 : 7) {
        Bytes flipped = file;
        flipped[bit / 8] ^= std::uint8_t(1u << (bit % 8));
        try {
            const Ktx2 texture = decodeKtx2(flipped, "test");
            for (std::size_t m = 0; m < texture.levels.size(); ++m) EXPECT_EQ(texture.levels[m].size(), levelBytes(texture, int(m)));
            EXPECT_LT(bit, 8 * levels) << "a level carries a checksum";
        } catch (const Error&) {
            ++refused;
        }
        inLevels += bit >= 8 * levels ? 1 : 0;
    }
    EXPECT_GE(refused, inLevels);
}

TEST(Ktx2, that_claims_what_it_cannot_hold_is_refused_before_allocation)
{
    const Bytes file = encodeKtx2(filled({.format = Ktx2Format::rgba8, .width = 4, .height = 4}, 1));
    const auto refused = [&](std::size_t offset, std::uint64_t number, std::size_t bytes) {
        Bytes changed = file;
        for (std::size_t i = 0; i < bytes; ++i) changed[offset + i] = std::uint8_t(number >> (8 * i));
        EXPECT_THROW(decodeKtx2(changed, "test"), Error) << "offset " << offset << " = " << number;
    };
    for (std::size_t field = 0; field < 13; ++field) refused(12 + 4 * field, 0xFFFFFFFFu, 4);
    for (std::size_t field = 0; field < 3; ++field) refused(80 + 8 * field, 0xFFFFFFFFFFFFFFFFu, 8);
    refused(80, file.size(), 8); // one byte past the end

    // All sizes agree with each other, at 1 GiB, and forty bytes are there.
    Bytes lying = file;
    for (std::size_t i = 0; i < 4; ++i) lying[20 + i] = lying[24 + i] = std::uint8_t(16384u >> (8 * i));
    for (std::size_t i = 0; i < 8; ++i) lying[96 + i] = std::uint8_t((std::uint64_t(16384) * 16384 * 4) >> (8 * i));
    EXPECT_THROW(decodeKtx2(lying, "test"), Error);
}

TEST(Ktx2, names_the_file_and_what_is_wrong)
{
    try {
        decodeKtx2({'G', 'I', 'F', '8'}, "folder/light.ktx2");
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot read folder/light.ktx2: it is not a KTX 2.0 file");
        EXPECT_EQ(error.exit, Exit::badInput);
    }
}
}
