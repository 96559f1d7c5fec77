#include "baker/seam_steps.hpp"
#include "engine/scene/exposure_meter.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr double kMost = 0.95; // of the length of all seams

float Shown::operator()(float light) const { return 255.0f * srgbEncode(toneMap(exposure * light, curve)); }

Shown shownAs(const Display& display, const std::vector<Lightmap>& pages)
{
    Shown shown{1.0f, uint(display.curve)};
    if (display.exposureEv) {
        shown.exposure = exposureFromEv(*display.exposureEv);
        return shown;
    }
    ExposureMeter meter;
    for (const Lightmap& page : pages)
        for (std::size_t i = 0; i < page.texels.size(); i++)
            if (page.valid[i] == 1) meter.see(page.texels[i]);
    shown.exposure = meter.exposure();
    return shown;
}

vec3 lookup(const Lightmap& page, vec2 at)
{
    vec3 sum(0.0f);
    for (const Weighted& w : footprint(ivec2(page.width, page.height), at))
        sum += w.weight * decodeSharedExponent(encodeSharedExponent(page.texels[w.texel]));
    return sum;
}

// Both sides at an end of what a display shows, in every channel: unlit, or lit by the sky about a level.
static bool showsNothing(const vec3 (&code)[2])
{
    const float white = 255.0f * srgbEncode(1.0f); // as it is rounded
    for (int c = 0; c < 3; c++)
        if (code[0][c] != code[1][c] || (code[0][c] > 0.0f && code[0][c] < white)) return false;
    return true;
}

SeamSteps stepsOf(const std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown)
{
    struct Step {
        float size, share;
    };
    std::vector<Step> steps;
    double sum = 0.0, all = 0.0;
    for (const SeamPoint& point : seams.points) {
        vec3 code[2];
        for (int s = 0; s < 2; s++) code[s] = shown(lookup(pages[point.side[s].page], point.side[s].at));
        if (showsNothing(code)) continue;
        steps.push_back({largestOf(abs(code[0] - code[1])), point.share});
        sum += double(point.share) * double(steps.back().size);
        all += double(point.share);
    }
    if (steps.empty()) return {};
    std::sort(steps.begin(), steps.end(), [](const Step& a, const Step& b) { return a.size < b.size; });
    SeamSteps result{sum / all, 0.0, double(steps.back().size)};
    double below = 0.0;
    for (const Step& step : steps) {
        if (below >= kMost * all) break;
        result.most = double(step.size);
        below += double(step.share);
    }
    return result;
}
}
