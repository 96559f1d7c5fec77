#include <CLI/CLI.hpp> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/cli.hpp"
#include "engine/app/cli_words.hpp"
#include "engine/app/compare.hpp"
#include "engine/app/inspect.hpp"
#include "engine/app/verbs.hpp"
#include "engine/core/error.hpp"
#include "engine/core/interrupt.hpp"
#include "engine/core/log.hpp"
#include <algorithm>
#include <cstdio>
#include <iostream>

#undef check // CLI11's is meant below

namespace afterglow
{
static const std::map<std::string, ProgressStyle> kProgress = {
    {"auto", ProgressStyle::automatic}, {"plain", ProgressStyle::plain}, {"json", ProgressStyle::json}, {"none", ProgressStyle::none}};

void progressWord(CLI::App& verb, ProgressStyle& style)
{
    verb.add_option_function<std::string>(
            "--progress",
            [&style](const std::string& name) {
                style = kProgress.at(name);
                if (style == ProgressStyle::json) sayAsJson();
            },
            "how progress is shown; json: warnings, too, are lines of JSON")
        ->check(CLI::IsMember({"auto", "plain", "json", "none"}))
        ->type_name("auto|plain|json|none");
}

static void bakeWords(CLI::App& app, BakeCommand& command)
{
    CLI::App& verb = *app.add_subcommand("bake", "bake a level's light into a folder");
    BakeOptions& o = command.options;
    verb.add_option("LEVEL", command.level, "a .glb or .gltf file")->required();
    verb.add_option("-o", command.directory, "the baked folder")->required()->type_name("DIR");
    verb.add_option_function<std::string>(
            "--quality",
            [&o](const std::string& name) {
                o.quality = name == "draft" ? Quality::draft : name == "high" ? Quality::high : Quality::medium;
            },
            "presets of density and samples: medium, unless said")
        ->check(CLI::IsMember({"draft", "medium", "high"}))
        ->type_name("draft|medium|high");
    numberWord(verb, {"--texels-per-metre", 0.01, 1e4, "lightmap density", "D"}, [&o](float density) { o.texelsPerMetre = density; });
    verb.add_option("--lightmap-pages", o.lightmapPages, "lightmap pages to fill: the density is what they hold")
        ->transform(wholeNumber(1, 64))
        ->type_name("N");
    verb.add_option("--samples", o.samples, "paths per texel")->transform(wholeNumber(1, 1 << 24))->type_name("N");
    numberWord(verb,
               {"--time-budget", 1e-3, 1e9, "of the whole bake: takes the finest quality and paths that fit, --quality at most", "SECONDS"},
               [&o](float seconds) { o.timeBudget = double(seconds); });
    numberWord(verb, {"--target-error", 1e-4, 1.0, "relative RMSE of a lightmap's texel before filtering: as many paths as it takes", "E"},
               [&o](float error) { o.targetError = error; });
    numberWord(verb, {"--probe-spacing", 1e-3, 1e4, "the largest cell between irradiance probes", "M"},
               [&o](float spacing) { o.probeSpacing = spacing; });
    numberWord(verb,
               {"--probe-error", 1e-3, 1.0, "relative error between irradiance probes, and 0.4 of it by noise: as many as it takes", "E"},
               [&o](float error) { o.probeError = error; });
    bytesWord(verb, {"--probe-budget", "1K", "irradiance probes in as many bytes, before they are packed", "BYTES"}, o.probeBytes);
    verb.add_option("--sh-order", o.probeOrder,
                    "of irradiance probes: 1 takes less than half of the bytes, and blurs where light comes from")
        ->transform(wholeNumber(1, 2))
        ->type_name("1|2");
    verb.add_option("--bounces", o.bounces, "surfaces that scatter")->transform(wholeNumber(0, 1024))->type_name("N");
    seedWord(verb, o.seed);
    verb.add_option("--threads", o.threads, "0: all cores; the result is the same")->transform(wholeNumber(0, 1024))->type_name("N");
    bytesWord(
        verb,
        {"--max-memory", "1M", "what the bake may hold; what does not fit waits on the disk, and the result is the same", "BYTES|512M|2G"},
        o.maxMemory);
    verb.add_option_function<std::string>(
            "--direct", [&o](const std::string& how) { o.directAll = how == "all"; }, "what the bake holds of punctual lights")
        ->check(CLI::IsMember({"as-said", "all"}))
        ->type_name("as-said|all");
    verb.add_option_function<std::string>(
            "--directional", [&o](const std::string& how) { o.directional = how == "auto" ? std::nullopt : std::optional(how == "on"); },
            "lightmaps that normal maps can bend; auto: where there are any")
        ->check(CLI::IsMember({"auto", "on", "off"}))
        ->type_name("auto|on|off");
    verb.add_option_function<std::vector<std::string>>(
            "--only",
            [&o](const std::vector<std::string>& list) {
                auto has = [&](const char* name) { return std::find(list.begin(), list.end(), name) != list.end(); };
                o.lightmaps = has("lightmaps"), o.probes = has("probes"), o.reflections = has("reflections"), o.lods = has("lods");
                o.voxels = has("voxels");
            },
            "make these products only")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember({"lightmaps", "probes", "reflections", "lods", "voxels"}))
        ->type_name("LIST");
    verb.add_option_function<std::string>(
            "--denoise",
            [&o](const std::string& how) {
                o.denoiser = how == "builtin" ? Denoiser::builtin : how == "oidn" ? Denoiser::oidn : Denoiser::none;
            },
            "filter the lightmaps; oidn: by Open Image Denoise, where this machine has it")
        ->check(CLI::IsMember({"none", "builtin", "oidn"}))
        ->type_name("none|builtin|oidn");
    verb.add_option_function<std::string>(
            "--stitch", [&o](const std::string& how) { o.stitch = how == "on"; },
            "lightmaps of charts and objects agree where one surface goes on from one to the next")
        ->check(CLI::IsMember({"on", "off"}))
        ->type_name("on|off");
    verb.add_option_function<std::string>(
            "--light-cache", [&o](const std::string& how) { o.lightCache = how == "on"; },
            "paths of lightmaps and probes end where earlier ones have found the light: a fraction of the time; off: each is traced to its "
            "end. On, unless --denoise none, --light-layers, --incremental or fewer than 8 --bounces are said")
        ->check(CLI::IsMember({"on", "off"}))
        ->type_name("on|off");
    verb.add_flag(
        "--light-layers", o.lightLayers,
        "lightmaps of each light apart, as long as a bake for each; after a change of colours and strengths alone the next bake of "
        "it traces none (DIR.kept)");
    verb.add_flag("--incremental", o.incremental,
                  "after something moved the next bake of the level traces lightmaps only where that reaches (DIR.kept)");
    verb.add_flag("--exr", o.exr, "write .exr masters beside the .ktx2");
    verb.add_flag("--force", o.force, "bake also what stands there already, of the same level and options");
    verb.add_flag("--resume", o.resume, "go on with a bake that was killed, from DIR.journal: the result is the same");
    progressWord(verb, command.progress);
    verb.callback([&command, &verb] {
        const BakeOptions& o = command.options;
        obeyedWithout(verb, {"--time-budget", o.timeBudget.has_value()},
                      {"--samples", "--texels-per-metre", "--lightmap-pages", "--target-error"});
        obeyedWithout(verb, {"--time-budget", o.timeBudget.has_value()}, {"--light-layers", "--incremental"}); // each bake another density
        obeyedWithout(verb, {"--target-error", o.targetError.has_value()}, {"--samples"});
        obeyedWith(verb, {"lightmaps in --only", o.lightmaps},
                   {"--samples", "--texels-per-metre", "--lightmap-pages", "--target-error", "--directional", "--denoise", "--stitch",
                    "--exr", "--light-layers", "--incremental"});
        obeyedWith(verb, {"lightmaps or probes in --only", o.lightmaps || o.probes}, {"--light-cache"});
        obeyedWithout(verb, {"--light-layers", o.lightLayers}, {"--light-cache"});
        obeyedWithout(verb, {"--incremental", o.incremental}, {"--light-cache"});
        obeyedWithout(verb, {"--bounces below 8", o.bounces && *o.bounces < kCachedBounces}, {"--light-cache"});
        obeyedWith(verb, {"probes in --only", o.probes}, {"--probe-error", "--probe-budget", "--sh-order"});
        obeyedWith(verb, {"probes or reflections in --only", o.probes || o.reflections}, {"--probe-spacing"});
        obeyedWith(verb, {"--probe-error", o.probeError || !o.probeSpacing}, {"--probe-budget"}); // the spacing alone says how many
        obeyedWith(verb, {"lightmaps, probes or reflections in --only", o.lightmaps || o.probes || o.reflections},
                   {"--quality", "--time-budget", "--bounces", "--seed"});
        if (command.options.timeBudget && verb.count("--quality") == 0) command.options.quality = Quality::high;
        bakeVerb(command);
    });
}

