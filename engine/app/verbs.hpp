// What each verb of the command line does, as plain functions of plain options; the words themselves are parsed in cli.cpp.
// Each throws Error; results go to stdout.
#pragma once
#include "baker/baker.hpp"
#include <filesystem>
#include <string>

namespace afterglow
{
struct BakeCommand {
    std::filesystem::path level, directory;
    BakeOptions options;
    ProgressStyle progress = ProgressStyle::automatic;
};
void bakeVerb(const BakeCommand& command);

struct TruthCommand {
    std::filesystem::path level, output;
    std::string camera; // name or index, empty: the first
    TruthOptions options;
    ProgressStyle progress = ProgressStyle::automatic;
};
void truthVerb(const TruthCommand& command);

struct ProbeCommand {
    std::filesystem::path target; // level or baked folder
    std::filesystem::path points, output;
    bool truth = false;
    int samples = 1024;
    std::uint32_t seed = 1;
    int threads = 0;
    ProgressStyle progress = ProgressStyle::automatic;
};
void probeVerb(const ProbeCommand& command);
}
