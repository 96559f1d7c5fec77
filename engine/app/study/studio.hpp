// Where points are measured: a level with its bake, a device, the truths about one view of it.
#pragma once
#include "baker/probe_accuracy.hpp"
#include "engine/app/study/judge.hpp"
#include "engine/app/study/study.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"
#include <map>

namespace afterglow
{
constexpr std::uint32_t kSeedA = 101, kSeedB = 202; // of what is traced, independent of each other and of the picture's

// Frames of one setting. Single frames are as many pictures, each with its own noise; gathered ones are a single picture.
struct Shots {
    std::vector<Image> pictures;
    std::vector<double> ms, frameMs; // by the sweep's clock; of whole frames
};

// Frames of another bake, and the CPU ms that its product took.
struct Edition {
    Shots shots;
    double ms = 0.0;
};

// The light in free space: at points by chance, and in a slice through the level, for the eye.
struct Space {
    LitPoints lit;
    std::vector<ProbePoint> slice; // row by row
    std::vector<bool> inside;      // of it: in solids, drawn black
    ivec2 size{0};                 // of the slice, px
    Truth truth;                   // of its picture
};

// What the probes of a bake say there, by what is kept of each.
struct SpaceTaken {
    struct Said {
        ProbeAccuracy accuracy;
        double bytes = 0.0;
        Image picture; // of the slice
    };
    double ms = 0.0; // CPU, of the bake
    ProbeTree probes;
    std::map<Harmonics, Said> said{};
};

struct Studio {
    Studio(const Scene& scene, const Baked& bake, const std::string& device)
        : level(scene), baked(bake), gpu(deviceOptions(device)), executor(gpu)
    {
    }
    const Scene& level;
    const Baked& baked;
    Gpu gpu;
    Executor executor;
    Setup standard; // what the program does when nobody says otherwise
    Camera camera;
    int frames = 5; // that are timed
    bool quick = false;
    Truth picture;
    std::optional<Truth> visibility;              // once somebody asks
    std::optional<Image> planned;                 // the standard frame at rest, which every effect is left out of
    std::map<std::string, Truth> limits;          // that several sweeps share, by their words
    std::optional<Space> space;                   // once somebody asks
    std::map<std::string, SpaceTaken> spaceTaken; // by what is baked
    std::map<std::string, Edition> editions;      // that several sweeps share, by what they are baked with
};

enum class Seen { radiance, displayed, visibility };

// Colour of what was drawn, or its one channel; finite, whatever a driver did; displayed values linear.
Image pictureOf(const Image& drawn, Seen seen);

// A setting that sits for its frames one by one: several take turns, so that what else the machine does falls on all of them alike.
struct Sitting {
    Setup setup;                // as drawable() has it
    int frames = 0;             // that are timed
    Stage* stage = nullptr;     // that others use as well
    std::optional<Stage> own{}; // instead
    int next = kFirst;          // frame
    double warmMs = 0;          // that the device has worked before
    Shots shots{};
    std::unique_ptr<Executor> past{}; // with its own frames to go on from, where others are drawn in between
    static constexpr int kFirst = -1; // the frame that compiles, uploads and fills caches is not timed
    // Nor are those after it until the device has worked for so long: an idle GPU clocks itself down. Experiment: on an Nvidia H100 one
    // frame took 8.5 ms at the beginning of a study and 2.5 ms at its end.
    static constexpr double kWarmMs = 200.0;
};
bool isOver(const Sitting& sitting);
void warmUp(Sitting& sitting, double ms); // by a frame of so many ms that is not timed: `next` is that frame again until it is enough
void sit(Executor& executor, Sitting& sitting, const Sweep& sweep);

// All frames of one, after each other.
Shots draw(Executor& executor, Stage& stage, const Setup& setup, const Sweep& sweep, int frames);

Seen seenIn(const Sweep& sweep);

// As draw() needs it: what gathers frames is on only where they are gathered, what is seen has its layer.
Setup drawable(Setup setup, const Sweep& sweep);

// The bake with another edition of the product, and how long that took, CPU ms.
Baked rebaked(const Studio& studio, const Setup& setup, const std::string& product, double& ms);

// The same in words: equal ones are the same bake.
std::string editionOf(const BakeOptions& options, const std::string& product);

// Whether the sweep's points take turns: those that are frames of one bake.
bool takesTurns(const Sweep& sweep);

// The standard setup with what the sweep says is given.
Setup given(const Studio& studio, const Sweep& sweep);

// By the path tracer.
Image traced(const Studio& studio, Setup setup, std::uint32_t seed);

// Frames of the bake that the setup asks for, and what its product took, CPU ms.
Shots baked(Studio& studio, const Sweep& sweep, const Setup& setup, double& ms);

// What the sweep is held against, and in words. `kept`: the stage that serves all values of the sweep, once there is one.
Truth truthFor(Studio& studio, const Sweep& sweep, std::optional<Stage>& kept);
std::string truthName(const Studio& studio, const Sweep& sweep);

// How many points and limits a sweep takes, for a person who waits.
std::uint64_t stepsOf(const Sweep& sweep);

// A value of a sweep, named, before it is measured. `standard`: where the knob stands.
Point pointOf(const Sweep& sweep, std::size_t index, double standard);

// How a point looks beside its truth, both linear 0..1: its picture, its heat, its FLIP.
void lookAt(Point& point, const Image& picture, const Image& truth);
std::vector<std::uint8_t> jpegOf(const Image& shown);

// All points of a sweep, with their pictures; `advance` hears of each.
Curve measure(Studio& studio, const Sweep& sweep, const Advance& advance);
}