static void truthWords(CLI::App& app, TruthCommand& command)
{
    CLI::App& verb = *app.add_subcommand("truth", "path trace a picture of a level on the CPU, with no shortcut");
    TruthOptions& o = command.options;
    verb.add_option("LEVEL", command.level, "a .glb or .gltf file, or a baked folder")->required();
    verb.add_option("-o", command.output, "scene-linear radiance")->required()->type_name("IMAGE.exr");
    verb.add_option("--camera", command.camera, "the level's camera")->type_name("NAME|INDEX");
    sizeWord(verb, [&o](uvec2 size) { o.size = ivec2(size); });
    verb.add_option("--samples", o.samples, "paths per pixel")->transform(wholeNumber(1, 1 << 24))->type_name("N");
    seedWord(verb, o.seed);
    verb.add_option("--bounces", o.bounces, "surfaces that scatter")->transform(wholeNumber(0, 1024))->type_name("N");
    verb.add_option("--scatterings", o.scatterings, "in fog, of one path; 1: single scattering")
        ->transform(wholeNumber(0, 1 << 20))
        ->type_name("N");
    verb.add_option("--threads", o.threads, "0: all cores; the result is the same")->transform(wholeNumber(0, 1024))->type_name("N");
    verb.add_flag("--direct-only", o.directOnly, "emission, and light that reaches the first surface straight");
    verb.add_option("--portal-depth", o.portalDepth, "through how many portals the camera sees")
        ->transform(wholeNumber(0, 64))
        ->type_name("N");
    verb.add_flag("--spectral", o.spectral, "by wavelength, three to a path, instead of by red, green and blue");
    verb.add_flag("--ao", o.ao, "cosine-weighted visibility instead of radiance");
    verb.add_option_function<std::string>(
            "--tracing",
            [&o](const std::string& name) { o.organisation = name == "wavefront" ? Organisation::wavefront : Organisation::loop; },
            "one path after the other, or many of them stage by stage: the same paths")
        ->check(CLI::IsMember({"loop", "wavefront"}))
        ->type_name("loop|wavefront");
    numberWord(verb, {"--ao-range", 1e-6, 1e9, "how far visibility looks", "M"}, [&o](float range) { o.aoRange = range; });
    progressWord(verb, command.progress);
    verb.callback([&command, &verb] {
        const TruthOptions& o = command.options;
        obeyedWith(verb, {"--ao", o.ao}, {"--ao-range"});
        obeyedWithout(verb, {"--ao", o.ao}, {"--bounces", "--scatterings", "--direct-only", "--spectral", "--tracing"});
        obeyedWithout(verb, {"--spectral", o.spectral}, {"--tracing"});
        obeyedWithout(verb, {"--direct-only", o.directOnly}, {"--bounces", "--scatterings"});
        truthVerb(command);
    });
}

