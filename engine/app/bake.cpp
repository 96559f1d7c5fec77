#include "engine/app/verbs.hpp"
#include "engine/core/file.hpp"
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
void bakeVerb(const BakeCommand& command)
{
    Progress progress(command.progress);
    bakeLevel(command.level, command.directory, command.options, progress);
    nlohmann::json manifest = nlohmann::json::parse(readText(command.directory / "bake.json"));
    fmt::print("{}\n", command.directory.string());
    for (const auto& [name, product] : manifest["products"].items()) {
        if (!product.contains("seconds")) continue; // copied, not baked
        fmt::print("  {:<12} {:>8.2f} s  {:>10.2f} M rays  {}\n", name, product.value("seconds", 0.0), product.value("rays", 0.0) * 1e-6,
                   product.contains("estimated_error")
                       ? fmt::format("estimated error {:.2f} %", 100.0 * product["estimated_error"].get<double>())
                       : "");
    }
    fmt::print("  {:<12} {:>8.2f} s  {:>10.2f} M rays/s\n", "whole bake", manifest.value("seconds", 0.0),
               manifest.value("rays_per_second", 0.0) * 1e-6);
    const nlohmann::json& memory = manifest["memory"];
    const auto mebibytes = [&](const char* what) { return memory.value(what, 0.0) / (1 << 20); };
    fmt::print("  {:<12} {:>8.0f} MiB at most; lightmaps {:.0f} bytes a texel, the level {:.0f} bytes a triangle{}\n", "memory",
               mebibytes("peak_bytes"), memory.value("texel_bytes", 0.0), memory.value("triangle_bytes", 0.0),
               mebibytes("streamed_bytes") > 0.0 ? fmt::format("; {:.0f} MiB of light on the disk", mebibytes("streamed_bytes")) : "");
}
}
