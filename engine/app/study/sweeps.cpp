#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/ball.hpp"
#include "engine/app/study/probe_space.hpp"
#include "engine/app/study/spectra.hpp"
#include "engine/app/study/sweeps.hpp"
#include "engine/app/study/triangles.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/frame/plan_rules.hpp"
#include "engine/gpu/shader.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kStill = 16, kStillLong = 64; // frames gathered: of a point, and of its limit
constexpr int kManyFrames = 32;             // whose mean has lost what single frames scatter by

template <class Part, class Field>
Knob of(Part Settings::*part, Field Part::*field)
{
    return {[=](const Setup& s) { return double(s.settings.*part.*field); },
            [=](Setup& s, double value) { s.settings.*part.*field = Field(value); }};
}

Knob ofTruth(int TruthOptions::*field)
{
    return {[=](const Setup&) { return double(TruthOptions{}.*field); }, [=](Setup& s, double value) { s.truth.*field = int(value); }};
}

// All maps of a frame by one factor.
Knob mapTexels()
{
    return {[](const Setup&) { return 1.0; },
            [](Setup& s, double factor) {
                ShadowParameters& p = s.settings.shadow;
                for (uint ShadowParameters::*texels : {&ShadowParameters::sunTexels, &ShadowParameters::spotTexels,
                                                       &ShadowParameters::faceTexels, &ShadowParameters::cascadeTexels})
                    p.*texels = uint(std::lround(double(p.*texels) * factor));
                p.finestTexel = float(double(p.finestTexel) / factor);
            }};
}

Knob gathered()
{
    return {[](const Setup&) { return double(kStill); }, [](Setup& s, double frames) { s.gathered = int(frames); }};
}

Knob renderScale()
{
    return {[](const Setup& s) { return double(s.settings.renderScale); },
            [](Setup& s, double share) { s.settings.renderScale = float(share); }};
}

Knob lodError()
{
    return {[](const Setup& s) { return double(s.settings.lodError); }, [](Setup& s, double px) { s.settings.lodError = float(px); }};
}

Knob reflectionMethod()
{
    return {[](const Setup& s) { return double(s.settings.reflectionMethod == ReflectionMethod::ray); },
            [](Setup& s, double ray) { s.settings.reflectionMethod = ray > 0.0 ? ReflectionMethod::ray : ReflectionMethod::screen; }};
}

Knob tracing()
{
    return {[](const Setup& s) { return double(s.settings.tracing); },
            [](Setup& s, double way) { s.settings.tracing = Tracing(int(way)); }};
}
bool canTraceBy(const Device& device, double way) { return canTrace(device, Tracing(int(way))); }
constexpr double kKernel = double(Tracing::kernel), kPipeline = double(Tracing::pipeline), kWavefront = double(Tracing::wavefront);

Knob denoiser()
{
    return {[](const Setup& s) { return s.bake.denoiser == Denoiser::builtin ? 1.0 : 0.0; },
            [](Setup& s, double on) { s.bake.denoiser = on > 0.0 ? Denoiser::builtin : Denoiser::none; }};
}

Knob spectral()
{
    return {[](const Setup& s) { return double(s.truth.spectral); }, [](Setup& s, double on) { s.truth.spectral = on > 0.0; }};
}

Knob wavefront()
{
    return {[](const Setup& s) { return double(s.truth.organisation == Organisation::wavefront); },
            [](Setup& s, double on) { s.truth.organisation = on > 0.0 ? Organisation::wavefront : Organisation::loop; }};
}

// Of a picture that is made for a value: what the program itself takes.
Knob standing(double value)
{
    return {[=](const Setup&) { return value; }, {}};
}

constexpr double kNoDefault = 0.0; // of what is no choice

