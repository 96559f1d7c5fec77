// What a frame, or the truth about it, may be told: one function for the words of each effect.
#include <CLI/CLI.hpp> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/cli_words.hpp"

namespace afterglow
{
static constexpr const char* kOfAll = "Options"; // as CLI11 calls them

// A method that is named is meant to be seen.
static void shadowWords(CLI::App& verb, Settings& settings)
{
    static const std::map<std::string, ShadowMethod> kMethods = {{"map", ShadowMethod::map}, {"ray", ShadowMethod::ray}};
    const auto set = [&settings](const std::string& word) {
        settings.shadowMethod = kMethods.at(word);
        settings.effects.forced.emplace("shadow", true);
    };
    verb.add_option_function<std::string>("--shadows", set,
                                          "by maps, or by ray queries in the lights' size; maps where the device has none")
        ->check(CLI::IsMember(kMethods))
        ->type_name("map|ray");
}

// A method that is named is meant to be seen.
static void occlusionWords(CLI::App& verb, Settings& settings)
{
    static const std::map<std::string, OcclusionMethod> kMethods = {{"ssao", OcclusionMethod::ssao},
                                                                    {"hbao", OcclusionMethod::hbao},
                                                                    {"voxel", OcclusionMethod::voxel},
                                                                    {"ray", OcclusionMethod::ray},
                                                                    {"auto", OcclusionMethod::automatic}};
    const auto set = [&settings](const std::string& word) {
        const OcclusionMethod method = kMethods.at(word);
        settings.occlusionMethod = method;
        if (method != OcclusionMethod::automatic) settings.effects.forced.emplace("occlusion", true);
    };
    verb.add_option_function<std::string>("--ao", set, "ambient occlusion, by which method; hbao where the device has no ray queries")
        ->check(CLI::IsMember(kMethods))
        ->type_name("ssao|hbao|voxel|ray|auto");
    numberWord(
        verb,
        {"--ao-range", 1e-6, 1e9, "beyond it nothing occludes; unless said 1, or the edge of the probes' cells where that is less", "M"},
        [&settings](float m) { settings.occlusionRange = m; });
}

// A method that is named is meant to be seen.
static void reflectionWords(CLI::App& verb, Settings& settings)
{
    static const std::map<std::string, ReflectionMethod> kMethods = {
        {"screen", ReflectionMethod::screen}, {"ray", ReflectionMethod::ray}, {"auto", ReflectionMethod::screen}};
    const auto set = [&settings](const std::string& word) {
        settings.reflectionMethod = kMethods.at(word);
        if (word != "auto") settings.effects.forced.emplace("reflection", true);
    };
    verb.add_option_function<std::string>("--reflections", set,
                                          "of the picture itself, or of the level by ray queries; of the picture where the device has none")
        ->check(CLI::IsMember(kMethods))
        ->type_name("screen|ray|auto");
}

// A style that is named is meant to be seen.
static void styleWords(CLI::App& verb, Settings& settings)
{
    static const std::map<std::string, uint> kKinds = {{"silhouette", kEdgeSilhouette}, {"border", kEdgeBorder}, {"crease", kEdgeCrease},
                                                       {"material", kEdgeMaterial},     {"object", kEdgeObject}, {"all", kEveryEdge}};
    const auto steps = [&settings](uint count) {
        settings.toonSteps = count;
        settings.effects.forced.emplace("toon", true);
    };
    const auto width = [&settings](float pixels) {
        settings.outlineWidth = pixels;
        settings.effects.forced.emplace("outline", true);
    };
    const auto kinds = [&settings](const std::vector<std::string>& words) {
        settings.outline.kinds = 0;
        for (const std::string& word : words) settings.outline.kinds |= kKinds.at(word);
    };
    verb.add_option_function<uint>("--toon-steps", steps, "every surface answers light in steps")
        ->transform(wholeNumber(1, 64))
        ->type_name("N");
    numberWord(verb, {"--outline-px", 0.0, 64.0, "lines of that width", "W"}, width);
    verb.add_option_function<std::vector<std::string>>("--outline-kinds", kinds, "which edges are lines")
        ->delimiter(',')
        ->check(CLI::IsMember(kKinds))
        ->type_name("silhouette,border,crease,material,object|all");
}

// What is shown must be uploaded.
static void showWord(CLI::App& verb, Settings& settings)
{
    static const std::map<std::string, uint> kShown = {{"probes", kShowProbes},
                                                       {"validity", kShowValidity},
                                                       {"cells", kShowCells},
                                                       {"weights", kShowWeights},
                                                       {"influence", kShowInfluence}};
    const auto set = [&settings](const std::string& word) {
        settings.show = kShown.at(word);
        settings.effects.forced.emplace(settings.show == kShowInfluence ? "reflections" : "probes", true);
    };
    verb.add_option_function<std::string>("--show", set,
                                          "irradiance probes as spheres in their light, or by how far they were moved; surfaces "
                                          "by the cell they ask, by its largest weight, or by the reflection probes they mirror")
        ->check(CLI::IsMember(kShown))
        ->type_name("probes|validity|cells|weights|influence");
}

using WordOfEffect = std::pair<const char*, const char*>;
static constexpr WordOfEffect kMethodWords[] = {
    {"--shadows", "shadow"}, {"--ao", "occlusion"}, {"--reflections", "reflection"}, {"--toon-steps", "toon"}, {"--outline-px", "outline"}};
static constexpr WordOfEffect kKnobWords[] = {{"--ao-range", "occlusion"},   {"--fog-steps", "fog"},  {"--fog-resolution", "fog"},
                                              {"--portal-depth", "portal"},  {"--lod-error", "lods"}, {"--render-scale", "upscale"},
                                              {"--outline-kinds", "outline"}};

// Knobs, if only turned to where they stood. A method or a style that is named forces its effect on, which says as much. Neither is
// obeyed by an effect that the same line turns off.
static void rememberWhatIsSaid(CLI::App& verb, Settings& settings)
{
    verb.parse_complete_callback([&verb, &settings] {
        const auto refuseWhereOff = [&](const WordOfEffect& of) {
            const auto forced = settings.effects.forced.find(of.second);
            const bool off = forced != settings.effects.forced.end() && !forced->second;
            obeyedWithout(verb, {std::string("--effects -") + of.second, off}, {of.first});
        };
        for (const WordOfEffect& method : kMethodWords) refuseWhereOff(method);
        for (const WordOfEffect& knob : kKnobWords) {
            refuseWhereOff(knob);
            if (verb.count(knob.first) > 0) settings.said.emplace(knob);
        }
    });
}

void frameWords(CLI::App& verb, std::filesystem::path& target, Settings& settings)
{
    verb.add_option("LEVEL|DIR", target, "a level, or a baked folder")->required();
    verb.add_option_function<std::string>(
            "--effects", [&settings](const std::string& text) { settings.effects = parseOverrides(text); },
            "what is drawn, against the plan")
        ->type_name("auto|all|none|+fog,-bloom,...");
    verb.add_option("--portal-depth", settings.portal.depth, "through how many portals one sees")
        ->transform(wholeNumber(0u, kDeepestPortal))
        ->type_name("N");
    verb.option_defaults()->group(kOfTheFrame);
    shadowWords(verb, settings);
    occlusionWords(verb, settings);
    reflectionWords(verb, settings);
    verb.add_option("--fog-steps", settings.fog.steps, "of a ray through fog, for each medium and light")
        ->transform(wholeNumber(1, 256))
        ->type_name("N");
    verb.add_option_function<std::string>(
            "--fog-resolution", [&settings](const std::string& of) { settings.fog.divisor = of == "full"   ? 1u
                                                                                            : of == "half" ? 2u
                                                                                                           : 4u; },
            "of what fog scatters, against the picture's")
        ->check(CLI::IsMember({"full", "half", "quarter"}))
        ->type_name("full|half|quarter");
    numberWord(verb, {"--render-scale", 0.25, 1.0, "drawn at this share of the size, and brought to it", "F"},
               [&settings](float share) { settings.renderScale = share; });
    numberWord(verb, {"--lod-error", 0.0, 64.0, "how far from its place a coarser level of detail may be drawn", "PIXELS"},
               [&settings](float pixels) { settings.lodError = pixels; });
    styleWords(verb, settings);
    showWord(verb, settings);
    verb.option_defaults()->group(kOfAll);
    rememberWhatIsSaid(verb, settings);
}

void tracingWord(CLI::App& verb, Settings& settings)
{
    verb.add_option_function<std::string>(
            "--tracing", [&settings](const std::string& word) { settings.tracing = tracingWords().at(word); },
            "of the truth: in one kernel, by ray programs, or in many small kernels; auto: as is fastest on the device")
        ->check(CLI::IsMember(tracingWords()))
        ->type_name("auto|kernel|pipeline|wavefront");
}

void truthWords(CLI::App& verb, Settings& settings)
{
    static const std::map<std::string, Mode> kModes = {{"raster", Mode::raster}, {"truth", Mode::truth}};
    TruthParameters& truth = settings.truth;
    verb.add_option_function<std::string>(
            "--mode", [&settings](const std::string& word) { settings.mode = kModes.at(word); },
            "the frame, or the truth about it: path traced by ray queries or ray programs, with no shortcut")
        ->check(CLI::IsMember(kModes))
        ->type_name("raster|truth");
    verb.option_defaults()->group(kOfTheTruth);
    verb.add_option("--samples", truth.samples, "paths per pixel")->transform(wholeNumber(1u, kMostTruthSamples))->type_name("N");
    seedWord(verb, truth.seed);
    verb.add_option("--bounces", truth.bounces, "surfaces that scatter")->transform(wholeNumber(0, 1024))->type_name("N");
    verb.add_option("--scatterings", truth.scatterings, "in fog, of one path; 1: single scattering")
        ->transform(wholeNumber(0, 1 << 20))
        ->type_name("N");
    tracingWord(verb, settings);
    verb.option_defaults()->group(kOfAll);
}
}
