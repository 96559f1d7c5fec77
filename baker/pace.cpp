#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/pace.hpp"
#include "baker/probes.hpp"
#include "engine/core/error.hpp"
#include "engine/core/log.hpp"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace afterglow
{
using nlohmann::json;

namespace
{
// Paths of the two trials: a lightmap texel's, a probe's, a reflection's texel's.
constexpr int kFewPaths = 2, kMorePaths = 10, kFewProbe = 32, kMoreProbe = 96, kFewReflection = 2, kMoreReflection = 10;
constexpr double kOfFewPaths = 0.25;               // of a lightmap's or a cubemap's time with so few: 0.11 to 0.23 in four levels
constexpr float kUncut = 10.0f;                    // relative: no light between probes errs by so much
constexpr double kTrials = 4.0, kMostTrying = 0.5; // trials, and the share of the time that they may take
constexpr double kFewest = 0.25;                   // of a quality's paths: with fewer the next quality is less noisy
constexpr double kTested = 2.5;                    // paths of tests, for each of a probe's least: five of a cell, which has two probes
constexpr double kAllotted = 0.4;                  // of noise, where paths go to the probes that need them: .2 to .65 in four levels
constexpr int kSteps = 12, kStepsOfHalf = 4;       // of density: down to an eighth, by fourth roots of 2

double square(double x) { return x * x; }
double cube(double x) { return x * x * x; }

double texelsOf(const Pace& pace, const BakeOptions& o) { return o.lightmaps ? pace.texels * square(double(*o.texelsPerMetre)) : 0.0; }

struct Trial {
    TrialBake tried;
    json products;
    double seconds = 0.0; // of them all, and of what comes before them
};

Trial tryBake(const Scene& scene, const BakeOptions& options, Progress& progress)
{
    const auto began = std::chrono::steady_clock::now();
    json manifest;
    Baked baked = bakeScene(scene, options, progress, manifest);
    return {{std::move(baked), *options.samples, *options.texelsPerMetre},
            manifest.value("products", json::object()),
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count()};
}

double valueOf(const json& products, const char* product, const char* what)
{
    return products.contains(product) ? products[product].value(what, 0.0) : 0.0;
}

// Of what goes by paths and texels: where reflection probes stand takes as long whatever these are.
double secondsIn(const json& products, const char* product)
{
    return valueOf(products, product, "seconds") - valueOf(products, product, "place_seconds");
}

// Seconds of a stage: some whatever its paths are, and some for each.
struct Line {
    double fixed = 0.0, path = 0.0;
};
// Through two trials. Half of the time at least is taken to go by paths, and just that where clocks tell no more. Of one trial alone the
// share `alone`.
Line lineOf(int fewer, double shorter, int paths, double longer, double alone)
{
    Line line;
    line.path = longer > 0.0 ? std::max((longer - shorter) / (paths - fewer), 0.5 * longer / paths) : alone * shorter / fewer;
    line.fixed = std::max(shorter - fewer * line.path, 0.0);
    return line;
}

std::string wordsOf(const BakeOptions& o, bool density)
{
    std::string words = fmt::format("--quality {}", nameOf(o.quality));
    if (!o.lightmaps) return words;
    words += fmt::format(" --samples {}", *o.samples);
    if (density) words += fmt::format(" --texels-per-metre {:.9g}", *o.texelsPerMetre);
    return words;
}
}

// Paths of a probe, mean over those of tests: as many as the noise of lookups asks for.
static double probePathsOf(const Pace& pace, const BakeOptions& o)
{
    const double least = double(*o.probeSamples), needed = o.probeNoise ? square(pace.noise / double(*o.probeNoise)) : 0.0;
    return (std::clamp(needed, least, kMoreProbePaths * least) + kTested * least) / (1.0 + kTested);
}

double secondsOf(const Pace& pace, const BakeOptions& o)
{
    double seconds = pace.fixed + texelsOf(pace, o) * (pace.texel + pace.path * double(*o.samples));
    if (o.probes)
        seconds +=
            (pace.probe + pace.probePath * probePathsOf(pace, o)) * pace.probes / cube(double(*o.probeSpacing)) *
            (*o.probeError > 0.0f ? std::max(std::pow(pace.between * square(double(*o.probeSpacing)) / double(*o.probeError), kCuts), 1.0)
                                  : 1.0);
    if (o.reflections)
        seconds +=
            (pace.reflection + pace.reflectionPath * double(*o.reflectionSamples)) * pace.reflections * square(double(*o.reflectionSize));
    return seconds;
}

static bool isKnown(const PaceError& error) { return error.noise > 0.0 || error.texels > 0.0; }

// Of the densities up to the quality's, each with as many paths as fit, the one with the least error; where no error is known, the
// quality's own. `fewest`: paths; nothing where there is no time for them.
static std::optional<BakeOptions> balanced(const Pace& pace, const BakeOptions& quality, double fewest, double seconds)
{
    std::optional<BakeOptions> best;
    for (int step = 0; step <= (isKnown(pace.error) ? kSteps : 0); ++step) {
        BakeOptions options = quality;
        *options.texelsPerMetre *= float(std::exp2(-double(step) / kStepsOfHalf));
        options.samples = 0;
        const double room = seconds - secondsOf(pace, options), each = texelsOf(pace, options) * pace.path;
        const double most = each > 0.0 ? room / each : double(*quality.samples);
        if (room < 0.0 || most < fewest) continue;
        options.samples = int(std::min(most, double(*quality.samples)));
        if (!best || errorOf(pace.error, options) < errorOf(pace.error, *best)) best = options;
    }
    return best;
}

static double fewestOf(const BakeOptions& quality) { return std::max(std::ceil(kFewest * *quality.samples), 1.0); }

// What its time leaves over goes to its lightmaps, as fine as those of the finest quality.
static BakeOptions finer(const Pace& pace, const BakeOptions& fits, const BakeOptions& finest, double seconds)
{
    BakeOptions most = fits;
    most.samples = finest.samples;
    if (isKnown(pace.error)) most.texelsPerMetre = finest.texelsPerMetre;
    const std::optional<BakeOptions> better = balanced(pace, most, double(*fits.samples), seconds);
    return better && errorOf(pace.error, *better) <= errorOf(pace.error, fits) ? *better : fits;
}

Paced within(const Pace& pace, const std::vector<BakeOptions>& finest, double seconds)
{
    check(!finest.empty(), "a quality to choose from");
    std::optional<BakeOptions> best;
    for (const BakeOptions& quality : finest) {
        const std::optional<BakeOptions> fits = balanced(pace, quality, fewestOf(quality), seconds);
        if (fits && (!best || errorOf(pace.error, *fits) < errorOf(pace.error, *best))) best = fits;
    }
    if (best) *best = finer(pace, *best, finest.front(), seconds);
    if (best) return {*best, secondsOf(pace, *best), true};

    BakeOptions chosen = finest.back();
    chosen.samples = int(fewestOf(chosen));
    BakeOptions bare = chosen;
    bare.lightmaps = false;
    const double lightmaps = secondsOf(pace, chosen) - secondsOf(pace, bare), room = seconds - secondsOf(pace, bare);
    if (lightmaps > 0.0) *chosen.texelsPerMetre *= float(std::sqrt(std::clamp(room / lightmaps, kFewestTexels, 1.0)));
    const double needed = secondsOf(pace, chosen);
    return {chosen, needed, needed <= seconds * (1.0 + 1e-6)}; // texels are found by a root
}

Pace paceOf(const Scene& scene, const BakeOptions& asked, double seconds, Progress& progress)
{
    Progress untold(ProgressStyle::none); // stages of a trial are nobody's business, nor what it says
    const Hush hush;
    progress.begin("trial", 3, "steps");
    BakeOptions few = asked;
    few.quality = Quality::draft;
    few.samples = kFewPaths, few.probeSamples = kFewProbe, few.reflectionSamples = kFewReflection;
    few.probeError = kUncut, few.probeNoise = 1e9f; // as many probes and paths as are said, and what they err by
    few = resolved(few, scene);
    const Trial first = tryBake(scene, few, untold);
    progress.advance(1);
    BakeOptions more = few;
    more.samples = kMorePaths, more.probeSamples = kMoreProbe, more.reflectionSamples = kMoreReflection, more.seed = few.seed + 1;
    more.lods = more.voxels = false;

    Pace pace;
    const json& products = first.products;
    const double traced = secondsIn(products, "lightmaps") + secondsIn(products, "probes") + secondsIn(products, "reflections");
    pace.fixed = std::max(first.seconds - traced, 0.0);
    const bool late = kTrials * first.seconds > kMostTrying * seconds;
    std::optional<Trial> second;
    if (!late) second = tryBake(scene, more, untold);
    progress.advance(1);
    const auto byPaths = [&](const char* product, int fewer, int paths, double alone = 0.5) {
        return lineOf(fewer, secondsIn(products, product), paths, second ? secondsIn(second->products, product) : 0.0, alone);
    };
    if (const double texels = valueOf(products, "lightmaps", "valid_texels"); texels > 0.0) {
        const Line line = byPaths("lightmaps", kFewPaths, kMorePaths, kOfFewPaths);
        pace.texel = line.fixed / texels, pace.path = line.path / texels;
        pace.texels = texels / square(double(*few.texelsPerMetre));
        if (second) {
            more.probes = more.reflections = false;
            *more.texelsPerMetre *= 0.5f;
            const Trial half = tryBake(scene, more, untold);
            *more.texelsPerMetre *= 0.5f;
            pace.error = paceError(first.tried, second->tried, half.tried, tryBake(scene, more, untold).tried);
        }
    }
    if (const double count = valueOf(products, "probes", "count"); count > 0.0) {
        const Line line = byPaths("probes", kFewProbe, kMoreProbe);
        pace.probe = line.fixed / count, pace.probePath = line.path / count;
        if (second) pace.noise = kAllotted * valueOf(second->products, "probes", "estimated_error") * std::sqrt(double(kMoreProbe));
        pace.between = valueOf(products, "probes", "interpolation_error") / square(double(*few.probeSpacing));
        pace.probes = count * cube(double(*few.probeSpacing));
    }
    pace.reflections = valueOf(products, "reflections", "count");
    if (pace.reflections > 0.0) {
        const double texels = pace.reflections * square(double(*few.reflectionSize));
        const Line line = byPaths("reflections", kFewReflection, kMoreReflection, kOfFewPaths);
        pace.reflection = line.fixed / texels, pace.reflectionPath = line.path / texels;
    }
    progress.advance(1); // of those that were not begun, too: the trial is over
    progress.end();
    return pace;
}

BakeOptions paced(const Scene& scene, const BakeOptions& asked, double seconds, Progress& progress, json& manifest)
{
    const auto began = std::chrono::steady_clock::now();
    const Pace pace = paceOf(scene, asked, seconds, progress);
    const double tried = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    std::vector<BakeOptions> finest;
    for (int quality = int(asked.quality); quality >= 0; --quality) {
        BakeOptions options = asked;
        options.quality = Quality(quality);
        finest.push_back(resolved(options, scene));
    }
    const Paced kept = within(pace, finest, (1.0 - kPaceMargin) * seconds - tried);
    const auto own = std::find_if(finest.begin(), finest.end(), [&](const auto& o) { return o.quality == kept.options.quality; });
    const bool another = *kept.options.texelsPerMetre != *own->texelsPerMetre; // density
    const double error = kept.options.lightmaps ? errorOf(pace.error, kept.options) : 0.0;
    const std::string off = error > 0.0 ? fmt::format(", lightmaps off by about {:.2g} %", 100.0 * error) : "";
    const std::string words = wordsOf(kept.options, another), most = wordsOf(finest.front(), another);
    note(fmt::format("--time-budget {:g}: {}{}; about {:.3g} s after {:.3g} s of trial{}", seconds,
                     kept.fits ? "" : "no bake of this level fits, so the quickest is made: ", words, kept.seconds, tried, off));
    if (words != most) note(fmt::format("given up for it: {}", most));
    manifest["time_budget"] = {
        {"seconds", seconds}, {"trial_seconds", tried}, {"expected_seconds", kept.seconds},     {"expected_error", error},
        {"fits", kept.fits},  {"chosen", words},        {"given_up", words != most ? most : ""}};
    return kept.options;
}
}