Image channelsBy(const Studio& studio, double bounces) { return reflectedBy(studio, kThreeChannels, int(bounces)); }
Image wavelengthsBy(const Studio& studio, double bounces) { return reflectedBy(studio, kEveryWavelength, int(bounces)); }
Image channelsOff(const Studio& studio, double width) { return reflectedOff(studio, kThreeChannels, width); }
Image wavelengthsOff(const Studio& studio, double width) { return reflectedOff(studio, kEveryWavelength, width); }

std::function<void(Setup&)> by(OcclusionMethod method)
{
    return [method](Setup& s) { s.settings.occlusionMethod = method; };
}
void traced(Setup& s) { s.settings.shadowMethod = ShadowMethod::ray; }
void rough(Setup& s) { traced(s), s.settings.effects.forced["shadow.denoise"] = false; }
void roughContact(Setup& s) { by(OcclusionMethod::ray)(s), s.settings.effects.forced["occlusion.denoise"] = false; }
void unfiltered(Setup& s) { s.bake.denoiser = Denoiser::none; }
void filtered(Setup& s) { s.bake.denoiser = Denoiser::builtin; }
void fewPaths(Setup& s) { s.truth.samples = 8; }
void evenPaths(Setup& s) { s.truth.samples = 32; }
void onGpu(Setup& s) // one sample, of a seed that no truth has
{
    s.settings.mode = Mode::truth;
    s.settings.truth.seed = 505;
}
void still(Setup& s) { s.gathered = kStill; }

constexpr const char* kManyPaths = "the same by four times the paths of the default, all bounces, no filter";
constexpr const char* kManySamples = "4096 samples of the lobe";
constexpr const char* kManyWavelengths = "940 wavelengths, after 1 to 8 bounces off bands of 10 to 160 nm";
constexpr const char* kTracedLong = "the same by 64 rays, the mean of 32 frames";
constexpr double kHalf = -0.5; // of what is drawn by lot
}

