#include <CLI/CLI.hpp> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/cli_words.hpp"
#include "engine/frame/plan.hpp"
#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace afterglow
{
// The text as a number and nothing else: no sign before it, no space, no overflow.
template <class Number>
static std::optional<Number> whole(const std::string& text)
{
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stopped, problem] = std::from_chars(text.data(), end, number);
    return problem == std::errc() && stopped == end ? std::optional(number) : std::nullopt;
}

CLI::Option* numberWord(CLI::App& verb, const NumberWord& word, std::function<void(float)> set)
{
    const auto read = [set, word](const std::string& text) {
        const auto number = whole<double>(text);
        if (!number || !(*number >= word.least && *number <= word.most)) // NaN is within nothing
            throw CLI::ValidationError(word.name, fmt::format("'{}' is not a number from {:g} to {:g}", text, word.least, word.most));
        set(float(*number));
    };
    return verb.add_option_function<std::string>(word.name, read, word.what)->type_name(word.unit);
}

CLI::Validator wholeNumber(std::int64_t least, std::int64_t most)
{
    const auto read = [=](std::string& text) {
        const auto number = whole<std::int64_t>(text);
        if (!number || *number < least || *number > most) return fmt::format("'{}' is not a whole number from {} to {}", text, least, most);
        text = std::to_string(*number); // CLI11 reads 010 as eight
        return std::string();
    };
    return CLI::Validator(read, fmt::format("{} to {}", least, most));
}

static std::optional<std::uint64_t> bytesIn(std::string text)
try {
    CLI::AsSizeValue(/* kb_is_1000= */ false)(text);
    return whole<std::uint64_t>(text);
} catch (const CLI::ValidationError&) {
    return std::nullopt;
}

void bytesWord(CLI::App& verb, const BytesWord& word, std::optional<std::uint64_t>& bytes)
{
    const auto read = [&bytes, word](const std::string& text) {
        bytes = bytesIn(text);
        if (!bytes || *bytes < *bytesIn(word.least))
            throw CLI::ValidationError(
                word.name, fmt::format("'{}' is not a size of {} or more, such as 512M or 2G; a number alone is bytes", text, word.least));
    };
    verb.add_option_function<std::string>(word.name, read, word.what)->type_name(word.unit);
}

void seedWord(CLI::App& verb, std::uint32_t& seed)
{
    verb.add_option("--seed", seed, "another seed, other noise")->transform(wholeNumber(0, ~std::uint32_t(0)))->type_name("S");
}

void sizeWord(CLI::App& verb, std::function<void(uvec2)> set)
{
    const auto read = [set](const std::string& text) {
        const std::size_t cross = text.find('x');
        const auto w = whole<uint>(text.substr(0, cross));
        const auto h = whole<uint>(cross == std::string::npos ? "" : text.substr(cross + 1));
        if (!w || !h || *w < 1 || *h < 1 || *w > 16384 || *h > 16384)
            throw CLI::ValidationError("--size", "'" + text + "' is not a size such as 1280x720 (1 to 16384 each)");
        set(uvec2(*w, *h));
    };
    verb.add_option_function<std::string>("--size", read, "picture size in pixels")->type_name("WxH");
}

static void renderWords(CLI::App& app, RenderCommand& command)
{
    CLI::App& verb = *app.add_subcommand("render", "draw a level or its bake to a picture");
    frameWords(verb, command.target, command.settings);
    truthWords(verb, command.settings);
    progressWord(verb, command.progress);
    verb.add_option("-o", command.output, ".png as displayed, .exr scene-linear")->required()->type_name("IMAGE");
    verb.add_option("--camera", command.camera, "the level's camera")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.settings.size = size; });
    verb.add_option("--frames", command.frames, "frames that the picture is the mean of, each timed")
        ->transform(wholeNumber(1, 100000))
        ->type_name("N")
        ->group(kOfTheFrame);
    verb.add_option("--layers", command.layers, "the parts of the picture, for compositing")->type_name("LAYERS.exr")->group(kOfTheFrame);
    verb.add_option("--stats", command.stats, "what it cost, pass by pass")->type_name("FILE.json");
    verb.add_option("--device", command.device, "which Vulkan device")->type_name("NAME|INDEX");
    numberWord(verb, {"--budget-ms", 1e-3, 1e6, "give up what costs the least error, until a frame takes no longer", "MS"},
               [&command](float ms) { command.budgetMs = double(ms); })
        ->group(kOfTheFrame);
    verb.callback([&command, &verb] {
        const OtherWord traced = {"--mode truth", command.settings.mode == Mode::truth};
        obeyedWith(verb, traced, wordsOf(verb, kOfTheTruth));
        obeyedWithout(verb, traced, wordsOf(verb, kOfTheFrame));
        obeyedWithout(verb, {"--show", command.settings.show != kShowNothing}, {"--layers", "--budget-ms"});
        for (const auto& [effect, on] : command.settings.effects.forced)
            if (traced.said && !isOfTheCamera(effect)) refuseIdle("--effects " + std::string(on ? "+" : "-") + effect, traced);
        renderVerb(command);
    });
}

