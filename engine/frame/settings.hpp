// Everything that one may choose about a frame: one struct, for the command line, the viewer and the tests alike.
#pragma once
#include "engine/effects/bloom/bloom.h"
#include "engine/effects/display/display.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/occlusion/occlusion.hpp"
#include "engine/effects/outline/outline.h"
#include "engine/effects/portal/portal.h"
#include "engine/effects/probe_view/probe_view.h"
#include "engine/effects/reflection/reflection.hpp"
#include "engine/effects/shadow/shadow.hpp"
#include "engine/effects/toon/toon.h"
#include "engine/effects/truth/truth.hpp"
#include <map>
#include <optional>

namespace afterglow
{
struct ProbeTree;

// `--effects auto|all|none|+fog,-bloom`: what the plan would choose, unless it is said here.
struct Overrides {
    enum class Base { automatic, all, none };
    Base base = Base::automatic;
    std::map<std::string, bool> forced; // by effect
};

// Throws Error (usage) when an effect of that name does not exist.
Overrides parseOverrides(const std::string& text);

enum class Mode {
    raster,
    truth, // path traced, where the device has ray queries or ray programs
    both   // a stage for either: a viewer compares them
};

struct Settings {
    uvec2 size{kPictureSize}; // of the picture that is shown
    float renderScale = 1.0f; // 0.25 .. 1: the frame is drawn at this share of its width and height, and brought to size (upscale)
    float lodError = 0.25f;   // px: how far from its place a coarser surface may be drawn (lods)
    Overrides effects;
    std::map<std::string, std::string> said; // knobs that the command line turned, if only to where they stood, and of which effect
    Mode mode = Mode::raster;
    TruthParameters truth = defaultTruthParameters();
    Tracing tracing = Tracing::automatic;
    ShadowMethod shadowMethod = ShadowMethod::map; // ray: where the device has ray queries
    ShadowParameters shadow = defaultShadowParameters();
    OcclusionMethod occlusionMethod = OcclusionMethod::automatic;
    OcclusionParameters occlusion = defaultOcclusionParameters();
    PortalParameters portal = defaultPortalParameters();
    ReflectionMethod reflectionMethod = ReflectionMethod::screen;
    ReflectionParameters reflection = defaultReflectionParameters();
    FogParameters fog = defaultFogParameters();
    BloomParameters bloom = defaultBloomParameters();
    ToonParameters toon = defaultToonParameters();
    OutlineParameters outline = defaultOutlineParameters();
    std::optional<float> occlusionRange; // m; absent: occlusionRange()
    // As the level says, where they are absent
    std::optional<uint> toonSteps;
    std::optional<float> outlineWidth;
    DisplayParameters display;
    uint show = kShowNothing; // of the probes, in the place of a picture or in it
    bool layers = false;      // the parts of the picture, too
};

// What was asked for, and what the level says of how it is shown (ag_bloom, ag_exposure_ev, ag_tone_curve, ag_outline_px ...).
Settings adoptLevel(Settings asked, const Scene& scene);

// How far occlusion looks, m. What stands farther apart than probes hides light from them, too: it is not to be counted once more. Null: no
// probes light the frame.
float occlusionRange(const Settings& settings, const ProbeTree* probes);
}
