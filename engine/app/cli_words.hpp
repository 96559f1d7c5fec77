// Inside of row 7: the words of the verbs that draw, and what they share with the others.
#pragma once
#include "engine/app/runtime_verbs.hpp"
#include <functional>
#include <string>

namespace CLI
{
class App;
}

namespace afterglow
{
// --size WxH, both 1..16384.
void sizeWord(CLI::App& verb, std::function<void(uvec2)> set);

// --progress, on a terminal and elsewhere.
void progressWord(CLI::App& verb, ProgressStyle& style);

// A finite number from `least` to `most`.
struct NumberWord {
    std::string name; // --like-this
    double least, most;
    std::string what, unit; // for --help
};
void numberWord(CLI::App& verb, const NumberWord& word, std::function<void(float)> set);

// What every verb that draws, or says what would be drawn, may be told of the frame; of the truth instead; of how that is traced.
void frameWords(CLI::App& verb, std::filesystem::path& target, Settings& settings);
void truthWords(CLI::App& verb, Settings& settings);
void tracingWord(CLI::App& verb, Settings& settings);

// `render`, `view`, `plan`, `graph`, `study`; the commands must outlive the parsing.
struct RuntimeCommands {
    RenderCommand render;
    ViewCommand view;
    PlanCommand plan;
    GraphCommand graph;
    StudyCommand study;
};
void runtimeWords(CLI::App& app, RuntimeCommands& commands);
}
