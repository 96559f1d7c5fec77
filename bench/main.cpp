// afterglow-bench [LEVEL] [--quick|--full] [--paths|--atlas|--room|--noise|--reflections] [--json FILE]: what baking and drawing a level
// cost on this machine.
#include <CLI/CLI.hpp> // first: it has a member called `check`, as error.hpp has a macro

#include "bench/bench.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/machine.hpp"
#include <nlohmann/json.hpp>
#include <unistd.h>

#undef check // CLI11's is meant below

namespace afterglow
{
using nlohmann::json;

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

// A folder of our own for the bakes, gone when the last number is in.
struct Workplace {
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("afterglow-bench-" + std::to_string(getpid()));
    Workplace() { std::filesystem::create_directories(path); }
    ~Workplace()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

// What a number is to be read with: the processor, and how busy the machine was before we began.
static json machine(int threads)
{
    return {{"cpu", processorName()}, {"threads", threadCount(threads)}, {"cores", threadCount(0)}, {"load", machineLoad()}};
}

static json begun(const BenchOptions& options)
{
    return {{"level", options.level.filename().string()}, {"machine", machine(options.threads)}};
}

static json measurePaths(const BenchOptions& options)
{
    json answers = begun(options);
    answers["paths"] = benchPaths(options);
    return answers;
}

static json measureNoise(const BenchOptions& options)
{
    json answers = begun(options);
    answers["noise"] = benchNoise(options);
    return answers;
}

static json measureReflections(const BenchOptions& options)
{
    json answers = begun(options);
    answers["reflections"] = benchReflections(options);
    return answers;
}

static json measureRoom(const BenchOptions& options)
{
    const Workplace place;
    json answers = begun(options);
    answers["room"] = benchRoom(options, place.path);
    return answers;
}

static json measureAtlas(const BenchOptions& options)
{
    const Workplace place;
    json answers = begun(options);
    answers["atlas"] = benchAtlas(options, place.path);
    return answers;
}

static json measureAll(const BenchOptions& options)
{
    const Workplace place;
    json answers = begun(options);
    answers["bake"] = benchBake(options, place.path / "level.baked");
    answers["atlas"] = benchAtlas(options, place.path);
    if (!options.quick) answers["room"] = benchRoom(options, place.path);
    answers["rays"] = benchRays(options, answers["bake"]);
    answers["triangles"] = benchTriangles(options);
    answers["threads"] = benchThreads(options, place.path / "small.baked");
    try {
        answers["frame"] = benchFrame(options, place.path / "level.baked");
    } catch (const Error& error) {
        if (error.exit != Exit::noDevice) throw;
        answers["frame"] = {{"missing", error.what()}}; // the other answers stand without it
    }
    return answers;
}
}

int main(int argc, char** argv)
{
    afterglow::BenchOptions options;
    options.level = "content/gallery/gallery.glb";
    std::filesystem::path file;
    bool paths = false, atlas = false, room = false, noise = false, reflections = false;
    CLI::App app("What baking and drawing a level cost on this machine", "afterglow-bench");
    app.add_option("LEVEL", options.level, "a .glb or .gltf file; the gallery when not said");
    app.add_flag("--quick", options.quick, "draft quality instead of medium, and fewer repetitions");
    app.add_flag("--full", options.full, "every path of the medium bake, minutes longer; otherwise a quarter, and the rest projected")
        ->excludes("--quick");
    app.add_flag("--paths", paths, "the truth by each organisation of the GPU's work, and nothing else")->excludes("--full");
    app.add_flag("--atlas", atlas, "the atlas beside xatlas, and nothing else")->excludes("--full")->excludes("--paths");
    app.add_flag("--room", room, "a room's lightmap to 2 % beside Blender's Cycles, and nothing else")
        ->excludes("--full")
        ->excludes("--paths")
        ->excludes("--atlas");
    app.add_flag("--noise", noise, "the error of the level's lightmap by paths a texel, and nothing else")
        ->excludes("--full")
        ->excludes("--paths")
        ->excludes("--atlas")
        ->excludes("--room");
    app.add_flag("--reflections", reflections, "reflection probes beside path-traced reflections, and nothing else")
        ->excludes("--full")
        ->excludes("--paths")
        ->excludes("--atlas")
        ->excludes("--room")
        ->excludes("--noise");
    app.add_option("--json", file, "the same numbers for a program")->type_name("FILE");
    app.add_option("--threads", options.threads, "0: all cores")->check(CLI::Range(0, 1024))->type_name("N");
    app.add_option("--device", options.device, "the Vulkan device that draws")->type_name("NAME|INDEX");
    try {
        app.parse(argc, argv);
        const nlohmann::json answers = paths         ? afterglow::measurePaths(options)
                                       : atlas       ? afterglow::measureAtlas(options)
                                       : room        ? afterglow::measureRoom(options)
                                       : noise       ? afterglow::measureNoise(options)
                                       : reflections ? afterglow::measureReflections(options)
                                                     : afterglow::measureAll(options);
        if (paths)
            afterglow::printPaths(answers);
        else if (atlas)
            afterglow::printAtlas(answers["atlas"]);
        else if (room)
            afterglow::printRoom(answers["room"]);
        else if (noise)
            afterglow::printNoise(answers["noise"]);
        else if (reflections)
            afterglow::printReflections(answers["reflections"]);
        else
            afterglow::printTable(answers);
        if (!file.empty()) afterglow::writeText(file, answers.dump(2) + "\n");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : int(afterglow::Exit::usage);
    } catch (const afterglow::Error& error) {
        std::fprintf(stderr, "afterglow-bench: %s\n", error.what());
        return int(error.exit);
    }
}
