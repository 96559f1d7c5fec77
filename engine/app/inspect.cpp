#include "engine/app/inspect.hpp"
#include "engine/baked/manifest.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// Shares of 1 over all pages.
struct Coverage {
    double baked = 0, dilated = 0;
};
static Coverage coverageOf(const std::vector<Lightmap>& pages)
{
    std::size_t texels = 0, baked = 0, dilated = 0;
    for (const Lightmap& page : pages) {
        texels += page.valid.size();
        baked += std::size_t(std::count(page.valid.begin(), page.valid.end(), 1));
        dilated += std::size_t(std::count(page.valid.begin(), page.valid.end(), 2));
    }
    const double all = double(std::max<std::size_t>(texels, 1));
    return {double(baked) / all, double(dilated) / all};
}

static std::string number(double value, const char* format)
{
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

static std::string byteText(double bytes) { return bytes >= 1e6 ? number(bytes * 1e-6, "%.2f MB") : number(bytes * 1e-3, "%.1f kB"); }

// What the manifest says of a product in the baker's own words: " error 1.2 %, 3.4 s".
static std::string said(const json& product)
{
    std::string text;
    const auto has = [&](const char* key) { return product.contains(key) && product[key].is_number(); };
    if (has("interpolation_error")) text += number(100.0 * product["interpolation_error"].get<double>(), ", %.2f %% off between them");
    if (has("estimated_error")) text += number(100.0 * product["estimated_error"].get<double>(), ", estimated error %.2f %%");
    if (has("filtered_error")) text += number(100.0 * product["filtered_error"].get<double>(), ", filtered %.2f %%");
    if (has("utilisation")) text += number(100.0 * product["utilisation"].get<double>(), ", utilisation %.0f %%");
    if (product.contains("seams"))
        text += number(product["seams"]["step"]["p95"].get<double>(), ", 95 %% of the seams within %.2f steps of 255") +
                number(product["seams"]["step"]["worst"].get<double>(), " (worst %.1f)");
    if (has("seconds")) text += number(product["seconds"].get<double>(), ", %.1f s");
    return text;
}

static std::string lightmapText(const Baked& baked)
{
    std::string pages;
    for (const Lightmap& page : baked.lightmaps)
        pages += (pages.empty() ? "" : ", ") + std::to_string(page.width) + " x " + std::to_string(page.height);
    const Coverage coverage = coverageOf(baked.lightmaps);
    return std::to_string(baked.lightmaps.size()) + " pages (" + pages + ")" + number(100.0 * coverage.baked, ", %.1f %% baked") +
           number(100.0 * coverage.dilated, ", %.1f %% dilated");
}

static std::string probeText(const ProbeTree& tree)
{
    return std::to_string(tree.probes.size()) + " probes in " + std::to_string(tree.cells.size()) + " cells";
}

static std::string reflectionText(const Baked& baked)
{
    const ReflectionProbe& first = baked.reflections.front();
    return std::to_string(baked.reflections.size()) + " cubes of " + std::to_string(first.size) + ", " + std::to_string(first.mips.size()) +
           " roughnesses";
}

static std::string lodText(const Baked& baked)
{
    std::size_t levels = 0, triangles = 0;
    for (const MeshLods& mesh : baked.lods)
        for (const auto& primitive : mesh.primitives)
            for (const LodLevel& level : primitive) ++levels, triangles += level.indices.size() / 3;
    return std::to_string(levels) + " levels of detail, " + std::to_string(triangles) + " triangles";
}

static std::string voxelText(const VoxelGrid& grid)
{
    return std::to_string(grid.count.x) + " x " + std::to_string(grid.count.y) + " x " + std::to_string(grid.count.z) +
           number(1e3 * double(grid.edge), " voxels of %.0f mm");
}

static std::string sceneText(const Scene& scene)
{
    return std::to_string(scene.objects.size()) + " objects, " + std::to_string(scene.indices.size() / 3) + " triangles, " +
           std::to_string(scene.materials.size()) + " materials, " + std::to_string(scene.lights.size()) + " lights";
}

static void printTable(const json& manifest, const Baked& baked, const std::filesystem::path& directory)
{
    std::printf("%s: %s", directory.string().c_str(), baked.scene.path.string().c_str());
    if (manifest.contains("seconds") && manifest["seconds"].is_number())
        std::printf(", baked in %.1f s", manifest["seconds"].get<double>());
    std::printf(", direct light %s\n", baked.directAll ? "of all lights is in it" : "as the lights say");

    const json& products = manifest["products"];
    const auto row = [&](const char* product, bool there, const std::string& text) {
        if (!there) return;
        const json empty = json::object(), &entry = products.contains(product) ? products[product] : empty;
        const double bytes = entry.contains("bytes") && entry["bytes"].is_number() ? entry["bytes"].get<double>() : 0.0;
        std::printf("  %-12s %10s  %s%s\n", product, byteText(bytes).c_str(), text.c_str(), said(entry).c_str());
    };
    row("scene", true, sceneText(baked.scene));
    row("lightmaps", !baked.lightmaps.empty(), baked.lightmaps.empty() ? "" : lightmapText(baked));
    row("probes", !baked.probes.empty(), probeText(baked.probes));
    row("reflections", !baked.reflections.empty(), baked.reflections.empty() ? "" : reflectionText(baked));
    row("voxels", !baked.voxels.closed.empty(), voxelText(baked.voxels));
    row("lods", !baked.lods.empty(), lodText(baked));
    for (const json& line : manifest.value("warnings", json::array()))
        std::printf("  warning: %s\n", line.is_string() ? line.get<std::string>().c_str() : line.dump().c_str());
}

void inspect(const InspectOptions& options)
{
    json manifest = readManifest(options.directory);
    const Baked baked = readBaked(options.directory);
    if (!options.json) {
        printTable(manifest, baked, options.directory);
        return;
    }
    json& products = manifest["products"];
    if (!baked.lightmaps.empty()) {
        products["lightmaps"]["baked_share"] = coverageOf(baked.lightmaps).baked;
        products["lightmaps"]["dilated_share"] = coverageOf(baked.lightmaps).dilated;
    }
    products["scene"]["objects"] = baked.scene.objects.size();
    products["scene"]["triangles"] = baked.scene.indices.size() / 3;
    std::printf("%s\n", manifest.dump(2).c_str());
}
}
