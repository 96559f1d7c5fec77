// The levels that carry their own answer: content/truth/*.glb says in its extras (ag_truth) what must come out, and why.
#pragma once
#include "engine/core/file.hpp"
#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

namespace afterglow
{
inline const std::filesystem::path kKnownAnswers = "content/truth";

inline std::vector<std::string> levelsOfKnownAnswer()
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(kKnownAnswers))
        if (entry.path().extension() == ".glb") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

// The first scene's ag_truth, from the JSON chunk of the .glb.
inline nlohmann::json statedTruth(const std::string& level)
{
    const std::vector<std::uint8_t> bytes = readFile(kKnownAnswers / (level + ".glb"));
    std::uint32_t length = 0;
    std::memcpy(&length, &bytes[12], 4);
    return nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + length)["scenes"][0]["extras"]["ag_truth"];
}
}
