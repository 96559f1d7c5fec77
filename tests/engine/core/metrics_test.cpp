#include "engine/core/error.hpp"
#include "engine/core/metrics.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace afterglow
{
static Image pixels(int width, std::vector<float> values)
{
    Image image(width, int(values.size()) / 3 / width, 3);
    image.pixels = std::move(values);
    return image;
}

TEST(Metrics, are_their_definitions)
{
    const Image b = pixels(2, {1, 1, 1, 2, 2, 2});
    const Image a = pixels(2, {1, 1, 1, 2, 2.5f, 2}); // one channel of six is off by 1/2
    const Difference d = difference(a, b, 1);
    EXPECT_DOUBLE_EQ(d.rmse, std::sqrt(0.25 / 6));
    EXPECT_DOUBLE_EQ(d.relativeRmse, std::sqrt(0.25 / 6) / 1.5);
    EXPECT_DOUBLE_EQ(d.relMse, 0.25 / (4 + 0.01) / 6);
    EXPECT_DOUBLE_EQ(d.psnr.value(), -10 * std::log10(0.25 / 6));
    EXPECT_DOUBLE_EQ(d.largest, 0.5);
    EXPECT_EQ(d.x, 1);
    EXPECT_EQ(d.y, 0);
    EXPECT_EQ(d.channel, 1);
    EXPECT_DOUBLE_EQ(difference(a, b, 0).psnr.value(), 10 * std::log10(4 / (0.25 / 6))); // peak: the brightest value of b
}

TEST(Metrics, of_equal_pictures_are_zero_and_have_no_psnr)
{
    const Image black = pixels(1, {0, 0, 0});
    const Difference d = difference(black, black, 0);
    EXPECT_EQ(d.rmse, 0);
    EXPECT_EQ(d.relativeRmse, 0);
    EXPECT_FALSE(d.psnr.has_value());
}

TEST(Metrics, count_what_is_not_finite_and_leave_it_out)
{
    const Difference d = difference(pixels(1, {NAN, 1, INFINITY}), pixels(1, {1, 1, 1}), 1);
    EXPECT_EQ(d.nonFinite, 2u);
    EXPECT_EQ(d.rmse, 0);
}

TEST(Metrics, of_nothing_are_refused)
{
    Image none(2, 1, 3);
    for (float& value : none.pixels) value = std::nanf("");
    EXPECT_THROW(difference(none, none, 1), Error);
    EXPECT_THROW(difference(none, Image(2, 1, 3), 0), Error);
}

TEST(Metrics, refuse_pictures_of_different_sizes) { EXPECT_THROW(difference(Image(2, 1, 3), Image(1, 2, 3), 1), Error); }
}
