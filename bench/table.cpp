// The answers as a table. Rates "/ CPU s" are per second of one processor: they hold on a busy machine too.
#include "bench/bench.hpp"
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static double number(const json& row, const char* key) { return row.value(key, 0.0); }

static double perSecond(double rays, double seconds) { return seconds > 0.0 ? rays / seconds : 0.0; }

static void bakeLine(const std::string& name, const json& row)
{
    const double rays = number(row, "rays"), seconds = number(row, "seconds"), cpu = number(row, "cpu_seconds");
    fmt::print("  {:<26}{:>10.2f}{:>10.2f}", name, seconds, cpu);
    if (rays > 0.0) fmt::print("{:>12.2f}{:>12.3f}{:>14.3f}", rays * 1e-6, perSecond(rays, seconds) * 1e-6, perSecond(rays, cpu) * 1e-6);
    fmt::print("\n");
}

static void bakeTable(const json& bake)
{
    fmt::print("\n  {:<26}{:>10}{:>10}{:>12}{:>12}{:>14}\n", "bake, " + bake["quality"].get<std::string>(), "s", "CPU s", "M rays",
               "M rays/s", "M rays/CPU s");
    json rest = bake; // reading, atlas, tree: what belongs to no product
    for (const auto& [name, product] : bake["products"].items()) {
        if (!product.contains("seconds")) continue;
        bakeLine(name, product);
        for (const char* key : {"seconds", "cpu_seconds"}) rest[key] = number(rest, key) - number(product, key);
    }
    rest["rays"] = 0;
    bakeLine("reading, atlas, tree", rest);
    bakeLine("whole", bake);
    if (bake.contains("projected"))
        fmt::print("  {:<26}{:>10.2f}{:>10.2f}   projected: the lightmaps' time in proportion to their paths, {} instead of {}\n",
                   "whole, all paths", number(bake["projected"], "seconds"), number(bake["projected"], "cpu_seconds"),
                   bake["projected"]["samples"].get<int>(), bake["samples"].get<int>());
    const json& process = bake["process"];
    fmt::print("  with writing the files {:.2f} s, {:.2f} CPU s; peak memory {:.0f} MiB\n", number(process, "wall_seconds"),
               number(process, "cpu_seconds"), number(process, "peak_mib"));
}

static void rayTable(const json& rays, const json& bake)
{
    fmt::print("\n  {:<26}{:>10}{:>10}{:>12}{:>12}{:>14}\n", "rays, Embree alone", "triangles", "met", "M rays", "M rays/s",
               "M rays/CPU s");
    const auto line = [&](const char* name, const json& kind) {
        fmt::print("  {:<26}", name);
        if (kind.contains("met"))
            fmt::print("{:>10}{:>8.1f} %{:>12.2f}", rays["triangles"].get<std::uint64_t>(), 100.0 * number(kind, "met"),
                       number(kind, "rays") * 1e-6);
        else
            fmt::print("{:>32}", "");
        fmt::print("{:>12.3f}{:>14.3f}\n", number(kind, "rays_per_second") * 1e-6, number(kind, "rays_per_cpu_second") * 1e-6);
    };
    line("nearest, packets of 16", rays["closest_packed"]);
    line("nearest, one by one", rays["closest"]);
    line("any, packets of 16", rays["shadow_packed"]);
    line("any, one by one", rays["shadow"]);
    const json mixes = rays.value("mix", json::object());
    for (const auto& [name, mix] : mixes.items()) {
        const json& product = bake["products"][name];
        line(("the mix of " + name).c_str(), mix);
        const double wall = perSecond(number(product, "rays"), number(product, "seconds")) / number(mix, "rays_per_second");
        const double cpu = perSecond(number(product, "rays"), number(product, "cpu_seconds")) / number(mix, "rays_per_cpu_second");
        fmt::print("  {:<58}{:>12.3f}{:>14.3f}\n", name + " of the bake / Embree alone", wall, cpu);
    }
}

static void triangleTable(const json& curves)
{
    fmt::print("\n  {:<26}", "triangles");
    for (const json& point : curves[0]["points"]) fmt::print("{:>10.0f}", number(point, "triangles"));
    fmt::print("\n");
    for (const json& curve : curves) {
        fmt::print("  {:<26}", curve["what"].get<std::string>() + (curve["what"] == "raster" ? ", ms" : ", ns"));
        for (const json& point : curve["points"]) {
            const double ms = number(point, "ms");
            fmt::print("{:>10.{}f}", ms, ms < 10.0 ? 2 : 0);
        }
        fmt::print("\n  {:<26}{}\n", "", curve["verdict"].get<std::string>());
    }
}

