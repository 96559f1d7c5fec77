#include "engine/app/compare.hpp"
#include "engine/core/error.hpp"
#include "engine/core/image.hpp"
#include "engine/core/metrics.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
static std::filesystem::path named(const std::string& name)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "compare_test";
    std::filesystem::create_directories(folder);
    return folder / name;
}

static std::string said(const CompareOptions& options)
{
    testing::internal::CaptureStdout();
    compare(options);
    const std::string text = testing::internal::GetCapturedStdout();
    return text;
}

static Image grey(float value)
{
    Image image(16, 8, 3);
    for (float& v : image.pixels) v = value;
    return image;
}

TEST(Compare, measures_radiance_in_its_own_unit)
{
    Image off = grey(2.0f);
    off.at(5, 3)[1] = 2.5f;
    writeExr(named("a.exr"), off);
    writeExr(named("b.exr"), grey(2.0f));
    const nlohmann::json result = nlohmann::json::parse(said({.a = named("a.exr"), .b = named("b.exr"), .json = true}));
    const double rmse = std::sqrt(0.25 / (16 * 8 * 3)); // one value of all is off by 1/2
    EXPECT_EQ(result["values"], "radiance");
    EXPECT_DOUBLE_EQ(result["rmse"], rmse);
    EXPECT_DOUBLE_EQ(result["relative_rmse"], rmse / 2.0);
    EXPECT_NEAR(result["psnr_db"], 20.0 * std::log10(2.0 / rmse), 1e-9);
    EXPECT_EQ(result["largest_difference"], 0.5);
    EXPECT_EQ(result["largest_at"], nlohmann::json({5, 3}));
    EXPECT_EQ(result["largest_channel"], "g");
    EXPECT_GT(result["flip"], 0.0);
}

TEST(Compare, measures_displayed_pictures_as_displayed)
{
    Image8 picture;
    picture.width = 4, picture.height = 4, picture.channels = 3;
    picture.pixels.assign(48, 51);
    writePng(named("a.png"), picture);
    picture.pixels.assign(48, 102);
    writePng(named("b.png"), picture);
    const nlohmann::json result = nlohmann::json::parse(said({.a = named("a.png"), .b = named("b.png"), .json = true}));
    EXPECT_EQ(result["values"], "displayed");
    EXPECT_NEAR(result["rmse"], 0.2, 1e-6); // (102 - 51) / 255
    EXPECT_NEAR(result["psnr_db"], -20.0 * std::log10(0.2), 1e-4);
}

TEST(Compare, of_equal_pictures_is_zero_without_a_psnr)
{
    writeExr(named("same.exr"), grey(0.5f));
    const nlohmann::json result = nlohmann::json::parse(said({.a = named("same.exr"), .b = named("same.exr"), .json = true}));
    EXPECT_EQ(result["rmse"], 0.0);
    EXPECT_EQ(result["flip"], 0.0);
    EXPECT_TRUE(result["psnr_db"].is_null());
    EXPECT_NE(said({.a = named("same.exr"), .b = named("same.exr")}).find("the pictures are equal"), std::string::npos);
}

TEST(Compare, draws_the_difference_brighter_where_it_is_larger)
{
    Image half = grey(0.2f);
    for (int y = 0; y < 8; ++y)
        for (int x = 12; x < 16; ++x) half.at(x, y)[0] = 0.8f;
    writeExr(named("half.exr"), half);
    writeExr(named("whole.exr"), grey(0.2f));
    said({.a = named("half.exr"), .b = named("whole.exr"), .heatMap = named("heat.png")});
    const Image heat = readImage(named("heat.png"));
    EXPECT_EQ(heat.width, 16);
    EXPECT_GT(heat.at(15, 4)[1], heat.at(0, 4)[1]);
}

TEST(Compare, refuses_what_cannot_be_compared)
{
    writeExr(named("small.exr"), Image(4, 4, 3));
    writeExr(named("large.exr"), Image(8, 4, 3));
    writePng(named("shown.png"), encodeSrgb(Image(4, 4, 3)));
    EXPECT_THROW(compare({.a = named("small.exr"), .b = named("large.exr")}), Error);
    EXPECT_THROW(compare({.a = named("small.exr"), .b = named("shown.png")}), Error);
    EXPECT_THROW(compare({.a = named("absent.exr"), .b = named("small.exr")}), Error);
}
}
