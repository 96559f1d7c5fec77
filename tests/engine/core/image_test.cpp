#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/image.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
static std::filesystem::path named(const std::string& name)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "image_test";
    std::filesystem::create_directories(folder);
    return folder / name;
}

// Values that a half holds exactly: multiples of 1/64 below 32.
static Image ramp(int width, int height, int channels)
{
    Image image(width, height, channels);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = float(i * 37 % 2048) / 64.0f;
    return image;
}

TEST(Image, comes_back_from_exr_as_it_was)
{
    for (int channels : {3, 4}) {
        const Image image = ramp(33, 17, channels);
        writeExr(named("ramp.exr"), image);
        const Image back = readImage(named("ramp.exr"));
        EXPECT_EQ(back.width, 33);
        EXPECT_EQ(back.height, 17);
        EXPECT_EQ(back.channels, channels);
        EXPECT_EQ(back.pixels, image.pixels);
    }
    EXPECT_FALSE(std::filesystem::exists(named("ramp.exr.tmp")));
}

TEST(Image, beyond_half_s_range_is_kept_in_floats)
{
    Image image(2, 1, 3);
    image.pixels = {1e5f, 1, 2, 3, 4, 0.1f};
    writeExr(named("bright.exr"), image);
    EXPECT_EQ(readImage(named("bright.exr")).pixels, image.pixels);
}

TEST(Image, on_disk_is_finite)
{
    Image image(1, 1, 3);
    image.pixels = {NAN, INFINITY, -INFINITY};
    writeExr(named("wild.exr"), image);
    EXPECT_EQ(readImage(named("wild.exr")).pixels, (std::vector<float>{0, 65504, -65504}));
    writeExr(named("wild.hdr"), image);
    for (float v : readImage(named("wild.hdr")).pixels) EXPECT_TRUE(std::isfinite(v));
    EXPECT_EQ(encodeSrgb(image).pixels, (std::vector<std::uint8_t>{0, 255, 0}));
}

TEST(Image, of_one_channel_reads_as_grey_and_a_layer_by_its_name)
{
    writeExr(named("grey.exr"), ramp(4, 4, 1));
    const Image grey = readImage(named("grey.exr"));
    ASSERT_EQ(grey.channels, 3);
    EXPECT_EQ(grey.at(1, 0)[0], 37.0f / 64.0f);
    EXPECT_EQ(grey.at(1, 0)[2], 37.0f / 64.0f);

    writeLayers(named("layers.exr"), {{"beauty", ramp(4, 4, 3)}, {"depth", ramp(4, 4, 1), /* exact= */ true}});
    EXPECT_EQ(readImage(named("layers.exr")).pixels, ramp(4, 4, 3).pixels);
}

TEST(Image, survives_png_to_the_byte)
{
    Image8 image;
    image.width = 16, image.height = 16, image.channels = 4;
    for (int i = 0; i < 1024; ++i) image.pixels.push_back(std::uint8_t(i));
    const std::vector<std::uint8_t> png = encodePng(image);
    EXPECT_EQ(decodeImage8(png.data(), png.size(), "test").pixels, image.pixels);

    // readImage decodes to linear and encodeSrgb is its inverse, alpha untouched.
    writePng(named("all.png"), image);
    EXPECT_EQ(encodeSrgb(readImage(named("all.png"))).pixels, image.pixels);
}

TEST(Image, as_jpeg_is_smaller_and_looks_the_same)
{
    Image smooth(64, 64, 3);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c) smooth.at(x, y)[c] = 0.5f + 0.4f * std::sin(0.1f * float(x + c * y));
    const Image8 image = encodeSrgb(smooth);
    const std::vector<std::uint8_t> jpeg = encodeJpeg(image, 92);
    EXPECT_LT(jpeg.size(), encodePng(image).size());
    const Image8 back = decodeImage8(jpeg.data(), jpeg.size(), "test"); // with an alpha of 255
    double squares = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double apart = double(image.pixels[i]) - double(back.pixels[i / 3 * 4 + i % 3]);
        squares += apart * apart / double(image.pixels.size());
    }
    EXPECT_LT(std::sqrt(squares), 2.0); // steps of 255
}

TEST(Image, in_hdr_is_within_rgbe_s_step)
{
    const Image image = ramp(32, 8, 3);
    writeExr(named("ramp.hdr"), image);
    const Image back = readImage(named("ramp.hdr"));
    for (int i = 0; i < 256; ++i) {
        const float* p = &image.pixels[std::size_t(i) * 3];
        const float step = std::fmax(p[0], std::fmax(p[1], p[2])) / 128.0f; // eight bits of the largest channel, truncated
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.pixels[std::size_t(i) * 3 + std::size_t(c)], p[c], step);
    }
}

static void expectRefused(const std::filesystem::path& path) { EXPECT_THROW(readImage(path), Error) << path; }

TEST(Image, missing_foreign_or_cut_is_refused_with_a_sentence)
{
    for (const char* name : {"absent.exr", "absent.hdr", "absent.png"}) expectRefused(named(name));
    writeExr(named("whole.exr"), ramp(64, 64, 3));
    writeExr(named("whole.hdr"), ramp(64, 64, 3));
    writePng(named("whole.png"), encodeSrgb(ramp(64, 64, 3)));
    for (const char* kind : {".exr", ".hdr", ".png"}) {
        const std::vector<std::uint8_t> whole = readFile(named(std::string("whole") + kind));
        const std::filesystem::path cut = named(std::string("cut") + kind);
        writeFile(cut, whole.data(), 20);
        expectRefused(cut);
        writeText(cut, "this is not a picture, whatever its name says");
        expectRefused(cut);
        if (std::string(kind) == ".hdr") continue; // stb fills what is missing with black
        writeFile(cut, whole.data(), whole.size() / 2);
        expectRefused(cut);
    }
    writeText(named("picture.txt"), "text");
    expectRefused(named("picture.txt"));
}

TEST(Image, larger_than_16384_on_a_side_is_refused_before_it_is_read)
{
    // PNG header of 20000 x 1
    const std::uint8_t header[] = {0x89, 'P',  'N',  'G', 13, 10, 26, 10, 0, 0, 0, 13, 'I', 'H', 'D', 'R', 0,
                                   0,    0x4e, 0x20, 0,   0,  0,  1,  8,  2, 0, 0, 0,  0,   0,   0,   0};
    EXPECT_THROW(decodeImage8(header, sizeof header, "wide"), Error);
}
}
