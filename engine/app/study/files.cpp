#include "engine/app/study/files.hpp"
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

const char* nameOf(Clock clock)
{
    switch (clock) {
    case Clock::passes:
        return "gpu_passes";
    case Clock::frame:
        return "gpu_frame";
    case Clock::gathered:
        return "gpu_frames";
    case Clock::bake:
        return "cpu_bake";
    case Clock::making:
        return "cpu_making";
    case Clock::cpuRays:
        return "cpu_million_rays";
    case Clock::gpuRays:
        return "gpu_million_rays";
    default:
        return "cpu_truth";
    }
}

// Between quotes, where the text holds what would end its cell.
static std::string cell(const std::string& text)
{
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

static std::string orBlank(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

static const char* errorUnit(const Sweep& sweep)
{
    if (sweep.held == Held::hits) return "hits";
    if (sweep.inSpace) return "relative mean";
    if (sweep.held == Held::visibility) return "visibility";
    return sweep.displayed ? "displayed" : "relative";
}

// Columns that study.json has as well bear its names.
std::string csvOf(const Report& report)
{
    std::string text =
        "effect,knob,value,name,unit,clock,ms,ms_median,ms_spread,frame_ms,error,error_unit,noise,flip,error_high,error_worst,leak,bytes,"
        "default,pareto,"
        "expected_slope,measured_slope,floor,factor,range,truth,device,processor,threads,load,width,height,truth_samples,"
        "truth_noise\n";
    const std::string machine = fmt::format("{},{},{},{:.6g},{},{},{},{:.6g}", cell(report.device), cell(report.processor), report.threads,
                                            report.load, report.size.x, report.size.y, report.samples, report.truthNoise);
    const double none = std::nan("");
    for (const Subject& subject : report.subjects)
        for (const Curve& curve : subject.curves) {
            const Sweep& sweep = curve.sweep;
            const Fit fit = curve.fit.value_or(Fit{none, none, none, none});
            const std::string law = fmt::format("{},{},{},{},{}", orBlank(sweep.law.slope.value_or(none)), orBlank(fit.slope),
                                                orBlank(fit.floor), orBlank(fit.factor), orBlank(fit.range));
            for (const Point& p : curve.points) {
                const InSpace space = p.inSpace.value_or(InSpace{none, none, none, none});
                text += fmt::format("{},{},{:.6g},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{},{},{:.6g},{},", subject.name, cell(sweep.knob),
                                    p.value, cell(p.name), cell(sweep.unit), nameOf(sweep.clock), p.ms, p.median, p.spread, p.frameMs,
                                    orBlank(p.error), errorUnit(sweep), p.noise, orBlank(p.flip));
                text += fmt::format("{},{},{},{},{:d},{:d},{},{},{}\n", orBlank(space.high), orBlank(space.worst), orBlank(space.leak),
                                    orBlank(space.bytes), p.standard, p.pareto, law, cell(curve.truth), machine);
            }
        }
    return text;
}

static json curveJson(const Curve& curve)
{
    const Sweep& sweep = curve.sweep;
    json points = json::array();
    for (const Point& p : curve.points) {
        points.push_back({{"value", p.value},
                          {"name", p.name},
                          {"ms", p.ms},
                          {"ms_median", p.median},
                          {"ms_spread", p.spread},
                          {"frame_ms", p.frameMs},
                          {"error", p.error},
                          {"noise", p.noise},
                          {"flip", p.flip},
                          {"default", p.standard},
                          {"pareto", p.pareto}});
        if (const auto& space = p.inSpace)
            points.back().update(
                {{"error_high", space->high}, {"error_worst", space->worst}, {"leak", space->leak}, {"bytes", space->bytes}});
    }
    json row = {{"knob", sweep.knob},
                {"unit", sweep.unit},
                {"clock", nameOf(sweep.clock)},
                {"error_unit", errorUnit(sweep)},
                {"named", !sweep.names.empty()},
                {"truth", curve.truth},
                {"expected_slope", nullptr},
                {"most", sweep.law.most},
                {"measured_slope", nullptr},
                {"floor", nullptr},
                {"by_value", bool(sweep.exact)},
                {"verdict", curve.verdict},
                {"advice", curve.advice},
                {"points", points}};
    if (sweep.law.slope) row["expected_slope"] = *sweep.law.slope;
    if (curve.fit)
        row["measured_slope"] = curve.fit->slope, row["floor"] = curve.fit->floor, row["factor"] = curve.fit->factor,
        row["range"] = curve.fit->range;
    return row;
}

json jsonOf(const Report& report)
{
    json subjects = json::array();
    for (const Subject& subject : report.subjects) {
        json curves = json::array();
        for (const Curve& curve : subject.curves) curves.push_back(curveJson(curve));
        subjects.push_back({{"effect", subject.name}, {"question", subject.question}, {"reason", subject.reason}, {"curves", curves}});
    }
    return {{"schema", 1},
            {"level", report.level},
            {"device", report.device},
            {"processor", report.processor},
            {"threads", report.threads},
            {"load", report.load},
            {"size", {report.size.x, report.size.y}},
            {"quick", report.quick},
            {"truth_samples", report.samples},
            {"truth_noise", report.truthNoise},
            {"absent", report.absent},
            {"subjects", subjects}};
}
}
