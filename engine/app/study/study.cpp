// `afterglow study`: what every effect and product that a level calls for is off by, and what it costs to be nearer.
#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/level.hpp"
#include "engine/app/runtime_verbs.hpp"
#include "engine/app/study/advice.hpp"
#include "engine/app/study/choice.hpp"
#include "engine/app/study/files.hpp"
#include "engine/app/study/foreseen.hpp"
#include "engine/app/study/law.hpp"
#include "engine/app/study/probe_space.hpp"
#include "engine/app/study/readme.hpp"
#include "engine/app/study/studio.hpp"
#include "engine/app/study/study.hpp"
#include "engine/app/study/sweeps.hpp"
#include "engine/app/study/triangles.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/jobs.hpp"
#include "engine/core/log.hpp"
#include "engine/core/machine.hpp"
#include "engine/core/scaffold.hpp"
#include "engine/gpu/shader.hpp"
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

namespace afterglow
{
namespace
{
constexpr float kQuickDensity = 0.5f; // of a draft's lightmaps: a study bakes them some twenty times
constexpr int kQuickPaths = 128;      // of each of the two truths: 18 % noise of a pixel in the gallery, where 32 leave 33 %
constexpr const char* kFiles[] = {"study.csv", "study.json", "study.html"};

// Where the folder will stand: nothing but a study gives way to a study. Throws Error.
std::filesystem::path studyPlace(const std::filesystem::path& directory)
{
    const std::filesystem::path place = placeOf(directory);
    std::error_code none;
    if (!std::filesystem::exists(place, none)) return place;
    if (!std::filesystem::is_directory(place, none))
        throw Error("cannot write " + place.string() + ": it exists and is not a study; name another folder, or remove it first");
    for (const auto& entry : std::filesystem::directory_iterator(place))
        if (std::find(std::begin(kFiles), std::end(kFiles), entry.path().filename().string()) == std::end(kFiles))
            throw Error("cannot write " + place.string() + ": beside a study it would take " + entry.path().filename().string() +
                        " along; name another folder, or move that away");
    return place;
}

Setup standardOf(const StudyCommand& command, const Scene& level, const Camera& camera)
{
    Setup setup;
    setup.settings = adoptLevel({}, level);
    setup.settings.occlusionRange = setup.settings.occlusion.range; // one range for the truth of visibility, whatever is baked
    setup.settings.size = command.size.value_or(command.quick ? uvec2(256, 144) : uvec2(384, 216));
    setup.bake.quality = command.quick ? Quality::draft : Quality::medium;
    setup.bake = resolved(setup.bake, level);
    if (command.quick) *setup.bake.texelsPerMetre *= kQuickDensity;
    setup.truth.camera = camera;
    setup.truth.size = ivec2(setup.settings.size);
    setup.truth.samples = command.samples.value_or(command.quick ? kQuickPaths : 256);
    return setup;
}

Truth tracePicture(const Studio& studio, ProgressStyle style)
{
    Progress progress(style);
    TruthOptions options = studio.standard.truth;
    options.seed = 1;
    Image a = truth(studio.level, options, progress);
    options.seed = 2;
    return truthOf(std::move(a), truth(studio.level, options, progress));
}

// A chart is what is held against one truth and timed by one clock. Where each value has a truth of its own there is nothing to choose.
void advise(Subject& subject)
{
    std::map<std::pair<std::string, Clock>, std::vector<Curve*>> charts;
    for (Curve& curve : subject.curves)
        if (curve.sweep.exact)
            curve.advice = adviceOf(curve, {});
        else if (!curve.sweep.timed)
            charts[{curve.truth, curve.sweep.clock}].push_back(&curve);
    for (auto& [key, curves] : charts) {
        std::vector<Point*> points;
        for (Curve* curve : curves)
            for (Point& point : curve->points) points.push_back(&point);
        markPareto(points);
        for (Curve* curve : curves) curve->advice = adviceOf(*curve, std::vector<const Curve*>(curves.begin(), curves.end()));
    }
}

// Without the shares of what a knob stands at that are none of what it counts, such as half a path.
void dropNone(const Studio& studio, Sweep& sweep)
{
    std::erase_if(sweep.values, [&](double share) {
        Setup setup = given(studio, sweep);
        const double wanted = share * sweep.turn.get(setup);
        sweep.turn.set(setup, wanted);
        return sweep.turn.get(setup) < 0.5 * wanted;
    });
}

// What is studied, as empty subjects with their sweeps.
std::vector<std::pair<Subject, std::vector<Sweep>>> chosen(const StudyCommand& command, const Studio& studio, const Plan& planned,
                                                           Report& report)
{
    std::vector<std::pair<Subject, std::vector<Sweep>>> work;
    for (const std::string& name : studied(command, planned, report.absent)) {
        const PlannedEffect& effect = callerOf(name, planned);
        const std::string reason = effect.on           ? "on, " + effect.reason
                                   : name == "upscale" ? "off unless --render-scale asks"
                                                       : "asked for, though " + effect.reason;
        Subject subject{name, questionOf(name), effect.effect == name ? reason : effect.effect + " " + reason, {}};
        const std::size_t told = report.absent.size();
        auto sweeps = sweepsOf(name, studio.gpu.device, effect.on && effect.effect == name, command, report.absent);
        for (Sweep& sweep : sweeps)
            if (sweep.relative) dropNone(studio, sweep);
        subject.whole = report.absent.size() == told;
        work.emplace_back(std::move(subject), std::move(sweeps));
    }
    return work;
}

void write(const std::filesystem::path& directory, const Report& report)
{
    Scaffold scaffold(directory, Scaffold::Kind::folder);
    writeText(scaffold.path() / "study.csv", csvOf(report));
    writeText(scaffold.path() / "study.json",
              jsonOf(report).dump(2, ' ', /* ensure_ascii= */ false, nlohmann::json::error_handler_t::replace) + "\n");
    writeText(scaffold.path() / "study.html", pageOf(report));
    scaffold.takePlace();
}
}

void studyVerb(const StudyCommand& command)
{
    subjectNames(command.effects); // or it is wrong usage, before any work
    const std::filesystem::path place = studyPlace(command.directory);
    requireWritableFolder(command.directory);
    Target target = loadTarget(command.target);
    const Camera camera = findCamera(target.scene(), command.camera);
    const bool given = target.baked.has_value();
    Setup standard = standardOf(command, target.scene(), camera);
    if (given) standard.bake.directAll = target.baked->directAll;
    if (!given) {
        std::vector<std::string> absent;
        studied(command, foreseenPlan(target.level, standard.settings), absent); // or there is nothing to bake for
        Progress progress(command.progress);
        nlohmann::json unasked;
        target.baked = bakeScene(target.level, standard.bake, progress, unasked);
    }
    const Scene& level = given ? target.baked->scene : target.level;
    Studio studio(level, *target.baked, command.device);
    studio.standard = standard;
    if (canTrace(studio.gpu.device, Tracing::automatic))
        studio.standard.settings.tracing = tracingOn(studio.gpu.device, Tracing::automatic);
    studio.camera = camera;
    studio.frames = command.quick ? 5 : 15;
    studio.quick = command.quick;

    Report report{.level = command.target.filename().string(),
                  .device = studio.gpu.device.deviceName,
                  .processor = fmt::format("{}, {} threads", processorName(), threadCount(0)),
                  .load = machineLoad(),
                  .threads = threadCount(0)};
    report.size = standard.settings.size, report.quick = command.quick, report.samples = standard.truth.samples;
    const Plan planned =
        plan(needs(level, target.baked->directAll), evidenceOf(target.baked->scene, &*target.baked, standard.settings), {});
    auto work = chosen(command, studio, planned, report);
    studio.picture = tracePicture(studio, command.progress);
    report.truthNoise = noiseOf(studio.picture);

    std::uint64_t steps = 0;
    for (const auto& [subject, sweeps] : work)
        for (const Sweep& sweep : sweeps) steps += stepsOf(sweep);
    Progress progress(command.progress);
    progress.begin("study", steps, "points");
    for (auto& [subject, sweeps] : work) {
        const Advance advance = [&](std::uint64_t points) {
            progress.advance(points);
            report.load = std::max(report.load, machineLoad());
        };
        for (const Sweep& sweep : sweeps)
            subject.curves.push_back(sweep.timed     ? timedCurve(&studio.gpu, sweep, advance)
                                     : sweep.inSpace ? spaceCurve(studio, sweep, advance)
                                                     : measure(studio, sweep, advance));
        advise(subject);
        report.subjects.push_back(std::move(subject));
    }
    progress.end();
    write(place, report);

    fmt::print("{}\n{}", (place / "study.html").string(), tablesOf(report));
    if (command.readmes)
        for (const auto& readme : writeReadmes(shaderRoot() / "engine/effects", nameInReadmes(command.target), report))
            fmt::print("{} holds its tables now\n", readme.string());
    for (const std::string& message : studio.gpu.device.messages) warning(message);
}
}
