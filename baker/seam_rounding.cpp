#include "baker/seam_rounding.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace afterglow
{
namespace
{
constexpr int kSweeps = 16;            // over the points that still step
constexpr int kTogether = 3;           // texels of a point that are moved at once
constexpr int kRepairs = 4;            // over the points about a texel that was moved
constexpr uint kNone = ~0u;            // of the texels
constexpr float kMantissaMax = 511.0f; // of 9 bits

// One channel of the texels, in what its file can hold.
class RoundedChannel
{
public:
    RoundedChannel(const SeamPatch& patch, const StepOf& stepOf, double target, std::vector<float> values, const std::vector<float>& units)
        : values_(std::move(values)), patch_(patch), stepOf_(stepOf), target_(target), units_(units), pointsOf_(patch.texels.size()),
          all_(patch.points.size())
    {
        std::iota(all_.begin(), all_.end(), 0u);
        for (uint p = 0; p < patch.points.size(); p++)
            for (const auto& side : patch.side)
                for (const Weighted& w : side[p])
                    if (w.weight > 0.0f && (pointsOf_[w.texel].empty() || pointsOf_[w.texel].back() != p)) pointsOf_[w.texel].push_back(p);
    }

    // One after the other moves what helps each point most: one of its texels, or two, or three where fewer do not help, or what its neighbours
    // then make up for; whether any did.
    bool sweep()
    {
        bool any = false;
        for (uint p = 0; p < patch_.points.size(); p++) any |= excess(p) > 0.0 && (improve(p, kTogether) || kick(p));
        return any;
    }
    float operator[](std::size_t texel) const { return values_[texel]; }

private:
    struct Search { // about one point
        std::set<uint> texels;
        std::vector<uint> points; // that read any of them, ascending
        std::vector<std::pair<uint, float>> moved, best;
        double least = 0.0;
    };

    double lookup(const std::array<Weighted, 4>& touched) const
    {
        double sum = 0.0;
        for (const Weighted& w : touched) sum += double(w.weight) * double(values_[w.texel]);
        return sum;
    }
    double excess(uint point) const { return max(stepOf_(lookup(patch_.side[0][point]), lookup(patch_.side[1][point])) - target_, 0.0); }
    double excessOf(const std::vector<uint>& points) const
    {
        double sum = 0.0;
        for (uint p : points) sum += excess(p) * excess(p);
        return sum;
    }

    std::set<uint> texelsOf(uint point) const
    {
        std::set<uint> texels;
        for (const auto& side : patch_.side)
            for (const Weighted& w : side[point])
                if (w.weight > 0.0f) texels.insert(uint(w.texel));
        return texels;
    }

    // By no more texels at once than that, none of them the one that is held.
    bool improve(uint point, int together)
    {
        Search search{texelsOf(point), {}, {}, {}, 0.0};
        search.texels.erase(held_);
        for (uint texel : search.texels) search.points.insert(search.points.end(), pointsOf_[texel].begin(), pointsOf_[texel].end());
        std::sort(search.points.begin(), search.points.end());
        search.points.erase(std::unique(search.points.begin(), search.points.end()), search.points.end());
        search.least = excessOf(search.points);
        for (int many = 1; many <= together && search.best.empty(); ++many) move(search, search.texels.begin(), many);
        for (const auto& [texel, value] : search.best) values_[texel] = value;
        return !search.best.empty();
    }

    // By a unit up or down, where the file can hold that.
    bool nudge(uint texel, int way)
    {
        const float to = values_[texel] + float(way) * units_[texel];
        if (to < 0.0f || to > kMantissaMax * units_[texel]) return false;
        values_[texel] = to;
        return true;
    }

    // Moves a texel of the point that alone helps too little, and holds it there until the points about it have found their way; whether the
    // patch is better for it. If not, all is as before.
    bool kick(uint point)
    {
        const std::vector<float> before = values_;
        const double most = excessOf(all_);
        for (uint texel : texelsOf(point))
            for (int way : {-1, 1}) {
                if (!nudge(texel, way)) continue;
                held_ = texel;
                for (int pass = 0; pass < kRepairs; ++pass)
                    for (uint p : pointsOf_[texel])
                        if (excess(p) > 0.0) improve(p, 1);
                held_ = kNone;
                if (excessOf(all_) < most) return true;
                values_ = before;
            }
        return false;
    }

    // Moves so many more texels, of those from `next` on.
    void move(Search& search, std::set<uint>::const_iterator next, int many)
    {
        if (many == 0) {
            const double left = excessOf(search.points);
            if (left < search.least) search.least = left, search.best = search.moved;
            return;
        }
        for (; next != search.texels.end(); ++next)
            for (int way : {-1, 1}) {
                const float was = values_[*next];
                if (!nudge(*next, way)) continue;
                search.moved.emplace_back(*next, values_[*next]);
                move(search, std::next(next), many - 1);
                search.moved.pop_back();
                values_[*next] = was;
            }
    }

    std::vector<float> values_;
    const SeamPatch& patch_;
    const StepOf& stepOf_;
    double target_;
    const std::vector<float>& units_;
    std::vector<std::vector<uint>> pointsOf_; // by texel
    std::vector<uint> all_;                   // points
    uint held_ = kNone;                       // texel that does not move
};
}

void roundTogether(const SeamPatch& patch, std::vector<vec3>& light, const StepOf& stepOf, double target)
{
    std::vector<vec3> plain;
    std::vector<float> units; // of the last bit
    for (const vec3& texel : light) {
        const uint packed = encodeSharedExponent(texel);
        plain.push_back(decodeSharedExponent(packed));
        units.push_back(std::exp2(float(int(packed >> 27u) - 24)));
    }
    std::vector<vec3> rounded = plain;
    for (int c = 0; c < 3; c++) {
        std::vector<float> values;
        for (const vec3& texel : plain) values.push_back(texel[c]);
        RoundedChannel channel(patch, stepOf, target, std::move(values), units);
        for (int sweep = 0; sweep < kSweeps; ++sweep)
            if (!channel.sweep()) break;
        for (std::size_t i = 0; i < light.size(); i++) rounded[i][c] = channel[i];
    }
    for (std::size_t i = 0; i < light.size(); i++)
        if (rounded[i] != plain[i]) light[i] = rounded[i];
}
}
