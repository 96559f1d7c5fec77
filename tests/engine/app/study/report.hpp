// A report made by hand, with names that a level could have.
#pragma once
#include "engine/app/study/study.hpp"
#include <cmath>

namespace afterglow
{
inline std::vector<std::uint8_t> square(std::uint8_t grey)
{
    Image8 image{8, 8, 3, std::vector<std::uint8_t>(8 * 8 * 3, grey)};
    return encodeJpeg(image, 90);
}

inline Report handMade()
{
    Report report{.level = "a </script><b>\"level\", with commas.glb", .device = "a device, by name", .processor = "a processor"};
    report.size = uvec2(8, 8), report.quick = true, report.samples = 4, report.truthNoise = 0.1;
    report.load = 5.0, report.threads = 2;
    report.absent = {"fog: off, no ag_fog_scattering"};
    Curve curve;
    curve.sweep = {.subject = "occlusion", .knob = "rays", .unit = "per pixel", .values = {1, 4, 16}, .law = {-0.5, "by lot"}};
    curve.truth = "the truth";
    curve.advice = "Take four.";
    curve.fit = Fit{-0.5, 0.1, 0.0, 16.0};
    curve.verdict = "expected rays^-0.5";
    curve.reference = square(200);
    for (double value : curve.sweep.values)
        curve.points.push_back({.value = value,
                                .name = std::to_string(int(value)),
                                .ms = value,
                                .spread = 0.1,
                                .frameMs = 10.0 + value,
                                .error = 0.1 / std::sqrt(value),
                                .flip = 0.05,
                                .standard = value == 4.0,
                                .pareto = true,
                                .picture = square(150),
                                .heat = square(20)});
    Curve named = curve;
    named.sweep.knob = "drawn", named.sweep.names = {"off", "on", "both"}, named.truth = "another truth", named.fit.reset();
    Curve timed = curve, blank;
    timed.sweep.knob = "rays by a tree", timed.sweep.held = Held::hits, timed.sweep.clock = Clock::cpuRays;
    timed.fit = Fit{1.0, 1.0, 0.0, 16.0}; // of its times
    for (Point& point : timed.points) point.picture.clear(), point.heat.clear(), point.flip = std::nan("");
    blank = timed;
    blank.sweep.knob = "raster", blank.advice.clear();
    for (Point& point : blank.points) point.error = std::nan("");
    report.subjects = {{"occlusion", "Which share?", "on, because", {curve, named}},
                       {"fog", "What air?", "on, too", {curve}},
                       {"triangles", "How many?", "on, as well", {timed, blank}}};
    return report;
}
}
