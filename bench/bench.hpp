// What the benchmark asks of a level, and the numbers that come back. Times are medians, in seconds of the clock on the wall and, because
// machines are shared, of the processor (all threads together).
#pragma once
#include "baker/baker.hpp"
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace afterglow
{
struct BenchOptions {
    std::filesystem::path level;
    bool quick = false; // draft instead of medium, and fewer repetitions
    bool full = false;  // every path of medium, where a part would tell
    int threads = 0;    // 0: all cores
    std::string device; // name or index, empty: the best
};

// The whole bake into `directory`: {"quality","samples","seconds","cpu_seconds","rays","products":{...}}, as its bake.json says. At medium,
// unless `full`, with a quarter of its paths per texel; {"projected":{"samples","seconds","cpu_seconds"}} then says what all would cost.
nlohmann::json benchBake(const BenchOptions& options, const std::filesystem::path& directory);

// The lightmaps of a small bake on one thread and on two, in turns: {"pairs":[...],"samples","speedup","cpu_growth","cores"}, the last what
// two threads got of the machine: a speed-up cannot exceed it.
nlohmann::json benchThreads(const BenchOptions& options, const std::filesystem::path& directory);

// The atlas of the level, and of meshes that are made for it, on one page, beside xatlas:
// {"rows":[{"what","triangles","ours":{"charts","pages","stretch","utilisation","texels_per_metre","cpu_seconds"},
// "xatlas":{the same, but for the density, or "missing"}}]}.
nlohmann::json benchAtlas(const BenchOptions& options, const std::filesystem::path& folder);

// A room's lightmap to an error of 2 %, beside Blender's Cycles:
// {"wanted","texels","none":{"samples","seconds","cpu_seconds","error"},"builtin":{the same, with the filter},
// "rows":[{"samples","none","builtin"}],"cycles":{"version","samples",..., or "missing"}}.
nlohmann::json benchRoom(const BenchOptions& options, const std::filesystem::path& folder);

// The level's lightmap at draft by the paths of a texel: {"texels","reference":{"samples","error"},"rows":[{"samples","none","builtin"}]}.
nlohmann::json benchNoise(const BenchOptions& options);

// Reflection probes against path-traced reflections at points of the level's glossy surfaces, relative RMSE: {"by hand": where the level
// places them,"automatically":{"level","probes","points","paths","baked": as bake.json has it,
// "cells":[{"roughness","degrees","error","bias","blur","place","flat": by irradiance alone}], or "missing"}}.
nlohmann::json benchReflections(const BenchOptions& options);

// Rays of the kinds that bake.json counts on their own, nothing shaded, and of each product of `bake` (benchBake) the rate at which its mix
// of them would be traced: {"closest":{...},...,"mix":{"lightmaps":{...},...}}.
nlohmann::json benchRays(const BenchOptions& options, const nlohmann::json& bake);

// Frames of a baked level: {"device","size","frame_ms","wall_ms","cpu_ms","passes":[...]}.
nlohmann::json benchFrame(const BenchOptions& options, const std::filesystem::path& baked);

// The truth on the GPU by each of its organisations, in turns:
// {"device","size","samples","rows":[{"tracing","first_s","first_cpu_s","sample_ms","sample_cpu_ms"}]}. The first sample compiles,
// whatever a driver has kept.
nlohmann::json benchPaths(const BenchOptions& options);

// Time by triangles, of levels that are made for it:
// {"curves":[{"what","slope","verdict","points":[{"triangles","ms","spread_ms","differ"}]}]}, "ms" of a frame's geometry or of a million
// rays: ns of one.
nlohmann::json benchTriangles(const BenchOptions& options);

// All answers as a table for a person.
void printTable(const nlohmann::json& answers);
void printPaths(const nlohmann::json& answers);      // those of benchPaths alone, as Markdown
void printAtlas(const nlohmann::json& atlas);        // those of benchAtlas
void printRoom(const nlohmann::json& room);          // those of benchRoom
void printNoise(const nlohmann::json& noise);        // those of benchNoise
void printReflections(const nlohmann::json& placed); // those of benchReflections, as Markdown

double median(std::vector<double> values); // of one or more
}