std::vector<Sweep> knobs()
{
    using S = Settings;
    using Shadow = ShadowParameters;
    using Occlusion = OcclusionParameters;
    using Reflection = ReflectionParameters;
    const auto tracedWell = [](Setup& s) { rough(s), s.settings.shadow.rays = 64; };
    const auto nativeLong = [](Setup& s) { s.gathered = kStillLong; };
    const auto manySamples = [](Setup& s) { unfiltered(s), s.bake.samples = 4 * *s.bake.samples; };
    const auto noisyProbes = [](Setup& s) { s.bake.reflectionSamples = 8; };
    // A knob, a line. Sweeps with the same words of `against` share that limit
    // clang-format off
    std::vector<Sweep> all = {
        {.subject = "lods", .knob = "error", .unit = "px", .values = {8, 4, 2, 1, 0.5, 0.25}, .turn = lodError(), .limit = 0.01, .clock = Clock::frame, .law = {1, "as much as is asked for"}, .staged = true},
        {.subject = "shadow", .knob = "map texels", .unit = "times the default", .values = {0.125, 0.25, 0.5, 1, 2}, .turn = mapTexels(), .limit = 1, .clock = Clock::frame, .law = {-1, "down to what a hard shadow lacks of a soft one"}, .instead = tracedWell, .against = kTracedLong, .frames = kManyFrames, .rays = true},
        {.subject = "shadow", .knob = "rays", .unit = "per pixel and light that has a size", .values = {4, 8, 16, 32, 64}, .turn = of(&S::shadow, &Shadow::rays), .limit = 64, .clock = Clock::frame, .law = {{}, "by lot, and what a filter takes for it"}, .given = traced, .instead = tracedWell, .against = kTracedLong, .frames = kManyFrames, .rays = true},
        {.subject = "shadow", .knob = "unfiltered rays", .unit = "per pixel and light that has a size", .values = {4, 8, 16, 32, 64}, .turn = of(&S::shadow, &Shadow::rays), .limit = 64, .clock = Clock::frame, .law = {kHalf, "by lot"}, .given = rough, .instead = tracedWell, .against = kTracedLong, .frames = kManyFrames, .rays = true},
        {.subject = "occlusion", .knob = "hbao steps", .unit = "to each side", .values = {1, 2, 3, 6, 12, 24}, .turn = of(&S::occlusion, &Occlusion::steps), .held = Held::visibility, .law = {-1, "down to what the screen hides"}, .given = by(OcclusionMethod::hbao), .staged = true},
        {.subject = "occlusion", .knob = "hbao slices", .unit = "through the line of sight", .values = {1, 2, 4, 8}, .turn = of(&S::occlusion, &Occlusion::slices), .held = Held::visibility, .law = {}, .given = by(OcclusionMethod::hbao), .staged = true},
        {.subject = "occlusion", .knob = "ssao samples", .unit = "of the hemisphere", .values = {4, 8, 16, 32, 64}, .turn = of(&S::occlusion, &Occlusion::samples), .held = Held::visibility, .law = {kHalf, "down to its bias"}, .given = by(OcclusionMethod::ssao), .staged = true},
        {.subject = "occlusion", .knob = "voxel cones", .unit = "", .values = {2, 4, 8, 16}, .turn = of(&S::occlusion, &Occlusion::cones), .held = Held::visibility, .law = {}, .given = by(OcclusionMethod::voxel), .staged = true},
        {.subject = "occlusion", .knob = "rays", .unit = "per pixel of half the resolution", .values = {1, 2, 4, 8, 16, 32}, .turn = of(&S::occlusion, &Occlusion::rays), .held = Held::visibility, .law = {kHalf, "by lot, down to edges at half the resolution"}, .given = by(OcclusionMethod::ray), .staged = true, .rays = true},
        {.subject = "occlusion", .knob = "averaged rays", .unit = "per pixel of half the resolution", .values = {1, 2, 4, 8, 16, 32}, .turn = of(&S::occlusion, &Occlusion::rays), .held = Held::visibility, .law = {kHalf, "by lot, down to edges at half the resolution"}, .given = roughContact, .staged = true, .rays = true},
        {.subject = "reflection", .knob = "steps", .unit = "of a ray across the screen", .values = {8, 16, 32, 64, 128}, .turn = of(&S::reflection, &Reflection::steps), .limit = 256, .law = {-1, "the distance of the hit"}, .staged = true},
        {.subject = "reflection", .knob = "bisections", .unit = "of a hit", .values = {0, 1, 2, 4}, .turn = of(&S::reflection, &Reflection::bisections), .limit = 8, .law = {{}, "halves the distance each time"}, .staged = true},
        {.subject = "reflection", .knob = "thickness", .unit = "share of the distance", .values = {0.0025, 0.005, 0.01, 0.02, 0.04, 0.08}, .turn = of(&S::reflection, &Reflection::thickness), .held = Held::picture, .law = {{}, "a guess: no limit to converge to"}, .given = still, .staged = true},
        {.subject = "reflection", .knob = "method", .unit = "", .values = {0, 1}, .turn = reflectionMethod(), .held = Held::picture, .clock = Clock::frame, .law = {}, .given = still, .names = {"screen", "ray"}, .rays = true},
        {.subject = "fog", .knob = "steps", .unit = "of a ray", .values = {1, 2, 4, 8, 16, 32, 64}, .turn = of(&S::fog, &FogParameters::steps), .limit = 256, .law = {-1, "shadows in the air; without any, one step is exact"}, .staged = true},
        {.subject = "fog", .knob = "divisor", .unit = "of the resolution", .values = {4, 2}, .turn = of(&S::fog, &FogParameters::divisor), .limit = 1, .law = {}, .staged = true},
        {.subject = "portal", .knob = "depth", .unit = "portals", .values = {0, 1, 2, 3}, .turn = of(&S::portal, &PortalParameters::depth), .limit = 8, .law = {}, .staged = true},
        {.subject = "bloom", .knob = "coarsest level", .unit = "px", .values = {128, 64, 32, 16, 8}, .turn = of(&S::bloom, &BloomParameters::coarsest), .limit = 2, .law = {{}, "energy is exact at every level; its reach is not"}, .staged = true, .displayed = true},
        {.subject = "antialias", .knob = "frames", .unit = "gathered", .values = {1, 2, 4, 8, 16, 32}, .turn = gathered(), .limit = 128, .clock = Clock::gathered, .law = {-0.75, "one sample in each part of a pixel"}, .staged = true, .displayed = true},
        {.subject = "upscale", .knob = "render scale", .unit = "of width and height", .values = {0.25, 0.33, 0.5, 0.67, 0.8, 1}, .turn = renderScale(), .limit = 1, .clock = Clock::frame, .law = {}, .given = still, .instead = nativeLong, .against = "the same drawn at its own size, 64 frames gathered", .displayed = true},
        {.subject = "lightmaps", .knob = "density", .unit = "texels per metre", .values = {0.125, 0.25, 0.5, 1}, .turn = ofBake(&BakeOptions::texelsPerMetre), .limit = 2, .clock = Clock::bake, .law = {-1, "across hard edges; -2 where light is smooth"}, .relative = true},
        {.subject = "lightmaps", .knob = "paths", .unit = "per texel, no filter", .values = {0.03125, 0.0625, 0.125, 0.25, 0.5, 1}, .turn = ofBake(&BakeOptions::samples), .limit = 4, .clock = Clock::bake, .law = {kHalf, "by lot"}, .given = unfiltered, .against = kManyPaths, .relative = true},
        {.subject = "reflections", .knob = "face size", .unit = "texels", .values = {0.125, 0.25, 0.5, 1}, .turn = ofBake(&BakeOptions::reflectionSize), .limit = 2, .clock = Clock::bake, .law = {-1, "across edges"}, .given = noisyProbes, .relative = true},
        {.subject = "denoise", .knob = "filter", .unit = "", .values = {0, 1}, .turn = denoiser(), .limit = 0, .clock = Clock::bake, .law = {}, .product = "lightmaps", .instead = manySamples, .against = kManyPaths, .names = {"none", "builtin"}},
        {.subject = "denoise", .knob = "filtered paths", .unit = "per texel, built-in filter", .values = {0.03125, 0.0625, 0.125, 0.25, 0.5, 1}, .turn = ofBake(&BakeOptions::samples), .limit = 0, .clock = Clock::bake, .law = {{}, "by lot, and what a filter takes for it"}, .product = "lightmaps", .given = filtered, .instead = manySamples, .against = kManyPaths, .relative = true},
        {.subject = "bounces", .knob = "lightmap bounces", .unit = "", .values = {0, 1, 2, 4, 8, 64}, .turn = ofBake(&BakeOptions::bounces), .limit = 64, .clock = Clock::bake, .law = {{}, "each bounce leaves the albedo's share, down to the noise of the paths"}, .product = "lightmaps", .given = unfiltered, .instead = manySamples, .against = kManyPaths},
        {.subject = "bounces", .knob = "path bounces", .unit = "", .values = {0, 1, 2, 4, 8, 64}, .turn = ofTruth(&TruthOptions::bounces), .limit = 64, .clock = Clock::truth, .law = {{}, "each bounce leaves the albedo's share"}, .given = fewPaths, .against = "the same after 64 bounces, by the same random numbers", .bias = true},
        {.subject = "roulette", .knob = "first bounce", .unit = "after which a path may end by chance", .values = {0, 1, 2, 4, 8, 64}, .turn = ofTruth(&TruthOptions::rouletteFrom), .held = Held::picture, .clock = Clock::truth, .law = {{}, "no bias: what is saved is spent as noise"}, .given = fewPaths},
        {.subject = "harmonics", .knob = "order", .unit = "of spherical harmonics", .values = {0, 1, 2}, .turn = standing(2), .limit = kExact, .clock = Clock::making, .law = {{}, "a clamped cosine leaves 5/8, 1/8 and 1/128 of its energy to higher orders"}, .made = matteBall, .against = "every texel of the surroundings"},
        {.subject = "split sum", .knob = "samples", .unit = "of the lobe", .values = {1, 4, 16, 64, 256}, .turn = standing(kSplitSum), .limit = 4096, .clock = Clock::making, .law = {kHalf, "by lot"}, .made = glossyBall, .against = kManySamples},
        {.subject = "split sum", .knob = "look-up", .unit = "", .values = {kSplitSum}, .turn = standing(kSplitSum), .limit = 4096, .clock = Clock::making, .law = {{}, "a bias: largest at grazing angles"}, .made = glossyBall, .against = kManySamples, .names = {"prefiltered"}},
        {.subject = "spectrum", .knob = "wavelengths", .unit = "evenly from 360 to 830 nm", .values = {6, 12, 24, 47, 94, 188}, .turn = standing(kThreeChannels), .limit = kEveryWavelength, .clock = Clock::making, .law = {{}, "faster than any power once the steps are narrower than the bands"}, .made = reflectedLight, .against = kManyWavelengths},
        {.subject = "spectrum", .knob = "channels", .unit = "", .values = {kThreeChannels}, .turn = standing(kThreeChannels), .limit = kEveryWavelength, .clock = Clock::making, .law = {{}, "a bias: it grows with the bounces, and as bands narrow"}, .made = reflectedLight, .against = kManyWavelengths, .names = {"three channels"}},
        {.subject = "spectrum", .knob = "channels by bounces", .unit = "", .values = {1, 2, 3, 4, 5, 6, 7, 8}, .turn = standing(kNoDefault), .clock = Clock::making, .law = {{}, "each multiplies channels where it should multiply spectra"}, .made = channelsBy, .exact = wavelengthsBy, .against = "940 wavelengths, off bands of 10 to 160 nm"},
        {.subject = "spectrum", .knob = "channels by width", .unit = "nm, standard deviation of a band", .values = {10, 20, 40, 80, 160}, .turn = standing(kNoDefault), .clock = Clock::making, .law = {{}, "bands narrower than a channel's lie between the channels"}, .made = channelsOff, .exact = wavelengthsOff, .against = "940 wavelengths, after 1 to 8 bounces"},
        {.subject = "spectrum", .knob = "paths", .unit = "", .values = {0, 1}, .turn = spectral(), .limit = 1, .clock = Clock::truth, .law = {}, .given = evenPaths, .against = "the level's picture path traced by wavelength, by the same random numbers", .names = {"three channels", "three wavelengths"}, .bias = true},
        {.subject = "truth", .knob = "tracing", .unit = "on the GPU", .values = {kKernel, kPipeline, kWavefront}, .turn = tracing(), .held = Held::picture, .law = {{}, "the same random numbers: what differs is time"}, .given = onGpu, .names = {"kernel", "pipeline", "wavefront"}, .able = canTraceBy, .slow = true},
        {.subject = "truth", .knob = "paths", .unit = "per pixel", .values = {1, 2, 4, 8, 16, 32, 64}, .turn = ofTruth(&TruthOptions::samples), .held = Held::picture, .clock = Clock::truth, .law = {kHalf, "by lot"}},
        {.subject = "truth", .knob = "organisation", .unit = "on the CPU", .values = {0, 1}, .turn = wavefront(), .held = Held::picture, .clock = Clock::truth, .law = {{}, "the same paths: only the time differs"}, .given = fewPaths, .names = {"loop", "wavefront"}},
    };
    // clang-format on
    for (auto more : {probeSweeps(), triangleSweeps()})
        for (Sweep& sweep : more) all.push_back(std::move(sweep));
    return all;
}

