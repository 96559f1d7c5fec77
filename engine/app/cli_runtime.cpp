#include <CLI/CLI.hpp> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/cli_words.hpp"
#include <cstdio>

namespace afterglow
{
void sizeWord(CLI::App& verb, std::function<void(uvec2)> set)
{
    const auto read = [set](const std::string& text) {
        int w = 0, h = 0, end = 0;
        if (std::sscanf(text.c_str(), "%dx%d%n", &w, &h, &end) != 2 || std::size_t(end) != text.size() || w < 1 || h < 1 || w > 16384 ||
            h > 16384)
            throw CLI::ValidationError("--size", "'" + text + "' is not a size such as 1280x720 (1 to 16384 each)");
        set(uvec2(w, h));
    };
    verb.add_option_function<std::string>("--size", read, "picture size in pixels")->type_name("WxH");
}

// What every verb that draws, or says what would be drawn, may be told of the frame.
static void frameWords(CLI::App& verb, std::filesystem::path& target, Settings& settings)
{
    verb.add_option("LEVEL|DIR", target, "a level, or a baked folder")->required();
    verb.add_option_function<std::string>(
            "--effects", [&settings](const std::string& text) { settings.effects = parseOverrides(text); },
            "what is drawn, against the plan")
        ->type_name("auto|all|none|+fog,-bloom,...");
    verb.add_option("--render-scale", settings.renderScale, "drawn at this share of the size, and brought to it")
        ->check(CLI::Range(0.25f, 1.0f))
        ->type_name("F");
}

static void renderWords(CLI::App& app, RenderCommand& command)
{
    CLI::App& verb = *app.add_subcommand("render", "draw a level or its bake to a picture");
    frameWords(verb, command.target, command.settings);
    verb.add_option("-o", command.output, ".png as displayed, .exr scene-linear")->required()->type_name("IMAGE");
    verb.add_option("--camera", command.camera, "the level's camera")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.settings.size = size; });
    verb.add_option("--frames", command.frames, "frames that the picture is the mean of, each timed")
        ->check(CLI::Range(1, 100000))
        ->type_name("N");
    verb.add_option("--layers", command.layers, "the parts of the picture, for compositing")->type_name("LAYERS.exr");
    verb.add_option("--stats", command.stats, "what it cost, pass by pass")->type_name("FILE.json");
    verb.add_option("--device", command.device, "which Vulkan device")->type_name("NAME|INDEX");
    verb.callback([&command] { renderVerb(command); });
}

static void viewWords(CLI::App& app, ViewCommand& command)
{
    CLI::App& verb = *app.add_subcommand("view", "walk through a level or its bake, in a window");
    frameWords(verb, command.target, command.settings);
    verb.add_option("--camera", command.camera, "the level's camera to start from")->type_name("NAME|INDEX");
    sizeWord(verb, [&command](uvec2 size) { command.settings.size = size; });
    verb.add_option("--device", command.device, "which Vulkan device")->type_name("NAME|INDEX");
    verb.add_option("--frames", command.frames, "close after N frames")->check(CLI::Range(0, 1 << 24))->group(""); // for tests
    verb.callback([&command] { viewVerb(command); });
}

static void planWords(CLI::App& app, PlanCommand& command)
{
    CLI::App& verb = *app.add_subcommand("plan", "say which effects a level calls for, and why");
    frameWords(verb, command.target, command.settings);
    verb.add_flag("--json", command.json, "for machines");
    verb.callback([&command] { planVerb(command); });
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

void runtimeWords(CLI::App& app, RuntimeCommands& commands)
{
    renderWords(app, commands.render);
    viewWords(app, commands.view);
    planWords(app, commands.plan);
    graphWords(app, commands.graph);
}
}
