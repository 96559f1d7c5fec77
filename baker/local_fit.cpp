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
static float likeness(const FitPage& page, std::size_t here, std::size_t there)
{
    const vec3 mine = page.guides.normal[here], other = page.guides.normal[there];
    const vec3 offset = page.guides.position[there] - page.guides.position[here];
    const float off = max(abs(dot(offset, mine)), abs(dot(offset, other))) / max(page.extent[here], 1e-30f);
    const float facing = max(dot(mine, other), 0.0f);
    const float second = facing * facing, fourth = second * second, eighth = fourth * fourth;
    return off < 1e-4f ? eighth * eighth : eighth * eighth * std::exp(-off);
}

template <int Terms>
static TexelFields fit(const FitPage& page, const FitSpan& span, const std::vector<TexelFields>& fields, ivec2 at)
{
    const std::size_t here = std::size_t(at.y * page.size.x + at.x);
    const int reach = int(kReach * span.radius) / span.stride;
    Eigen::Matrix<float, Terms, Terms> normal = Eigen::Matrix<float, Terms, Terms>::Zero();
    std::array<TexelFields, Terms> right{};
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            const ivec2 step = ivec2(i, j) * span.stride, to = at + step;
            const vec2 apart = vec2(step) / span.radius;
            const float squared = dot(apart, apart);
            if (squared > kReach * kReach || to != clamp(to, ivec2(0), page.size - 1)) continue;
            const std::size_t there = std::size_t(to.y * page.size.x + to.x);
            if (page.islands.of[there] != page.islands.of[here]) continue;
            const float weight = std::exp(-0.5f * squared) * likeness(page, here, there);
            const float all[6] = {1.0f, apart.x, apart.y, apart.x * apart.x, apart.x * apart.y, apart.y * apart.y};
            for (int k = 0; k < Terms; k++) {
                const float own = weight * all[k];
                for (int l = 0; l <= k; l++) normal(k, l) += own * all[l];
                for (std::size_t f = 0; f < right[0].size(); f++) right[std::size_t(k)][f] += own * fields[there][f];
            }
        }
    for (int k = 1; k < Terms; k++) normal(k, k) += kRidge * normal(0, 0);
    const Eigen::Matrix<float, Terms, 1> share =
        normal.template selfadjointView<Eigen::Lower>().llt().solve(Eigen::Matrix<float, Terms, 1>::Unit(0));
    TexelFields fitted{};
    for (int k = 0; k < Terms; k++)
        for (std::size_t f = 0; f < fitted.size(); f++) fitted[f] += share(k) * right[std::size_t(k)][f];
    return fitted;
}

TexelFields localFit(const FitPage& page, const FitSpan& span, const std::vector<TexelFields>& fields, ivec2 at)
{
    return span.order == 1 ? fit<3>(page, span, fields, at) : fit<6>(page, span, fields, at);
}
}
