// A frame in words.
#include "engine/graph/describe.hpp"
#include <algorithm>
#include <cstdio>

namespace afterglow
{
static std::string join(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text.empty() ? "-" : text;
}

static std::string row(const std::string& name, const std::string& reads, const std::string& writes, double mebibytes, double milliseconds)
{
    char numbers[64];
    std::snprintf(numbers, sizeof(numbers), "%9.2f MiB %9.3f ms", mebibytes, milliseconds);
    std::string line = name;
    line.resize(std::max<std::size_t>(line.size() + 1, 20), ' ');
    return line + numbers + "  " + reads + " -> " + writes + "\n";
}

constexpr double kMebibyte = 1024.0 * 1024.0;

std::string describe(const FrameStats& stats)
{
    std::string text;
    for (const PassStats& pass : stats.passes)
        text += row(pass.name, join(pass.reads), join(pass.writes), static_cast<double>(pass.bytes) / kMebibyte, pass.milliseconds);
    if (!stats.culled.empty()) text += "culled: " + join(stats.culled) + "\n";
    char total[160];
    std::snprintf(total, sizeof(total), "%zu passes, %.3f ms, %u pipelines, %.2f MiB in all, %llu draws, %llu triangles\n",
                  stats.passes.size(), stats.milliseconds, stats.pipelines, static_cast<double>(stats.gpuBytes) / kMebibyte,
                  static_cast<unsigned long long>(stats.draws), static_cast<unsigned long long>(stats.triangles));
    return text + total;
}

std::string describeDot(const Graph& graph, const Schedule& schedule)
{
    std::string text = "digraph frame {\n  rankdir=LR;\n";
    // A name may be written several times: each version is a node of its own.
    const auto node = [&](const Access& access, std::uint32_t version) {
        return "\"" + graph.resources[access.resource].name + " " + std::to_string(version) + "\"";
    };
    for (const ScheduledPass& scheduled : schedule.passes) {
        const PassData& pass = graph.passes[scheduled.pass];
        const std::string name = "\"" + pass.name + "\"";
        text += "  " + name + " [shape=box];\n";
        for (const Access& access : pass.accesses) {
            if (access.resource == kNoResource) continue;
            const std::uint32_t seen = writes(access.use) ? access.version - 1 : access.version;
            if (reads(access.use)) text += "  " + node(access, seen) + " -> " + name + ";\n";
            if (writes(access.use)) text += "  " + name + " -> " + node(access, access.version) + ";\n";
        }
    }
    for (const std::string& name : schedule.culled) text += "  \"" + name + "\" [shape=box, style=dashed];\n";
    return text + "}\n";
}
}