Sweep drawnOrNot(const std::string& effect)
{
    Sweep sweep{.subject = effect, .knob = kDrawn, .values = {0, 1}, .held = Held::picture, .clock = Clock::frame, .given = still};
    sweep.names = {"off", "on"};
    sweep.turn = {[](const Setup&) { return 1.0; }, [effect](Setup& s, double on) { s.settings.effects.forced[effect] = on > 0.0; }};
    if (effect == "toon" || effect == "outline") { // a style is its own truth, at rest
        sweep.held = Held::limit, sweep.limit = 1, sweep.against = "the style at rest, 64 frames gathered";
        sweep.instead = [](Setup& s) { s.gathered = kStillLong; };
    }
    return sweep;
}

namespace
{
// Beside the effects of the plan: what is studied where an effect is on.
struct Beside {
    const char *subject, *effect;
};
constexpr Beside kBeside[] = {{"denoise", "lightmaps"},     {"bounces", "lightmaps"},     {"roulette", "lighting"},
                              {"harmonics", "reflections"}, {"split sum", "reflections"}, {"truth", "lighting"},
                              {"spectrum", "lighting"},     {"triangles", "lighting"}};

struct Asked {
    const char *subject, *question;
};
// Of subjects that have no README among the effects.
constexpr Asked kQuestions[] = {
    {"masked", "What do leaves, fences and letters cut out of their surfaces cost?"},
    {"shadow.denoise", "Which of the differences between a penumbra's pixels are only the lot of their few rays?"},
    {"occlusion.denoise", "Which of the differences between neighbours' visibility are only the lot of their few rays?"},
    {"shadow.cascades", "How sharp is a sun's shadow before the eye when the level is large?"},
    {"lightmaps", "How much light comes to each static surface by way of all the others?"},
    {"directional", "What does baked light make of the normals of a normal map?"},
    {"probes", "How much light from everywhere meets what moves, and what has no lightmap?"},
    {"reflections", "What do surfaces mirror of their surroundings, blurred as their roughness asks?"},
    {"clear", "What do glass and blended surfaces show of what is behind them?"},
    {"denoise", "Can a filter stand for paths that were not traced?"},
    {"bounces", "How often must light be followed from surface to surface?"},
    {"roulette", "From when on may a path of light end by chance, the rest paying for it?"},
    {"harmonics", "Do nine numbers hold the light that meets a matte surface from everywhere?"},
    {"spectrum", "Do three channels stand for a spectrum?"},
    {"triangles", "What does a triangle more cost a ray, and what a raster?"},
    {"split sum", "Does one look-up of a blurred picture stand for the hundreds of samples that a rough mirror asks for?"},
};

// The first paragraph under the heading of the effect's own study.
std::string ownQuestion(const std::filesystem::path& readme)
{
    static const std::string kHeading = "## Question\n";
    const std::string text = readText(readme);
    const std::size_t at = text.find(kHeading);
    check(at != std::string::npos, "every effect's README opens with its question (cmake/effect.cmake)");
    std::string question = text.substr(at + kHeading.size());
    question.resize(std::min(question.find("\n\n"), question.size()));
    std::replace(question.begin(), question.end(), '\n', ' ');
    std::erase(question, '`'); // of Markdown, which a page is not
    return question;
}
}

std::string questionOf(const std::string& subject)
{
    for (const Asked& own : kQuestions)
        if (subject == own.subject) return own.question;
    return ownQuestion(shaderRoot() / "engine/effects" / subject / "README.md");
}

std::string calledBy(const std::string& subject)
{
    for (const Beside& beside : kBeside)
        if (subject == beside.subject) return beside.effect;
    return subject;
}

std::vector<std::string> subjectNames(const std::vector<std::string>& wanted)
{
    std::vector<std::string> known;
    for (const Rule& rule : rules())
        if (!rule.always) known.push_back(rule.effect);
    for (const Beside& beside : kBeside) known.push_back(beside.subject);
    if (wanted.empty()) return known;
    std::string list;
    for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
    for (const std::string& name : wanted)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw Error(fmt::format("--effects {}: there is nothing of that name to study; there are {}", name, list), Exit::usage);
    std::erase_if(known, [&](const std::string& name) { return std::find(wanted.begin(), wanted.end(), name) == wanted.end(); });
    return known;
}
}
