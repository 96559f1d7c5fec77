// Inside of row 7: the words of the verbs that draw, and what they share with the others.
#pragma once
#include "engine/app/runtime_verbs.hpp"
#include <functional>
#include <string>

namespace CLI
{
class App;
class Option;
class Validator;
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
CLI::Option* numberWord(CLI::App& verb, const NumberWord& word, std::function<void(float)> set);

// For CLI::Option::transform(): a whole number from `least` to `most`, in decimal digits whatever it begins with.
CLI::Validator wholeNumber(std::int64_t least, std::int64_t most);

// A number of bytes, or of K, M, G ... of 1024 each.
struct BytesWord {
    std::string name, least;
    std::string what, unit; // for --help
};
void bytesWord(CLI::App& verb, const BytesWord& word, std::optional<std::uint64_t>& bytes);

// --seed of what is drawn by chance.
void seedWord(CLI::App& verb, std::uint32_t& seed);

// What every verb that draws, or says what would be drawn, may be told of the frame; of the truth instead; of how that is traced.
void frameWords(CLI::App& verb, std::filesystem::path& target, Settings& settings);
void truthWords(CLI::App& verb, Settings& settings);
void tracingWord(CLI::App& verb, Settings& settings);

// Inside of --help.
constexpr const char* kOfTheFrame = "Of the raster frame";
constexpr const char* kOfTheTruth = "Of the path-traced truth";
std::vector<std::string> wordsOf(const CLI::App& verb, const std::string& group);

// A word, and whether it is said.
struct OtherWord {
    std::string word; // "--mode truth"
    bool said;
};

// Words that do nothing where the other is not said, or where it is: these throw, once everything is read.
void obeyedWith(const CLI::App& verb, const OtherWord& other, const std::vector<std::string>& words);
void obeyedWithout(const CLI::App& verb, const OtherWord& other, const std::vector<std::string>& words);
[[noreturn]] void refuseIdle(const std::string& word, const OtherWord& other);

// An option of the verb that was called which is given more often than it can be; empty: none.
std::string saidTwice(const CLI::App& app);

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