static void threadTable(const json& threads)
{
    if (threads.contains("missing")) {
        fmt::print("\n  threads: not measured: {}\n", threads["missing"].get<std::string>());
        return;
    }
    fmt::print("\n  {:<26}{:>10}{:>10}{:>12}{:>12}{:>14}\n", "threads, a small bake", "1: s", "2: s", "1: CPU s", "2: CPU s", "speed-up");
    for (const json& pair : threads["pairs"]) {
        const double one = pair["seconds"][0], two = pair["seconds"][1];
        fmt::print("  {:<26}{:>10.2f}{:>10.2f}{:>12.2f}{:>12.2f}{:>14.3f}\n", "", one, two, pair["cpu_seconds"][0].get<double>(),
                   pair["cpu_seconds"][1].get<double>(), one / two);
    }
    fmt::print("  median: {:.3f} times as fast on two, with {:.2f} cores got from the machine; processor time grows by a factor {:.3f}\n",
               number(threads, "speedup"), number(threads, "cores"), number(threads, "cpu_growth"));
}

static void frameTable(const json& frame)
{
    if (frame.contains("missing")) {
        fmt::print("\n  frame: not measured: {}\n", frame["missing"].get<std::string>());
        return;
    }
    const std::string size = fmt::format("frame, {}x{}", frame["size"][0].get<int>(), frame["size"][1].get<int>());
    fmt::print("\n  {:<26}{:>10}\n", size, "ms");
    for (const json& pass : frame["passes"]) fmt::print("  {:<26}{:>10.3f}\n", pass["name"].get<std::string>(), number(pass, "ms"));
    fmt::print("  {:<26}{:>10.3f}   with recording and submitting {:.3f} ms, {:.3f} CPU ms\n", "whole, GPU timestamps",
               number(frame, "frame_ms"), number(frame, "wall_ms"), number(frame, "cpu_ms"));
    fmt::print("  {:<26}{:>8.1f} %   of lighting: what it costs more than without them\n", "lookups of probes",
               100.0 * number(frame, "probe_lookups_of_lighting"));
    fmt::print("  median of {} frames on {}; {} triangles in {} draws, {:.1f} MiB of GPU memory\n", frame["frames"].get<int>(),
               frame["device"].get<std::string>(), frame["triangles"].get<std::uint64_t>(), frame["draws"].get<std::uint64_t>(),
               number(frame, "gpu_bytes") / 1048576.0);
}

void printPaths(const json& answers)
{
    const json& paths = answers["paths"];
    fmt::print("\n{} samples of {}x{} on {}, load before {:.1f}\n\n", paths["samples"].get<int>(), paths["size"][0].get<int>(),
               paths["size"][1].get<int>(), paths["device"].get<std::string>(), number(answers["machine"], "load"));
    fmt::print("| level | tracing | first sample, CPU s | a sample, ms | CPU ms | to the first's |\n|---|---|---|---|---|---|\n");
    for (const json& row : paths["rows"])
        fmt::print("| {} | {} | {:.1f} | {:.0f} | {:.0f} | {:.2f} |\n", answers["level"].get<std::string>(),
                   row["tracing"].get<std::string>(), number(row, "first_cpu_s"), number(row, "sample_ms"), number(row, "sample_cpu_ms"),
                   number(row, "sample_cpu_ms") / number(paths["rows"][0], "sample_cpu_ms"));
}

void printAtlas(const json& atlas)
{
    fmt::print("\n  {:<26}{:>10}{:>10}{:>12}{:>12}{:>14}\n", "atlas, one page, padding 2", "triangles", "charts", "utilisation",
               "L2 stretch", "CPU s");
    const auto line = [](const std::string& name, const std::string& triangles, const json& row) {
        if (row.contains("missing"))
            fmt::print("  {:<26}not measured: {}\n", name, row["missing"].get<std::string>());
        else
            fmt::print("  {:<26}{:>10}{:>10}{:>10.1f} %{:>12.4f}{:>14.3f}{}\n", name, triangles, row["charts"].get<int>(),
                       100.0 * number(row, "utilisation"), number(row, "stretch"), number(row, "cpu_seconds"),
                       row["pages"] == 1 ? "" : "   pages: " + row["pages"].dump());
    };
    for (const json& row : atlas["rows"]) {
        line(row["what"].get<std::string>(), row["triangles"].dump(), row["ours"]);
        line("  by xatlas", "", row["xatlas"]);
        if (row["xatlas"].contains("missing")) continue;
        const auto ratio = [&](const char* key) { return number(row["ours"], key) / number(row["xatlas"], key); };
        fmt::print("  {:<26}{:>20.2f}{:>12.2f}{:>12.3f}{:>14.3f}\n", "  ours / xatlas", ratio("charts"), ratio("utilisation"),
                   ratio("stretch"), ratio("cpu_seconds"));
    }
}

static void noiseRows(const json& rows)
{
    fmt::print("  {:<26}{:>10}{:>10}{:>12}{:>10}{:>10}{:>12}\n", "paths a texel", "s", "CPU s", "error, %", "s", "CPU s", "filtered, %");
    for (const json& row : rows) {
        fmt::print("  {:<26}", row["samples"].get<int>());
        for (const char* how : {"none", "builtin"})
            fmt::print("{:>10.2f}{:>10.2f}{:>12.2f}", number(row[how], "seconds"), number(row[how], "cpu_seconds"),
                       100.0 * number(row[how], "error"));
        fmt::print("\n");
    }
}