static void probeWords(CLI::App& app, ProbeCommand& command)
{
    CLI::App& verb = *app.add_subcommand("probe", "irradiance at given points: of the lightmap or the probes there, or path traced");
    verb.add_option("LEVEL|DIR", command.target, "a level (with --truth) or a baked folder")->required();
    verb.add_option("--points", command.points, "{\"points\":[{\"position\":[x,y,z]}, ...]}")->required()->type_name("IN.json");
    verb.add_option("-o", command.output,
                    "the same with \"E\", irradiance (W/m2, or lux where the level says its lights in candela): about \"normal\", or in "
                    "six rows about +x -x +y -y +z -z")
        ->required()
        ->type_name("OUT.json");
    verb.add_flag("--truth", command.truth, "path trace it, of all lights, instead of reading the bake");
    verb.add_option("--samples", command.samples, "paths per direction")->transform(wholeNumber(1, 1 << 24))->type_name("N");
    seedWord(verb, command.seed);
    verb.add_option("--threads", command.threads, "0: all cores")->transform(wholeNumber(0, 1024))->type_name("N");
    progressWord(verb, command.progress);
    verb.callback([&command, &verb] {
        obeyedWith(verb, {"--truth", command.truth}, {"--samples", "--seed", "--threads"});
        probeVerb(command);
    });
}

