#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "baker/probe_accuracy.hpp"
#include "engine/app/level.hpp"
#include "engine/app/verbs.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/scene/origin.hpp"
#include "engine/scene/repair.hpp"
#include <algorithm>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static constexpr float kSlack = 1e-3f; // of the level: who asks at its border is not outside
static constexpr double kLift = 1e-3;  // m: who asks about a surface is not in it

static dvec3 vector3(const json& from, const std::filesystem::path& file, const char* key)
{
    if (!from.is_array() || from.size() != 3 || !from[0].is_number() || !from[1].is_number() || !from[2].is_number())
        throw Error(file.string() + ": \"" + key + "\" must be three numbers, such as [0, 1.5, 0]");
    return dvec3(from[0].get<double>(), from[1].get<double>(), from[2].get<double>());
}

static double largestOf(dvec3 v) { return std::max({v.x, v.y, v.z}); }

// Of any length that a number can say.
static vec3 unit(dvec3 normal, const std::filesystem::path& file)
{
    const double largest = largestOf(abs(normal));
    if (!(largest > 0.0)) throw Error(file.string() + ": a \"normal\" must not be zero");
    return vec3(normalize(normal / largest));
}

// Who asks beyond the level, by a slip of units or axes, is answered from its border.
static void tellOutside(const Baked& baked, const std::vector<ProbePoint>& points, const std::filesystem::path& file)
{
    vec3 lower = baked.scene.lower, upper = baked.scene.upper;
    for (vec3 probe : baked.probes.positions) lower = min(lower, probe), upper = max(upper, probe);
    const vec3 slack = kSlack * (upper - lower);
    const auto outside = [&](const ProbePoint& point) {
        const vec3 p = fromLevel(point.position, baked.scene.origin);
        return any(lessThan(p, lower - slack)) || any(greaterThan(p, upper + slack));
    };
    const std::ptrdiff_t count = std::count_if(points.begin(), points.end(), outside);
    if (count > 0)
        note(fmt::format("{}: {} of {} points lie outside of the level, where the light at its border is the answer", file.string(), count,
                         points.size()));
}

// Nobody looks there, and a bake answers from beside it.
static void tellBuried(const Baked& baked, std::vector<ProbePoint> points, const std::filesystem::path& file)
{
    for (ProbePoint& point : points)
        if (point.normal) point.position += kLift * dvec3(*point.normal);
    const std::vector<bool> inside = insideSolids(baked.scene, points);
    const std::ptrdiff_t count = std::count(inside.begin(), inside.end(), true);
    if (count > 0)
        note(fmt::format("{}: {} of {} points lie in solids, where it is dark; the light beside them is the answer", file.string(), count,
                         points.size()));
}

// What the truth of the same points holds, and a bake of lights as they say does not.
static void tellDirect(const Baked& baked)
{
    if (baked.directAll) return;
    const auto count = [&](uint bake) {
        return std::count_if(baked.scene.lights.begin(), baked.scene.lights.end(),
                             [&](const Light& light) { return light.bake == bake && light.intensity != vec3(0.0f); });
    };
    const std::ptrdiff_t apart = count(kBakeIndirect), none = count(kBakeNone);
    if (apart > 0)
        note(
            fmt::format("the direct part of {} {} is not in this bake, nor in its answers: the runtime adds it; --direct all bakes it, too",
                        apart, apart == 1 ? "light" : "lights"));
    if (none > 0)
        note(fmt::format("{} {} in this bake, nor in its answers, as ag_bake says; --direct all bakes all", none,
                         none == 1 ? "light is not" : "lights are not"));
}

static json array3(vec3 v) { return json::array({v.x, v.y, v.z}); }

void probeVerb(const ProbeCommand& command)
{
    requireApart({{"-o", command.output}}, {{"--points", command.points}, {"LEVEL|DIR", command.target}});
    json document = json::parse(readText(command.points), nullptr, /* allow_exceptions= */ false);
    if (!document.is_object() || !document.contains("points") || !document["points"].is_array())
        throw Error(command.points.string() + ": not a list of points; expected {\"points\":[{\"position\":[x,y,z]}, ...]}");
    std::vector<ProbePoint> points;
    for (const json& row : document["points"]) {
        if (!row.is_object() || !row.contains("position")) throw Error(command.points.string() + ": a point has no \"position\"");
        ProbePoint point;
        point.position = vector3(row["position"], command.points, "position");
        if (largestOf(abs(point.position)) > double(kLargestCoordinate))
            throw Error(command.points.string() + ": a \"position\" lies beyond 1e18 m, where no level can be");
        if (row.contains("normal")) point.normal = unit(vector3(row["normal"], command.points, "normal"), command.points);
        points.push_back(point);
    }

    Target target = loadTarget(command.target);
    if (!target.bake() && !command.truth)
        throw Error(command.target.string() + " is not a baked folder: bake it first, or ask for --truth");
    requireWritable(command.output);
    if (!command.truth) {
        tellOutside(*target.bake(), points, command.points);
        tellBuried(*target.bake(), points, command.points);
        tellDirect(*target.bake());
    }
    Progress progress(command.progress);
    std::vector<PointIrradiance> answers =
        command.truth ? probeTruth(target.scene(), points, command.samples, command.seed, command.threads, progress)
                      : probeBaked(*target.bake(), points);
    for (std::size_t i = 0; i < points.size(); i++) {
        json& row = document["points"][i];
        auto rows = [&](const std::array<vec3, 6>& values) {
            json out = json::array();
            for (vec3 v : values) out.push_back(array3(v));
            return points[i].normal ? array3(values[0]) : out;
        };
        row["E"] = rows(answers[i].value);
        if (!command.truth && points[i].normal) row["open"] = answers[i].open;
        if (command.truth) row["standard_error"] = rows(answers[i].error);
    }
    writeText(command.output, document.dump(1) + "\n");
}
}
