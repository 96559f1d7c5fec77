#include "baker/stitch.hpp"
#include "baker/seam_rounding.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/exposure.h"
#include "shaders/lightmap.h"
#include <cmath>

namespace afterglow
{
namespace
{
constexpr double kStep = 0.25; // steps of a display: what may be left at a point counts like one standard error of a texel
// Of how light bends from texel to texel: by so much do two chains of chords about one parabola differ along an edge, root mean square,
// where their texels lie otherwise. Without it charts of few texels go flat to agree.
constexpr double kBlur = 0.125;
constexpr double kGuess = 0.25;          // of the light: standard error of a dilated texel
constexpr double kRounding = 1.0 / 1024; // of the light: a texel's file knows it no better
// Steps of a display: what the equations ask for, and from which on the file's rounding of texels is asked again. Plain rounding leaves 64 of
// 11 436 points of the gallery above 1, this a few: of a dark channel beside a bright one a unit of the file is two steps.
constexpr double kAgreed = 0.35, kRounded = 0.7;

// Of the texels of a patch, one for each channel: three of light, four of direction if there are any.
using Channels = std::vector<std::vector<double>>;
}

// By how much light may change around a value before a display shows it. Above middle grey it is a share of the light: what is brighter is
// looked at with less exposure, or on a darker surface.
static double tolerance(const Shown& shown, float light)
{
    const float grey = kMiddleGrey / shown.exposure, here = clamp(light, 1e-3f * grey, grey), h = 0.01f * here;
    const float slope = (shown(here + h) - shown(here - h)) / (2.0f * h);
    return double(max(light / here, 1.0f) / slope);
}

static double tolerance(const Shown& shown, vec3 light)
{
    return min(min(tolerance(shown, light.x), tolerance(shown, light.y)), tolerance(shown, light.z));
}

static vec3 lightAt(const Channels& values, const std::array<Weighted, 4>& lookup)
{
    vec3 sum(0.0f);
    for (const Weighted& w : lookup) sum += w.weight * vec3(values[0][w.texel], values[1][w.texel], values[2][w.texel]);
    return sum;
}

// What may be left of the difference at each point. Where many points share a texel's length, each has less than one's say.
static std::vector<double> leftAt(const SeamPatch& patch, const Seams& seams, const Channels& values, const Shown& shown)
{
    std::vector<double> left;
    for (std::size_t p = 0; p < patch.points.size(); p++) {
        vec3 light(0.0f);
        double bend = 0.0;
        for (const auto& side : patch.side) {
            light += 0.5f * lightAt(values, side[p]);
            for (const Weighted& w : side[p]) bend += 0.5 * double(w.weight * seams.texels[patch.texels[w.texel]].bend);
        }
        left.push_back((kStep * tolerance(shown, light) + kBlur * bend) / std::sqrt(double(seams.points[patch.points[p]].share)));
    }
    return left;
}

// The brightest light at the points that a texel takes part in. Were it its own light, the bright side of a step would give way to the
// dark.
static std::vector<double> lightAbout(const SeamPatch& patch, const Channels& values, double least)
{
    std::vector<double> light(patch.texels.size(), least);
    for (std::size_t p = 0; p < patch.points.size(); p++) {
        double brightest = 0.0;
        for (const auto& side : patch.side) brightest = max(brightest, double(luminance(lightAt(values, side[p]))));
        for (const auto& side : patch.side)
            for (const Weighted& w : side[p])
                if (w.weight > 0.0f) light[w.texel] = max(light[w.texel], brightest);
    }
    return light;
}

static std::vector<double> errorsOf(const SeamPatch& patch, const Seams& seams, const Channels& values, const Shown& shown)
{
    const std::vector<double> light = lightAbout(patch, values, tolerance(shown, 0.0f));
    std::vector<double> error;
    for (std::size_t i = 0; i < patch.texels.size(); i++) {
        const SeamTexel& texel = seams.texels[patch.texels[i]];
        // The mean of a part of it lies up to half a texel from its middle
        const double noise = std::hypot(std::sqrt(double(texel.variance)), kRounding * light[i]),
                     off = double((1.0f - texel.share) * texel.spread);
        error.push_back(texel.measured ? std::hypot(noise, off) : kGuess * light[i]);
    }
    return error;
}

static Channels valuesOf(const std::vector<Lightmap>& pages, const SeamPatch& patch, const Seams& seams)
{
    const bool directional = !pages.front().direction.empty();
    Channels values(directional ? 7 : 3);
    for (uint i : patch.texels) {
        const SeamTexel& texel = seams.texels[i];
        const Lightmap& page = pages[texel.page];
        for (int c = 0; c < 3; c++) values[std::size_t(c)].push_back(double(page.texels[texel.texel][c]));
        for (int c = 0; directional && c < 4; c++) values[std::size_t(3 + c)].push_back(double(page.direction[texel.texel][c]));
    }
    return values;
}

static void write(const Channels& values, const SeamPatch& patch, const Seams& seams, std::vector<Lightmap>& pages)
{
    for (std::size_t i = 0; i < patch.texels.size(); i++) {
        const SeamTexel& texel = seams.texels[patch.texels[i]];
        pages[texel.page].texels[texel.texel] = vec3(values[0][i], values[1][i], values[2][i]);
        if (values.size() == 3) continue;
        vec4& direction = pages[texel.page].direction[texel.texel];
        direction = vec4(values[3][i], values[4][i], values[5][i], values[6][i]);
        if (texel.measured) direction = directionAbout(vec3(direction), texel.normal);
    }
}

static Channels stitched(const SeamPatch& patch, const Seams& seams, Channels values, const Shown& shown)
{
    const Asked asked{errorsOf(patch, seams, values, shown), leftAt(patch, seams, values, shown)};
    if (values.size() > 3) {
        const Channels direction = likeliest(patch, asked, {values.begin() + 3, values.end()});
        std::copy(direction.begin(), direction.end(), values.begin() + 3);
    }
    const StepOf stepOf = [&](double a, double b) { return double(abs(shown(float(a)) - shown(float(b)))); };
    for (std::size_t c = 0; c < 3; c++) values[c] = agreed(patch, asked, values[c], stepOf, kAgreed);
    std::vector<vec3> light;
    for (std::size_t i = 0; i < patch.texels.size(); i++) light.emplace_back(values[0][i], values[1][i], values[2][i]);
    roundTogether(patch, light, stepOf, kRounded);
    for (std::size_t i = 0; i < light.size(); i++)
        for (int c = 0; c < 3; c++) values[std::size_t(c)][i] = double(light[i][c]);
    return values;
}

void stitch(std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown, int threads)
{
    const std::vector<SeamPatch> patches = seamPatches(seams);
    std::vector<Channels> found(patches.size());
    parallelFor(patches.size(), threads,
                [&](std::size_t i) { found[i] = stitched(patches[i], seams, valuesOf(pages, patches[i], seams), shown); });
    for (std::size_t i = 0; i < patches.size(); i++) write(found[i], patches[i], seams, pages);
}
}
