// What a study leaves: study.csv for tables, study.json for machines, study.html for people; and what it prints.
#pragma once
#include "engine/app/study/study.hpp"
#include <nlohmann/json_fwd.hpp>

namespace afterglow
{
std::string csvOf(const Report& report);

// {"schema":1,"level","device","processor","threads","load","size","quick","truth_samples","truth_noise","absent":[...],
//  "subjects":[{"effect","question","reason","curves":[{"knob","unit","clock","truth","expected_slope","most","measured_slope","floor",
//  "factor","range","by_value","verdict","advice","points":[{"value","name","ms","ms_median","ms_spread","frame_ms","error","noise","flip",
//  "default","pareto"}]}]}]}
nlohmann::json jsonOf(const Report& report);

// One file with everything in it: page.html of this folder, with its style, its script, the numbers and the pictures in their places.
std::string pageOf(const Report& report);

// In Markdown; the default is bold.
std::string tablesOf(const Subject& subject);
std::string tablesOf(const Report& report);

const char* nameOf(Clock clock); // "gpu_passes", "gpu_frame", "gpu_frames", "cpu_bake", "cpu_truth", "cpu_making", "cpu_million_rays" ...
}
