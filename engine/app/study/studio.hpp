// Where points are measured: a level with its bake, a device, the truths about one view of it.
#pragma once
#include "engine/app/study/judge.hpp"
#include "engine/app/study/study.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"
#include <map>

namespace afterglow
{
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
    Truth picture;
    std::optional<Truth> visibility;         // once somebody asks
    std::optional<Image> planned;            // the standard frame at rest, which every effect is left out of
    std::map<std::string, Truth> limits;     // that several sweeps share, by their words
    std::map<std::string, Edition> editions; // that several sweeps share, by what they are baked with
};

enum class Seen { radiance, displayed, visibility };

// Colour of what was drawn, or its one channel; finite, whatever a driver did; displayed values linear.
Image pictureOf(const Image& drawn, Seen seen);

Shots draw(Executor& executor, Stage& stage, const Setup& setup, const Sweep& sweep, int frames);

Seen seenIn(const Sweep& sweep);

// As draw() needs it: what gathers frames is on only where they are gathered, what is seen has its layer.
Setup drawable(Setup setup, const Sweep& sweep);

// The bake with another edition of the product, and how long that took, CPU ms.
Baked rebaked(const Studio& studio, const Setup& setup, const std::string& product, double& ms);

// The same in words: equal ones are the same bake.
std::string editionOf(const BakeOptions& options, const std::string& product);

// The standard setup with what the sweep says is given.
Setup given(const Studio& studio, const Sweep& sweep);

// By the path tracer.
Image traced(const Studio& studio, Setup setup, std::uint32_t seed);

// `kept`: the stage that serves all values of the sweep, once there is one.
Shots drawn(Studio& studio, const Sweep& sweep, const Setup& setup, int frames, std::optional<Stage>& kept, double& bakeMs);

// What the sweep is held against, and in words.
Truth truthFor(Studio& studio, const Sweep& sweep, std::optional<Stage>& kept);
std::string truthName(const Studio& studio, const Sweep& sweep);

// How many points and limits a sweep takes, for a person who waits.
std::uint64_t stepsOf(const Sweep& sweep);

// All points of a sweep, with their pictures; `advance` hears of each.
Curve measure(Studio& studio, const Sweep& sweep, const Advance& advance);
}
