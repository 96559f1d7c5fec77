// Frames of some settings, as a moving eye sees them: small ones for what they are off by, those of the asked size for what they take.
#pragma once
#include "engine/app/level.hpp"
#include "engine/app/study/judge.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"
#include <map>

namespace afterglow
{
// A frame to be measured: of which level, by which settings, from where.
struct Sitter {
    const Target& target;
    std::filesystem::path path; // of the target
    Settings settings;          // its size is the frame's
    Camera camera;
    Executor& executor;
};

// What a pass is asked to do: equal ones take equally long.
struct PassWork {
    PipelineKey key;
    uvec3 threads{0};
    std::vector<std::uint8_t> told; // pushed and uploaded
    std::uint64_t draws = 0, triangles = 0;
    bool operator==(const PassWork&) const = default;
};

struct PassTime {
    double ms = 1e30; // the least of all frames: what others take of the machine only adds
    PassWork work;
};

struct Look {
    std::map<std::string, PassTime> passes; // of a frame at rest
    double ms = 0.0;                        // the sum of them
    double medianMs = 0.0;                  // of whole frames
    Image picture;                          // radiance, gathered as in motion
};

Stage stageOf(const Sitter& sitter, const Settings& settings);

// `frames` after one that is not counted: it compiles, uploads and draws what is kept. The picture is what the first `gathered` of them
// gather.
Look look(const Sitter& sitter, Stage& stage, const Settings& settings, int frames, int gathered);

// The size at which errors are measured: fewer pixels of the same shape.
uvec2 smallSize(uvec2 size);

// Small, against the truth: mean relative squared error, and the look.
struct Judged {
    Look look;
    double error = 0.0;
};
Judged judged(const Sitter& sitter, Stage& stage, Settings settings, const Truth& truth);

// Of the asked size, and nobody looks.
Look timed(const Sitter& sitter, Stage& stage, const Settings& settings, int frames);

// The path-traced picture at that size; of a style, which is its own truth, the frame at rest.
Truth traceTruth(const Sitter& sitter, ProgressStyle progress);
Truth styledTruth(const Sitter& sitter, Stage& stage);
}
