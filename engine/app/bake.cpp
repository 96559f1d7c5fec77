#include "engine/app/verbs.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include <cstdio>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

static constexpr double kRough = 0.5; // of a texel's light, as its paths scatter: what a filter makes of that is a guess

static constexpr double kNoisy = 1.2; // times what was asked of probes' noise: an estimate that is no nearer

static std::string errorsOf(const std::string& name, const json& product)
{
    std::string text;
    if (product.contains("estimated_error"))
        text = fmt::format("estimated error {:.2f} %", 100.0 * product["estimated_error"].get<double>());
    if (name == "reflections") text += " of a texel of the sharpest mip";
    if (product.contains("filtered_error")) text += fmt::format(", filtered {:.2f} %", 100.0 * product["filtered_error"].get<double>());
    if (product.contains("interpolation_error"))
        text += fmt::format(", {:.2f} % between probes", 100.0 * product["interpolation_error"].get<double>());
    return text;
}

// What a person would not want to find out from a picture.
static void tellWhatIsMissed(const json& products, const BakeOptions& options)
{
    const double lightmaps = products.value("/lightmaps/estimated_error"_json_pointer, 0.0),
                 between = products.value("/probes/interpolation_error"_json_pointer, 0.0),
                 noise = products.value("/probes/estimated_error"_json_pointer, 0.0),
                 bytes = products.value("/probes/unpacked_bytes"_json_pointer, 0.0);
    if (lightmaps > kRough)
        warning(
            fmt::format("a texel of the lightmaps is {:.0f} % off before it is filtered: the light is rare, as behind a mirror or a small "
                        "window; more --samples, or --target-error, make it right",
                        100.0 * lightmaps));
    if (options.probeBytes && bytes > double(*options.probeBytes))
        warning(
            fmt::format("--probe-budget {} is less than the coarsest probes of this level take, {:.0f} bytes", *options.probeBytes, bytes));
    else if (options.probeError && between > double(*options.probeError))
        warning(fmt::format("--probe-error {:g} is not reached: {:.3g} with {:.0f} bytes of probes{}", double(*options.probeError), between,
                            bytes, options.probeBytes ? ", as many as --probe-budget allows" : ""));
    if (!options.probeError) return;
    const double asked = double(probeNoiseFor(*options.probeError));
    if (noise > kNoisy * asked)
        warning(
            fmt::format("--probe-error {:g} lets noise have {:.2g}, and it is {:.2g} with as many paths as this quality gives a probe: a "
                        "higher --quality gives more",
                        double(*options.probeError), asked, noise));
}

void bakeVerb(const BakeCommand& command)
{
    Progress progress(command.progress);
    bakeLevel(command.level, command.directory, command.options, progress);
    json manifest = json::parse(readText(command.directory / "bake.json"));
    fmt::print("{}\n", command.directory.string());
    for (const auto& [name, product] : manifest["products"].items()) {
        if (!product.contains("seconds")) continue; // copied, not baked
        fmt::print("  {:<12} {:>8.2f} s  {:>10.2f} M rays  {}\n", name, product.value("seconds", 0.0), product.value("rays", 0.0) * 1e-6,
                   errorsOf(name, product));
    }
    fmt::print("  {:<12} {:>8.2f} s  {:>10.2f} M rays/s\n", "whole bake", manifest.value("seconds", 0.0),
               manifest.value("rays_per_second", 0.0) * 1e-6);
    const json& memory = manifest["memory"];
    const auto mebibytes = [&](const char* what) { return memory.value(what, 0.0) / (1 << 20); };
    const double texel = memory.value("texel_bytes", 0.0);
    fmt::print("  {:<12} {:>8.0f} MiB at most; {}the level {:.0f} bytes a triangle{}\n", "memory", mebibytes("peak_bytes"),
               texel > 0.0 ? fmt::format("lightmaps {:.0f} bytes a texel, ", texel) : "", memory.value("triangle_bytes", 0.0),
               mebibytes("streamed_bytes") > 0.0 ? fmt::format("; {:.0f} MiB of light on the disk", mebibytes("streamed_bytes")) : "");
    tellWhatIsMissed(manifest["products"], command.options);
}
}
