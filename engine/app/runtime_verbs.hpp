// The verbs that draw, or say what would be drawn; as verbs.hpp does for those that bake.
#pragma once
#include "engine/core/progress.hpp"
#include "engine/frame/settings.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace afterglow
{
struct RenderCommand {
    std::filesystem::path target;   // level or baked folder
    std::filesystem::path output;   // .png: as displayed; .exr: scene-linear radiance
    std::string camera;             // name or index, empty: the first
    Settings settings;              // what was said; adoptLevel() adds what the level says
    int frames = 0;                 // that the picture is the mean of; each is timed. 0: as many as antialiasing asks for
    std::filesystem::path layers;   // .exr with the parts of the picture, empty: none
    std::filesystem::path stats;    // JSON, empty: none
    std::string device;             // name or index, empty: the best
    std::optional<double> budgetMs; // of a frame: what is drawn is chosen so that it fits
    ProgressStyle progress = ProgressStyle::automatic; // of path tracing, and of what the choice measures
};
void renderVerb(const RenderCommand& command);

struct ViewCommand {
    std::filesystem::path target; // level or baked folder
    std::string camera;           // name or index, empty: the first
    Settings settings;
    std::string device; // name or index, empty: the best
    int frames = 0;     // closes by itself after so many; 0: when the person closes it
};
void viewVerb(const ViewCommand& command);

struct PlanCommand {
    std::filesystem::path target;
    Settings settings;
    bool json = false;
    std::optional<double> milliseconds; // of a frame, from `camera` on `device`: what fits is planned
    std::string camera, device;
    ProgressStyle progress = ProgressStyle::automatic;
};
void planVerb(const PlanCommand& command); // needs no device but for milliseconds

struct GraphCommand {
    std::filesystem::path target;
    std::string camera;
    Settings settings;
    bool dot = false;
    std::string device;
};
void graphVerb(const GraphCommand& command);

struct StudyCommand {
    std::filesystem::path target;     // level, which is baked first, or baked folder
    std::filesystem::path directory;  // of study.csv, study.json and study.html
    std::vector<std::string> effects; // empty: all that the level calls for
    std::string camera;
    bool quick = false;
    bool readmes = false;       // the effects' own are written, too (study/readme.hpp)
    std::optional<uvec2> size;  // of every picture
    std::optional<int> samples; // paths a pixel of each of the two truths
    std::string device;
    ProgressStyle progress = ProgressStyle::automatic;
};
void studyVerb(const StudyCommand& command);
}