static void compareWords(CLI::App& app, CompareOptions& options)
{
    CLI::App& verb = *app.add_subcommand("compare", "how far two pictures are apart");
    verb.add_option("A", options.a, "the picture in question")->required();
    verb.add_option("B", options.b, "the reference, of the same size")->required();
    verb.add_option("-o", options.heatMap, "FLIP per pixel")->type_name("HEAT.png");
    verb.add_flag("--json", options.json, "for machines");
    verb.callback([&options] { compare(options); });
}

static void inspectWords(CLI::App& app, InspectOptions& options)
{
    CLI::App& verb = *app.add_subcommand("inspect", "what is in a baked folder, and whether all of it is whole");
    verb.add_option("DIR", options.directory, "a baked folder")->required();
    verb.add_flag("--json", options.json, "for machines");
    verb.callback([&options] { inspect(options); });
}

// What is left over of a command, in its order; CLI11 tells it backwards.
static std::string leftOver(const CLI::App& app)
{
    std::string words;
    for (const std::string& word : app.remaining(/* recurse= */ true)) words += (words.empty() ? "" : " ") + word;
    const auto verbs = app.get_subcommands();
    return (verbs.empty() ? "" : verbs.front()->get_name() + ": ") + "not expected: " + words;
}

// Where it is said how the verb is asked, or which verbs there are.
static std::string helpOf(const CLI::App& app)
{
    const auto verbs = app.get_subcommands();
    return "afterglow " + (verbs.empty() ? "" : verbs.front()->get_name() + " ") + "--help";
}

// The exit code once all is done: what was printed must have arrived, wherever stdout leads.
static int whenPrinted()
{
    std::cout.flush();
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout) return int(Exit::done);
    std::fprintf(stderr, "afterglow: cannot write the result to stdout: the disk may be full, or nobody reads; write it elsewhere\n");
    return int(Exit::badInput);
}

int runCommandLine(int argc, const char* const* argv)
{
    hearInterrupts();
    CLI::App app{"Afterglow bakes a level's light ahead of time and shows it afterwards."};
    app.name("afterglow");
    app.set_version_flag("--version", "afterglow " AFTERGLOW_VERSION);
    app.require_subcommand(1);
    BakeCommand bake;
    TruthCommand truth;
    ProbeCommand probe;
    bakeWords(app, bake);
    truthWords(app, truth);
    probeWords(app, probe);
    CompareOptions compared;
    InspectOptions inspected;
    compareWords(app, compared);
    inspectWords(app, inspected);
    RuntimeCommands runtime;
    runtimeWords(app, runtime);
    try {
        auto called = [&](CLI::App* verb) { return argc > 1 && verb->get_name() == argv[1]; };
        if (argc > 1 && argv[1][0] == '-' && !app.get_option_no_throw(argv[1]))
            throw Error("there is no option '" + std::string(argv[1]) + "' before a verb; see `afterglow --help`", Exit::usage);
        if (argc > 1 && argv[1][0] != '-' && app.get_subcommands(called).empty())
            throw Error("there is no verb '" + std::string(argv[1]) + "'; see `afterglow --help`", Exit::usage);
        for (int i = 2; i < argc; ++i)
            if (argv[i][0] == '\0')
                throw Error("the word after '" + std::string(argv[i - 1]) + "' is empty: write what is meant, or leave it out",
                            Exit::usage);
        app.parse(argc, argv);
        return whenPrinted();
    } catch (const CLI::ExtrasError&) {
        std::fprintf(stderr, "afterglow: %s; see `%s`\n", oneLine(leftOver(app)).c_str(), helpOf(app).c_str());
        return int(Exit::usage);
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string twice = saidTwice(app);
        const std::string why = twice.empty() ? error.what() : twice + " is said more than once: leave one of them";
        std::fprintf(stderr, "afterglow: %s; see `%s`\n", oneLine(why).c_str(), helpOf(app).c_str());
        return int(Exit::usage);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) { // --help
            app.exit(error);
            return whenPrinted();
        }
        std::fprintf(stderr, "afterglow: %s; see `%s`\n", oneLine(error.what()).c_str(), helpOf(app).c_str());
        return int(Exit::usage);
    } catch (const Error& error) {
        std::fprintf(stderr, "afterglow: %s\n", oneLine(error.what()).c_str());
        return int(error.exit);
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "afterglow: out of memory; use a smaller level, size or density\n");
        return int(Exit::badInput);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "afterglow: %s\n", error.what());
        return int(Exit::badInput);
    }
}
}
