// The viewer from frame to frame: `afterglow view` loops over it, a test steps through it.
#pragma once
#include "engine/app/level.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/frame/frame.hpp"
#include "engine/gpu/window.hpp"

namespace afterglow
{
// An effect as the level calls for it, and whether a person may say otherwise.
struct OfferedEffect {
    PlannedEffect called;
    bool free = false;
};

// Of what is shown all but the first is path traced, or in part.
enum class ViewMode { raster, truth, wipe, difference };

struct Viewer {
    explicit Viewer(const ViewCommand& command); // opens the window; throws Error

    // What is shown and how
    Target target;
    Settings settings;
    std::vector<OfferedEffect> effects;
    std::vector<Camera> cameras; // the level's, or one that sees all of it
    int camera = 0;              // chosen last
    Camera eye;                  // flown from there
    float speed;                 // m/s
    ViewMode look = ViewMode::raster;
    float wipe = 0.5f; // share of the width that the raster frame has

    Window window;
    Gpu gpu;
    Executor executor;
    Stage stage;
    Screen screen;
    GpuImage picture; // the last frame that was drawn whole: what goes wrong later leaves it as it is

    // What the panel tells
    FrameStats stats;                           // of the last whole frame
    std::map<std::string, double> milliseconds; // by pass, smoothed over frames so that they can be read
    std::string failure;                        // why there is no newer picture; empty: there is one
    std::vector<std::string> messages;          // of the last reload or screenshot
    std::optional<double> differs;              // mean FLIP of the difference that is shown
    bool panel = true;

    // Asked for, and done by the next frame
    bool restage = false, reload = false, save = false;

    double time = 0, looked = 0; // s since the start; when the shaders were last looked at
};

// Puts the eye where the level's camera is.
void chooseCamera(Viewer& viewer, int index);

// Does what was asked for, draws one frame and shows it with the panel.
void step(Viewer& viewer, const Controls& controls);

// view_truth.cpp: what is asked of `look`.
struct ShownPictures {
    Texture raster, truth; // radiance
    Texture displayed;     // of anything but the difference
};
void readyPaths(Viewer& viewer); // asks for a stage with paths, or says why there is none
ShownPictures drawShown(Graph& graph, Viewer& viewer);
void showDifference(Viewer& viewer, const ShownPictures& drawn); // after the run, into the picture

// view_panel.cpp: the settings of the viewer, and what it knows of the frame.
void drawPanel(Panel& panel, Viewer& viewer);
}
