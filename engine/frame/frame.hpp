// The frame as one function. A Stage is a level made ready for a device and a plan; drawFrame() then draws it from any camera.
#pragma once
#include "engine/effects/antialias/antialias.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/lighting/lighting.hpp"
#include "engine/effects/occlusion/occlusion.hpp"
#include "engine/effects/reflection/reflection.hpp"
#include "engine/effects/shadow/shadow.hpp"
#include "engine/effects/toon/toon.hpp"
#include "engine/effects/truth/truth.hpp"
#include "engine/frame/plan.hpp"
#include "engine/scene/flats.hpp"
#include "engine/upload/edges.hpp"

namespace afterglow
{
// A level on the GPU with what its plan calls for, and what a frame leaves for the next.
struct Stage {
    Plan plan;
    std::unique_ptr<GpuLevel> level;
    ShadowMaps shadows;
    ShadowMethod shadowMethod = ShadowMethod::map; // one that the device can
    OcclusionMethod occlusionMethod = OcclusionMethod::automatic;
    ReflectionMethod reflectionMethod = ReflectionMethod::screen;
    float occlusionRange = 1.0f; // m
    GpuVoxels voxels;            // absent unless occlusion asks them
    FogMemory fog;
    ToonRamps ramps;
    GpuEdges edges;
    GpuBuffer marks; // of the probes that are shown; absent when none are
    Surroundings surroundings;
    Flats flats;                    // those whose effect is on
    Gathered gathered;              // by antialias; {} begins a new picture
    std::optional<dmat4> lastEye;   // View::steady of the frame before, if there was one
    bool emission = false;          // some opaque surface emits
    bool roughMetals = false;       // some opaque surface is one
    std::vector<std::string> notes; // what the picture lacks, in sentences

    // Of a stage for paths
    Memory* memory = nullptr; // null: it is none
    GpuPaths paths;
    Tracing tracing = Tracing::kernel; // one that the device can
    TracedSamples traced;
};

// `baked` null: the level alone; it is then lit by its direct light and a constant ambient from its sky. Throws Error (exit 4) when paths are
// asked for and the device traces no rays, or not by what they are to be traced.
Stage makeStage(Gpu& gpu, const Scene& scene, const Baked* baked, const Settings& settings);

// The eye of the next frame: what gathers frames asks for another sample in each.
View nextView(const Stage& stage, const Camera& camera, const Settings& settings);

// Puts an object of the level where `scene` has it now, from the next frame on: its surfaces, its shadows, what rays meet, its mirrors and
// portals, what antialiasing knows of it. The voxels that occlusion may ask, and all that is baked, keep the level as it was.
void move(Gpu& gpu, Stage& stage, const Scene& scene, uint object);

// Begins a new picture: what frames leave for the next, gathered samples and air, is forgotten.
void forget(Stage& stage);

// How many frames a written picture is the mean of.
int framesOf(const Plan& plan, const Settings& settings);

struct Pictures {
    Texture radiance;  // scene-linear, before bloom, exposure and tone curve
    Texture bloomed;   // the same after bloom: what is exposed and displayed. Without bloom it is `radiance` itself
    Texture displayed; // RGBA8, display-referred
    Layers layers;     // what radiance consists of, when the settings ask for it
};

// The same picture path traced, of a stage that was made for it: the samples so far and settings.truth.perFrame more.
Pictures drawTruth(Graph& graph, Stage& stage, const Camera& camera, const Settings& settings);

// Radiance of the one on the left and of the other on the right, shown as one picture: by one exposure. `share` of the width is the left's.
Texture drawWiped(Graph& graph, const Stage& stage, const Texture& left, const Texture& right, float share, const Settings& settings);

// Declares the frame in the graph; the caller marks the output it wants, and what it does not need is culled.
Pictures drawFrame(Graph& graph, Stage& stage, const View& view, const Settings& settings);
}