void printNoise(const json& noise)
{
    fmt::print("\n  lightmaps of {:.0f} texels, held against {} paths a texel, which are {:.2f} % off\n", number(noise, "texels"),
               noise["reference"]["samples"].get<int>(), 100.0 * number(noise["reference"], "error"));
    noiseRows(noise["rows"]);
}

// Of the angles of one roughness: root of the mean square.
static double overAngles(const std::vector<json>& cells, const char* key)
{
    double squares = 0.0;
    for (const json& cell : cells) squares += number(cell, key) * number(cell, key);
    return std::sqrt(squares / double(cells.size()));
}

void printReflections(const json& placed)
{
    for (const auto& [how, said] : placed.items()) {
        if (said.contains("missing")) {
            fmt::print("\n  reflections: not measured: {}\n", said["missing"].get<std::string>());
            continue;
        }
        if (!said.contains("cells")) continue;    // what the measuring took
        std::map<double, std::vector<json>> rows; // by roughness
        for (const json& cell : said["cells"]) rows[number(cell, "roughness")].push_back(cell);
        fmt::print("\n{}, probes placed {}: {}; {} points of glossy surfaces, {} paths each\n\n| roughness |",
                   said["level"].get<std::string>(), how, said["probes"].get<int>(), said["points"].get<int>(), said["paths"].get<int>());
        for (const json& cell : rows.begin()->second) fmt::print(" {:g} degrees |", number(cell, "degrees"));
        fmt::print(" of the blur | of the place | irradiance alone |\n| --- |{}\n", [&] {
            std::string rule;
            for (std::size_t i = 0; i < rows.begin()->second.size() + 3; ++i) rule += " --- |";
            return rule;
        }());
        for (const auto& [roughness, cells] : rows) {
            fmt::print("| {:.3g} |", roughness);
            for (const json& cell : cells) fmt::print(" {:.0f} % ({:+.0f}) |", 100.0 * number(cell, "error"), 100.0 * number(cell, "bias"));
            for (const char* key : {"blur", "place", "flat"}) fmt::print(" {:.0f} % |", 100.0 * overAngles(cells, key));
            fmt::print("\n");
        }
    }
}

void printRoom(const json& room)
{
    const double wanted = number(room, "wanted");
    fmt::print("\n  a room, {:.0f} texels\n", number(room, "texels"));
    noiseRows(room["rows"]);
    const json& cycles = room["cycles"];
    // Its error falls as one over the root of the paths, and with them the time grows: the time to another error
    const double share = cycles.contains("missing") ? 0.0 : number(cycles, "error") * number(cycles, "error") / (wanted * wanted);
    const double theirs = share * number(cycles, "seconds"), theirCpu = share * number(cycles, "cpu_seconds");
    const auto line = [&](const std::string& what, const char* how) {
        if (!room.contains(how)) return;
        const double seconds = number(room[how], "seconds"), cpu = number(room[how], "cpu_seconds");
        fmt::print("  {:<26}{:>10.2f}{:>10.2f}{:>12.2f}", what, seconds, cpu, 100.0 * number(room[how], "error"));
        fmt::print("{}\n", share > 0.0 ? fmt::format("   {:.4f} of Cycles' s, {:.4f} of its CPU s", seconds / theirs, cpu / theirCpu) : "");
    };
    line(fmt::format("to {:g} %", 100.0 * wanted), "none");
    line(fmt::format("to {:g} %, filtered", 100.0 * wanted), "builtin");
    if (share > 0.0)
        fmt::print("  {:<26}{:>10.2f}{:>10.2f}{:>12.2f}   reckoned from {} samples, {:.2f} % off, in {:.2f} s\n",
                   "  by Cycles " + cycles["version"].get<std::string>(), theirs, theirCpu, 100.0 * wanted, cycles["samples"].get<int>(),
                   100.0 * number(cycles, "error"), number(cycles, "seconds"));
    else
        fmt::print("  {:<26}not measured: {}\n", "  by Cycles", cycles["missing"].get<std::string>());
}

void printTable(const json& answers)
{
    const json& machine = answers["machine"];
    fmt::print("{} on {}, {} of {} threads; load before {:.1f}\n", answers["level"].get<std::string>(), machine["cpu"].get<std::string>(),
               machine["threads"].get<int>(), machine["cores"].get<int>(), number(machine, "load"));
    bakeTable(answers["bake"]);
    printAtlas(answers["atlas"]);
    if (answers.contains("room")) printRoom(answers["room"]);
    rayTable(answers["rays"], answers["bake"]);
    triangleTable(answers["triangles"]["curves"]);
    threadTable(answers["threads"]);
    frameTable(answers["frame"]);
}
}
