#include "baker/local_fit.hpp"
#include <cmath>
#include <Eigen/Dense>

namespace afterglow
{
static constexpr float kReach = 2.5f;  // deviations
static constexpr float kRidge = 1e-3f; // of the weights: what keeps a fit through a row of texels, or one texel, from wandering

FitPage fitPage(const Lightmap& lightmap, const TexelGuides& guides, const Islands& islands)
{
    FitPage page{ivec2(lightmap.width, lightmap.height), islands, guides, std::vector<float>(islands.of.size(), 0.0f)};
    for (int y = 0; y < page.size.y; y++)
        for (int x = 0; x < page.size.x; x++) {
            const std::size_t here = std::size_t(y * page.size.x + x);
            if (islands.of[here] == 0) continue;
            float smallest = kFloatMax;
            for (ivec2 to : {ivec2(x + 1, y), ivec2(x - 1, y), ivec2(x, y + 1), ivec2(x, y - 1)}) {
                const std::size_t there = std::size_t(to.y * page.size.x + to.x);
                if (to == clamp(to, ivec2(0), page.size - 1) && islands.of[there] == islands.of[here])
                    smallest = min(smallest, distance(guides.position[here], guides.position[there]));
            }
            if (smallest < kFloatMax) page.extent[here] = smallest;
        }
    return page;
}

// How alike the places of two texels are: 1 on one plane; cos^16 halves at 17 degrees.
static inline float likeness(const FitPage& page, std::size_t here, std::size_t there)
{
    const vec3 mine = page.guides.normal[here], other = page.guides.normal[there];
    const vec3 offset = page.guides.position[there] - page.guides.position[here];
    const float off = max(abs(dot(offset, mine)), abs(dot(offset, other))) / max(page.extent[here], 1e-30f);
    const float facing = max(dot(mine, other), 0.0f);
    const float second = facing * facing, fourth = second * second, eighth = fourth * fourth;
    return off < 1e-4f ? eighth * eighth : eighth * eighth * std::exp(-off);
}

std::vector<FitTap> fitTaps(const FitSpan& span)
{
    std::vector<FitTap> taps;
    const int reach = int(kReach * span.radius) / span.stride;
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            const ivec2 step = ivec2(i, j) * span.stride;
            const vec2 p = vec2(step) / span.radius;
            if (dot(p, p) <= kReach * kReach)
                taps.push_back({step, {1.0f, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y, 0.0f, 0.0f}, std::exp(-0.5f * dot(p, p))});
        }
    return taps;
}

template <int Terms>
static TexelFields fit(const FitPage& page, const std::vector<FitTap>& taps, const std::vector<TexelFields>& fields, ivec2 at)
{
    const std::size_t here = std::size_t(at.y * page.size.x + at.x);
    // Sums over the taps, of each term with all terms and with all fields
    float terms[Terms][8] = {}, sums[Terms][std::tuple_size_v<TexelFields>] = {};
    for (const FitTap& tap : taps) {
        const ivec2 to = at + tap.step;
        if (to.x < 0 || to.y < 0 || to.x >= page.size.x || to.y >= page.size.y) continue;
        const std::size_t there = std::size_t(to.y * page.size.x + to.x);
        if (page.islands.of[there] != page.islands.of[here]) continue;
        const float weight = tap.weight * likeness(page, here, there);
        const TexelFields& field = fields[there];
        for (std::size_t k = 0; k < Terms; k++) {
            const float own = weight * tap.terms[k];
            for (std::size_t l = 0; l < 8; l++) terms[k][l] += own * tap.terms[l];
            for (std::size_t f = 0; f < field.size(); f++) sums[k][f] += own * field[f];
        }
    }
    Eigen::Matrix<float, Terms, Terms> normal;
    for (int k = 0; k < Terms; k++)
        for (int l = 0; l < Terms; l++) normal(k, l) = terms[k][l] + (k == l && k > 0 ? kRidge * terms[0][0] : 0.0f);
    const Eigen::Matrix<float, Terms, 1> share = normal.llt().solve(Eigen::Matrix<float, Terms, 1>::Unit(0));
    TexelFields fitted{};
    for (int k = 0; k < Terms; k++)
        for (std::size_t f = 0; f < fitted.size(); f++) fitted[f] += share(k) * sums[k][f];
    return fitted;
}

TexelFields localFit(const FitPage& page, int order, const std::vector<FitTap>& taps, const std::vector<TexelFields>& fields, ivec2 at)
{
    return order == 1 ? fit<3>(page, taps, fields, at) : fit<6>(page, taps, fields, at);
}
}
