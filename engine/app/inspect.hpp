// `afterglow inspect DIR`: what is in a baked folder, and whether all of it is whole.
#pragma once
#include <filesystem>

namespace afterglow
{
struct InspectOptions {
    std::filesystem::path directory;
    bool json = false;
};

// Reads every file, prints to stdout. --json prints bake.json with what was counted. Throws Error when the folder
// is no bake or a file of it is damaged.
void inspect(const InspectOptions& options);
}
