// Inside of the budget: what earlier runs measured, in files of their own.
#pragma once
#include "engine/app/budget/change.hpp"
#include <optional>

namespace afterglow
{
// Of a default frame's options, as far as they were measured.
struct Measured {
    double error = 0.0;                                           // of the default frame
    std::map<std::string, std::map<std::string, Change>> changes; // by effect, by the option's name
    std::map<double, double> scales;                              // the error when drawn at that share of the size
};

// All that they depend on, in words: device, level, camera, small size, settings, version of the program.
std::string keyOf(const Sitter& sitter);

// The same of the path-traced picture, which knows of no device and no settings.
std::string truthKeyOf(const Sitter& sitter);

// Where they are kept; empty when nobody says where.
std::filesystem::path cacheFolder();

// Nothing when there is none by that key, or what is there cannot be read.
std::optional<Measured> recall(const std::string& key);
std::optional<Truth> recallTruth(const std::string& key);

// False when they cannot be kept; says so.
bool remember(const std::string& key, const Measured& measured);
bool rememberTruth(const std::string& key, const Truth& truth);
}
