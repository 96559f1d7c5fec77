// What a verb is given, LEVEL or DIR: read once, whichever it is.
#pragma once
#include "engine/baked/baked.hpp"
#include <filesystem>
#include <optional>

namespace afterglow
{
struct Target {
    Scene level;                // of a plain level
    std::optional<Baked> baked; // of a baked folder
    const Scene& scene() const { return baked ? baked->scene : level; }
    const Baked* bake() const { return baked ? &*baked : nullptr; }
};

// Throws Error when the path is neither.
Target loadTarget(const std::filesystem::path& path);
}
