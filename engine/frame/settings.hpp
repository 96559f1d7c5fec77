// Everything that one may choose about a frame: one struct, for the command line, the viewer and the tests alike.
#pragma once
#include "engine/effects/display/display.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/reflection/reflection.h"
#include "engine/effects/shadow/shadow.h"
#include <map>

namespace afterglow
{
// `--effects auto|all|none|+fog,-bloom`: what the plan would choose, unless it is said here.
struct Overrides {
    enum class Base { automatic, all, none };
    Base base = Base::automatic;
    std::map<std::string, bool> forced; // by effect
};

// Throws Error (usage) when an effect of that name does not exist.
Overrides parseOverrides(const std::string& text);

struct Settings {
    uvec2 size{kPictureSize};
    Overrides effects;
    ShadowParameters shadow = defaultShadowParameters();
    ReflectionParameters reflection = defaultReflectionParameters();
    FogParameters fog = defaultFogParameters();
    DisplayParameters display;
    bool layers = false; // the parts of the picture, too
};

// What was asked for, and what the level says of how it is shown (ag_exposure_ev, ag_tone_curve).
Settings adoptLevel(Settings asked, const Scene& scene);
}
