// The tables of a study in the READMEs of the effects, between <!-- study LEVEL --> and <!-- end of study -->: `study LEVEL --readmes` puts
// them there, `./run study` does it for all levels that they name.
#pragma once
#include "engine/app/study/study.hpp"
#include <filesystem>

namespace afterglow
{
// How the READMEs call a level: its path from where the effects lie, however the command line spells it.
std::string nameInReadmes(const std::filesystem::path& level);

// The README with `tables` as its study of the level; nothing where it holds none of that level. Throws Error where one has no end.
std::optional<std::string> withStudy(const std::string& readme, const std::string& level, const std::string& tables);

// Puts each subject's tables into its README below `effects`, where there is one that names this level, and returns those that it wrote.
// Tables that the device cannot print whole leave theirs as it is, and a sentence says so.
std::vector<std::filesystem::path> writeReadmes(const std::filesystem::path& effects, const std::string& level, const Report& report);
}
