#include "engine/app/compare.hpp"
#include "engine/app/heat.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "engine/core/flip.hpp"
#include "engine/core/log.hpp"
#include "engine/core/metrics.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace afterglow
{
// Linear to what the screen was given; alpha is left out of every measure.
static Image displayValues(Image image)
{
    for (float& value : image.pixels) value = shared::srgbEncode(value);
    return image;
}

static void printJson(const Difference& d, const Flip& flip, const Image& image, bool displayed)
{
    nlohmann::json result = {{"values", displayed ? "displayed" : "radiance"},
                             {"width", image.width},
                             {"height", image.height},
                             {"rmse", d.rmse},
                             {"relative_rmse", d.relativeRmse},
                             {"rel_mse", d.relMse},
                             {"psnr_db", nullptr}, // of equal pictures
                             {"flip", flip.mean},
                             {"largest_difference", d.largest},
                             {"largest_at", {d.x, d.y}},
                             {"largest_channel", std::string(1, "rgb"[d.channel])},
                             {"mean_a", d.meanA},
                             {"mean_b", d.meanB},
                             {"non_finite", d.nonFinite}};
    if (d.psnr) result["psnr_db"] = *d.psnr;
    std::printf("%s\n", result.dump(2).c_str());
}

static void printTable(const Difference& d, const Flip& flip, bool displayed)
{
    std::printf("values        %s\n", displayed ? "displayed, 0 to 1" : "radiance, scene-linear");
    std::printf("RMSE          %.6g\n", d.rmse);
    std::printf("relative RMSE %.4g %%\n", 100.0 * d.relativeRmse);
    std::printf("relMSE        %.6g\n", d.relMse);
    if (d.psnr)
        std::printf("PSNR          %.2f dB\n", *d.psnr);
    else
        std::printf("PSNR          none: the pictures are equal%s\n", d.nonFinite > 0 ? " where both are finite" : "");
    std::printf("%s    %.5f\n", displayed ? "FLIP (LDR)" : "FLIP (HDR)", flip.mean);
    std::printf("largest       %.6g at pixel %d %d, %s\n", d.largest, d.x, d.y, d.channel == 0 ? "red" : d.channel == 1 ? "green" : "blue");
    std::printf("means         %.6g and %.6g\n", d.meanA, d.meanB);
}

void compare(const CompareOptions& options)
{
    if (!options.heatMap.empty()) {
        requireEnding(options.heatMap, {".png"});
        requireApart({{"-o", options.heatMap}}, {{"A", options.a}, {"B", options.b}});
        requireWritable(options.heatMap);
    }
    const bool displayed = isDisplayed(options.b);
    if (isDisplayed(options.a) != displayed)
        throw Error("cannot compare " + options.a.string() + " with " + options.b.string() +
                    ": one is a displayed picture and one is radiance; render both as .png or both as .exr");
    const Image a = readImage(options.a), b = readImage(options.b);
    const Difference d = displayed ? difference(displayValues(a), displayValues(b), /* peak= */ 1.0) : difference(a, b, /* peak= */ 0.0);
    const Flip flip = displayed ? flipDisplayed(a, b) : flipRadiance(a, b);
    if (d.nonFinite > 0) warning(std::to_string(d.nonFinite) + " values are NaN or infinite in one of the pictures and were left out");

    if (!options.heatMap.empty()) writePng(options.heatMap, heat(flip.map));
    if (options.json)
        printJson(d, flip, a, displayed);
    else
        printTable(d, flip, displayed);
}
}