static void viewWords(CLI::App& app, ViewCommand& command)
{
    CLI::App& verb = *app.add_subcommand("view", "walk through a level or its bake, in a window");
    frameWords(verb, command.target, command.settings);
    tracingWord(verb, command.settings);
    verb.add_option("--camera", command.camera, "the level's camera to start from")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.settings.size = size; });
    verb.add_option("--device", command.device, "which Vulkan device")->type_name("NAME|INDEX");
    verb.add_option("--frames", command.frames, "close after N frames")->transform(wholeNumber(0, 1 << 24))->group(""); // for tests
    verb.callback([&command] { viewVerb(command); });
}

static void planWords(CLI::App& app, PlanCommand& command)
{
    CLI::App& verb = *app.add_subcommand("plan", "say which effects a level calls for, and why");
    frameWords(verb, command.target, command.settings);
    verb.add_flag("--json", command.json, "for machines");
    numberWord(verb, {"--milliseconds", 1e-3, 1e6, "of a frame: what fits, and what is given up for it", "MS"},
               [&command](float ms) { command.milliseconds = double(ms); });
    verb.add_option("--camera", command.camera, "of --milliseconds: the level's camera")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.settings.size = size; });
    verb.add_option("--device", command.device, "of --milliseconds: which Vulkan device")->type_name("NAME|INDEX");
    progressWord(verb, command.progress);
    verb.callback([&command, &verb] {
        obeyedWith(verb, {"--milliseconds", command.milliseconds.has_value()}, {"--camera", "--size", "--device", "--progress"});
        obeyedWithout(verb, {"--show", command.settings.show != kShowNothing}, {"--milliseconds"}); // pictures are judged
        planVerb(command);
    });
}

static void graphWords(CLI::App& app, GraphCommand& command)
{
    CLI::App& verb = *app.add_subcommand("graph", "print the passes of a frame: reads, writes, bytes, milliseconds");
    frameWords(verb, command.target, command.settings);
    verb.add_option("--camera", command.camera, "the level's camera")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.settings.size = size; });
    verb.add_flag("--dot", command.dot, "as a Graphviz graph");
    verb.add_option("--device", command.device, "which Vulkan device")->type_name("NAME|INDEX");
    verb.callback([&command] { graphVerb(command); });
}

static void studyWords(CLI::App& app, StudyCommand& command)
{
    CLI::App& verb = *app.add_subcommand("study", "measure what accuracy costs: each effect and product against its truth");
    verb.add_option("LEVEL|DIR", command.target, "a level, which is baked first, or a baked folder")->required();
    verb.add_option("-o", command.directory, "study.csv, study.json and study.html")->required()->type_name("DIR");
    verb.add_option("--effects", command.effects, "these alone")->delimiter(',')->type_name("LIST");
    verb.add_flag("--quick", command.quick, "small pictures, a draft bake: minutes");
    verb.add_flag("--readmes", command.readmes, "put the tables into engine/effects/*/README.md, where those name this level");
    verb.add_option("--camera", command.camera, "the level's camera")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.size = size; });
    verb.add_option("--samples", command.samples, "paths per pixel of each of the two truths")
        ->transform(wholeNumber(1, 1 << 20))
        ->type_name("N");
    verb.add_option("--device", command.device, "which Vulkan device")->type_name("NAME|INDEX");
    progressWord(verb, command.progress);
    verb.callback([&command] { studyVerb(command); });
}

void runtimeWords(CLI::App& app, RuntimeCommands& commands)
{
    renderWords(app, commands.render);
    viewWords(app, commands.view);
    planWords(app, commands.plan);
    graphWords(app, commands.graph);
    studyWords(app, commands.study);
}
}
