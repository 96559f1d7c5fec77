// What a bake's result depends on, as one text: two bakes of the same key are the same bits.
#pragma once
#include "baker/baker.hpp"

namespace afterglow
{
// SHA-256, over the level's bytes and those of every file that it names, every option but those that only say how the work is done, and the
// program. Throws Error when the level cannot be read.
std::string bakeKey(const std::filesystem::path& level, const BakeOptions& options);

// Whether the bake of that key stands there already, with every file as it was written.
bool holdsBake(const std::filesystem::path& directory, const std::string& key);
}
