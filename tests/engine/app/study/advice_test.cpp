// What is said of curves whose points are put in: no harm is hidden, and nothing is said of noise.
#include "engine/app/study/advice.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
struct Row {
    const char* name;
    double ms, error, noise = 0.0;
};

// The default is the one that bears the name.
Curve curveOf(const std::vector<Row>& rows, const std::string& standard, bool named = false)
{
    Curve curve;
    curve.sweep = {.subject = "fog", .knob = "steps"};
    double value = 1.0;
    for (const Row& row : rows) {
        curve.sweep.values.push_back(value);
        if (named) curve.sweep.names.push_back(row.name);
        curve.points.push_back(
            {.value = value, .name = row.name, .ms = row.ms, .error = row.error, .noise = row.noise, .standard = row.name == standard});
        value *= 2.0;
    }
    return curve;
}

std::string said(const Curve& curve) { return adviceOf(curve, {&curve}); }

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
}

TEST(StudyAdvice, says_what_less_and_more_would_buy)
{
    EXPECT_EQ(said(curveOf({{"1", 1, 0.4}, {"2", 2, 0.2}, {"4", 4, 0.1}}, "2")),
              "The default, steps 2, costs 2 ms for an error of 20 %; steps 1 saves 50 % of the time for 2 times the error; steps 4 takes "
              "2 times "
              "the time for 0.5 times the error.");
    EXPECT_TRUE(holds(said(curveOf({{"2", 2, 0.2}, {"4", 2.01, 0.1}}, "2")), "steps 4 takes as long for 0.5 times the error"));
    EXPECT_TRUE(holds(said(curveOf({{"2", 2, 0.2}, {"4", 3, 0.19}}, "2")), "steps 4 gains little"));
}

TEST(StudyAdvice, does_not_call_it_little_what_is_harm)
{
    EXPECT_TRUE(holds(said(curveOf({{"2", 2, 0.2}, {"4", 3, 0.3}}, "2")), "steps 4 is worse: 30 %"));
    EXPECT_TRUE(
        holds(said(curveOf({{"1", 1.9, 0.18}, {"2", 2, 0.2}}, "2")), "steps 1 is a little faster and better: 1.9 ms for an error of 18 %"));
    EXPECT_TRUE(holds(said(curveOf({{"1", 1.9, 0.3}, {"2", 2, 0.2}}, "2")), "steps 1 saves little and is worse"));
    EXPECT_TRUE(holds(said(curveOf({{"1", 1, 0.2}, {"2", 2, 0.2}}, "2")), "steps 1 is better here: 1 ms for an error of 20 %"));
}

TEST(StudyAdvice, compares_options_without_an_order_with_all_of_them)
{
    const std::string text = said(curveOf({{"a", 2, 0.2}, {"b", 3, 0.1}, {"c", 1, 0.3}}, "a", true));
    EXPECT_TRUE(holds(text, "steps b takes 1.5 times the time for 0.5 times the error")) << text;
    EXPECT_TRUE(holds(text, "steps c takes 0.5 times the time for 1.5 times the error")) << text;
    EXPECT_TRUE(holds(said(curveOf({{"a", 2, 0.2}, {"b", 3, 0.1}, {"c", 1, 0.1}}, "a", true)), "steps c is better here"))
        << "the last, too";
}

TEST(StudyAdvice, knows_the_truth_when_it_sees_it)
{
    const std::string truth = " takes 1.3 times the time for no error: its picture is the truth.";
    EXPECT_TRUE(holds(said(curveOf({{"three channels", 10, 0.0033}, {"three wavelengths", 13, 0}}, "three channels", true)),
                      "steps three wavelengths" + truth));
    EXPECT_TRUE(holds(said(curveOf({{"2", 10, 0.2}, {"4", 13, 0}}, "2")), "steps 4" + truth));
}

TEST(StudyAdvice, finds_nothing_in_noise)
{
    const std::string text = said(curveOf({{"1", 1, 0.09, 0.1}, {"2", 2, 0.05, 0.1}, {"4", 4, 0.07, 0.1}}, "2"));
    EXPECT_EQ(text, "No error here is above the noise of what it is held against.");
    const std::string one = said(curveOf({{"1", 1, 0.4, 0.1}, {"2", 2, 0.05, 0.1}, {"4", 4, 0.01, 0.1}}, "2"));
    EXPECT_TRUE(holds(one, "costs 2 ms for an error of less than can be told (noise 10 %)")) << one;
    EXPECT_TRUE(holds(one, "steps 1 saves 50 % of the time for 4 times the error")) << one;
    EXPECT_TRUE(holds(one, "what steps 4 gains cannot be told")) << one;
    const std::string more = said(curveOf({{"1", 1, 0.40, 0.1}, {"2", 2, 0.205, 0.1}, {"4", 4, 0.200, 0.1}}, "2"));
    EXPECT_TRUE(holds(more, "what steps 4 gains cannot be told")) << more;
}

TEST(StudyAdvice, says_of_an_effect_whether_it_helps_or_harms)
{
    const auto drawn = [](double off, double on, double noise) {
        Curve curve = curveOf({{"off", 1, off, noise}, {"on", 2, on, noise}}, "on", true);
        curve.sweep.knob = kDrawn;
        return said(curve);
    };
    EXPECT_EQ(drawn(0.5, 0.2, 0.1), "It costs 1 ms of a frame, and the picture needs it: the error is 50 % without it, 20 % with it.");
    EXPECT_TRUE(holds(drawn(0.22, 0.2, 0.01), "brings the picture a little nearer to the truth"));
    EXPECT_TRUE(holds(drawn(0.2, 0.3, 0.1), "from this camera the picture is worse with it"));
    EXPECT_TRUE(holds(drawn(0.2, 0.19, 0.1), "nothing can be told of what it brings"));
}

TEST(StudyAdvice, prints_no_error_as_none_that_is_one)
{
    const Sweep sweep;
    EXPECT_EQ(spokenError(sweep, {.error = 1.2e-5}), "0.001 %");
    EXPECT_EQ(spokenError(sweep, {.error = 1e-7}), "below 0.001 %");
    EXPECT_EQ(spokenError(sweep, {.error = 0.0}), "less than can be told");
    EXPECT_EQ(spokenError(sweep, {.error = 0.02, .noise = 0.051}), "less than can be told (noise 5.1 %)");
}
}
