// A study: for each effect and product that a level calls for, what its accuracy costs. What is swept (sweeps.cpp), what was measured
// (studio.cpp), and what is said of it (law.cpp, advice.cpp); files.cpp and page.cpp write it down.
#pragma once
#include "baker/baker.hpp"
#include "engine/frame/settings.hpp"
#include <functional>
#include <string>
#include <vector>

namespace afterglow
{
// What is kept of the light that meets a probe, of the same bake.
enum class Harmonics { order1, order2, all };

// Everything that a knob may turn.
struct Setup {
    Settings settings;  // of the frame
    BakeOptions bake;   // of the product, resolved
    TruthOptions truth; // of the path tracer
    Harmonics harmonics = Harmonics::all;
    int gathered = 0;   // frames that the picture is the mean of, as at rest; 0: single frames, as in motion
    bool moving = true; // in timed frames, so that shadow maps are drawn anew
};

struct Studio; // studio.hpp

struct Knob {
    std::function<double(const Setup&)> get;
    std::function<void(Setup&, double)> set;
};

// What an error is measured against.
enum class Held {
    limit,      // the same with the knob at its limit
    picture,    // the path-traced picture
    visibility, // path-traced ambient visibility, of the frame's layer `ao`
    hits        // what every triangle says, asked in turn: rays alone, and no picture. The law is the time's
};

// What a point costs.
enum class Clock {
    passes,   // GPU ms of the effect's own passes in one frame
    frame,    // GPU ms of one frame
    gathered, // GPU ms of all frames that the picture is the mean of
    bake,     // CPU ms of baking the product, all threads together
    truth,    // CPU ms of path tracing the picture
    making,   // CPU ms of what `made` does
    cpuRays,  // CPU ms of a million rays: ns of one
    gpuRays   // GPU ms of a million rays
};

// How the error goes with the knob, or the time where Held::hits: as its value to that power (cost-laws); absent: no power law is known.
struct Law {
    std::optional<double> slope;
    const char* text = ""; // why, in a few words
    bool most = false;     // any power below it will do
};

// What was timed where there is no picture.
struct Timing {
    double triangles = 0.0;          // of the level that was made
    std::vector<double> ms;          // of each repetition, by the sweep's clock
    std::optional<double> otherwise; // share of rays that meet something else; absent: no ray was asked
};

constexpr const char* kDrawn = "drawn"; // the knob that draws an effect, or does not

// One knob of one effect or product.
struct Sweep {
    std::string subject;        // as the plan calls the effect, or as the bake calls the product
    std::string knob;           // "steps"
    std::string unit;           // "per ray"
    std::vector<double> values; // cheapest first
    Knob turn;
    double limit = 0.0; // the knob's value in what it is held against, Held::limit alone
    Held held = Held::limit;
    Clock clock = Clock::passes;
    Law law;
    std::function<Image(const Studio&, double)> made;  // a picture that needs no frame, Clock::making
    std::function<Image(const Studio&, double)> exact; // what that one is held against, where each value has a limit of its own
    std::function<Timing(Gpu*, double)> timed;         // Held::hits; null where there is no device
    std::string product;                               // of the bake, where the subject is called otherwise
    std::function<void(Setup&)> given;                 // what else is set, in the points and in the truth
    std::function<void(Setup&)> instead;               // what else is set in the truth alone
    std::string against;                               // the limit in words, where knob and value do not say it
    std::vector<std::string> names;                    // of values that are no numbers, in their order
    bool staged = false;                               // the knob turns nothing that a stage is made of: one serves all values
    int frames = 1;                                    // that the limit is the mean of, where frames differ by their noise
    bool rays = false;                                 // only on a device with ray queries
    std::function<bool(const Device&, double)> able;   // which values a device can; absent: all
    bool displayed = false;                            // compared as displayed, not as radiance
    bool bias = false;                  // Clock::truth alone: the error is what two pictures agree on. They and the two of the
                                        // limit are traced by the same random numbers, which leaves little noise
    bool slow = false;                  // left out of a quick study, unless its subject is asked for by name
    bool relative = false;              // values and limit are shares of what the knob stands at
    double least = 0.0, quickly = 1e30; // the smallest and the largest value of a quick study
    bool inSpace = false;               // of probes: errors are those of the light in free space (probe_space.hpp)
};

// Of probes in free space, beside their mean error (baker/probe_accuracy.hpp).
struct InSpace {
    double high = 0.0, worst = 0.0; // errors: 95 of 100 are below; the largest
    double leak = 0.0;              // most light where it is dark, of the mean; NaN: nowhere is
    double bytes = 0.0;             // of all probes, unpacked
};

// One value of a knob, measured.
struct Point {
    double value = 0.0;
    std::string name;                  // of the value, as a person reads it
    double ms = 0.0;                   // lower quartile, by the sweep's clock: what else the machine does only adds
    double median = 0.0, spread = 0.0; // of the same; spread: interquartile range
    double frameMs = 0.0;              // GPU, of the whole frame; 0: none is drawn
    double error = 0.0;                // relative RMSE (judge.hpp) against the truth; RMSE of visibility and of displayed values; share
                                       // of hits that differ, NaN where there are none
    double noise = 0.0;                // what the error must be above to be told from none (judge.hpp)
    double flip = 0.0;                 // mean FLIP against the truth, NaN where there is no picture
    std::optional<InSpace> inSpace;    // where Sweep::inSpace
    bool standard = false;             // what the program does when nobody says otherwise
    bool pareto = false;               // nothing else of its chart is both faster and better
    std::vector<std::uint8_t> picture, heat; // JPEG: as displayed, and FLIP per pixel
    std::vector<std::uint8_t> reference;     // where it is not the curve's
};

// error = sqrt(floor^2 + (factor value^slope)^2), fitted in log-log.
struct Fit {
    double slope = 0.0, factor = 0.0, floor = 0.0;
    double range = 1.0; // largest value over smallest
};

struct Curve {
    Sweep sweep;
    std::vector<Point> points;
    std::optional<Fit> fit;
    std::string verdict; // the law expected, the law measured
    std::string truth;   // what it is held against, in words
    std::string advice;
    std::vector<std::uint8_t> reference; // JPEG
};

struct Subject {
    std::string name, question, reason; // the plan's, "on, ..."
    std::vector<Curve> curves;
    bool whole = true; // the device can turn every knob to every value
};

struct Report {
    std::string level, device, processor;
    double load = 0.0; // of the machine, the largest of the whole time
    int threads = 1;   // that it has
    uvec2 size{0};
    bool quick = false;
    int samples = 0; // paths a pixel of each of the two truths
    double truthNoise = 0.0;
    std::vector<Subject> subjects;
    std::vector<std::string> absent; // "fog: off, no ag_fog...", and knobs that the device cannot turn
};
}
