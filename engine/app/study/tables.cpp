// What a study prints: a table for each curve, as the READMEs of the effects hold them, and its advice.
#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/advice.hpp"
#include "engine/app/study/files.hpp"
#include <cmath>

namespace afterglow
{
template <class Cell>
static std::string row(const std::string& head, const Curve& curve, Cell cell)
{
    std::string line = fmt::format("| {} |", head);
    for (const Point& point : curve.points) line += fmt::format(" {} |", cell(point));
    line += '\n';
    return line;
}

// Whose time it is.
static const char* timed(Clock clock)
{
    switch (clock) {
    case Clock::passes:
        return "time of its passes";
    case Clock::frame:
        return "time of a frame";
    case Clock::gathered:
        return "time of all frames";
    case Clock::bake:
        return "time of the bake";
    case Clock::cpuRays:
    case Clock::gpuRays:
        return "time of a ray";
    default:
        return "time of the picture";
    }
}

static std::string rowsInSpace(const Curve& curve)
{
    const auto share = [](double value) { return std::isnan(value) ? std::string("-") : fmt::format("{:.3g} %", 100.0 * value); };
    return row("95 of 100 below", curve, [&](const Point& p) { return share(p.inSpace->high); }) +
           row("worst", curve, [&](const Point& p) { return share(p.inSpace->worst); }) +
           row("leak", curve, [&](const Point& p) { return share(p.inSpace->leak); }) +
           row("bytes", curve, [](const Point& p) { return spokenBytes(p.inSpace->bytes); });
}

std::string tablesOf(const Subject& subject)
{
    std::string text;
    for (const Curve& curve : subject.curves) {
        const Sweep& sweep = curve.sweep;
        text += fmt::format("\n{}", row(sweep.unit.empty() ? sweep.knob : fmt::format("{}, {}", sweep.knob, sweep.unit), curve,
                                        [](const Point& p) { return p.standard ? fmt::format("**{}**", p.name) : p.name; }));
        text += row("---", curve, [](const Point&) { return std::string("---"); });
        text += row(timed(sweep.clock), curve, [&](const Point& p) { return spokenPrice(sweep, p.ms); });
        text += row("error", curve, [&](const Point& p) { return spokenError(sweep, p); });
        if (sweep.inSpace) text += rowsInSpace(curve);
        text += curve.truth.empty() ? fmt::format("\n{}\n", curve.advice) : fmt::format("\nAgainst {}. {}\n", curve.truth, curve.advice);
        const char* what = sweep.held == Held::hits ? "Time of" : "Error by";
        if (!curve.verdict.empty()) text += fmt::format("{} {}: {}.\n", what, sweep.knob, curve.verdict);
    }
    return text;
}

std::string tablesOf(const Report& report)
{
    std::string text;
    for (const Subject& subject : report.subjects) text += fmt::format("\n{}: {}\n{}", subject.name, subject.question, tablesOf(subject));
    if (!report.absent.empty()) text += "\nNot studied:\n";
    for (const std::string& line : report.absent) text += fmt::format("- {}\n", line);
    return text;
}
}
