// Inside of the budget: curves of earlier runs, in files of their own.
#pragma once
#include "engine/app/budget/curves.hpp"

namespace afterglow
{
// All that curves depend on, in words: device, level, camera, size, settings, what is offered, version of the program.
std::string keyOf(const Sitter& sitter, const std::vector<Group>& offered);

// Where curves are kept; empty when nobody says where.
std::filesystem::path cacheFolder();

// Nothing when there are none by that key, or what is there cannot be read.
std::optional<Curves> recall(const std::string& key, const std::vector<Group>& offered);

// Says so when they cannot be kept.
void remember(const std::string& key, const Curves& curves);
}
