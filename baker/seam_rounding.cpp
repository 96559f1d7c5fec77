#include "baker/seam_rounding.hpp"
#include "shaders/lightmap.h"
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kSweeps = 16;            // over the points that still step
constexpr float kMantissaMax = 511.0f; // of 9 bits

// One channel of the texels, in what its file can hold.
class RoundedChannel
{
public:
    RoundedChannel(const SeamPatch& patch, const StepOf& stepOf, double target, std::vector<float> values, const std::vector<float>& units)
        : values_(std::move(values)), patch_(patch), stepOf_(stepOf), target_(target), units_(units), pointsOf_(patch.texels.size())
    {
        for (uint p = 0; p < patch.points.size(); p++)
            for (const auto& side : patch.side)
                for (const Weighted& w : side[p])
                    if (w.weight > 0.0f && (pointsOf_[w.texel].empty() || pointsOf_[w.texel].back() != p)) pointsOf_[w.texel].push_back(p);
    }

    // One after the other moves the texel of each point that helps most, or two of them where no single one helps; whether any did.
    bool sweep()
    {
        bool any = false;
        for (uint p = 0; p < patch_.points.size(); p++)
            if (excess(p) > 0.0) any |= improve(p) || improveByTwo(p);
        return any;
    }
    float operator[](std::size_t texel) const { return values_[texel]; }

private:
    double lookup(const std::array<Weighted, 4>& touched) const
    {
        double sum = 0.0;
        for (const Weighted& w : touched) sum += double(w.weight) * double(values_[w.texel]);
        return sum;
    }
    double excess(uint point) const { return max(stepOf_(lookup(patch_.side[0][point]), lookup(patch_.side[1][point])) - target_, 0.0); }
    double excessAbout(std::size_t texel) const
    {
        double sum = 0.0;
        for (uint p : pointsOf_[texel]) sum += excess(p) * excess(p);
        return sum;
    }

    bool improve(uint point)
    {
        std::size_t best = 0;
        float value = 0.0f;
        double most = 0.0;
        for (const auto& side : patch_.side)
            for (const Weighted& w : side[point]) {
                if (!(w.weight > 0.0f)) continue;
                const float was = values_[w.texel];
                const double before = excessAbout(w.texel);
                for (int way : {-1, 1}) {
                    if (!move(w.texel, way)) continue;
                    if (const double gain = before - excessAbout(w.texel); gain > most)
                        best = w.texel, value = values_[w.texel], most = gain;
                    values_[w.texel] = was;
                }
            }
        if (most > 0.0) values_[best] = value;
        return most > 0.0;
    }

    // By a unit up or down, where the file can hold that.
    bool move(std::size_t texel, int way)
    {
        const float to = values_[texel] + float(way) * units_[texel];
        if (to < 0.0f || to > kMantissaMax * units_[texel]) return false;
        values_[texel] = to;
        return true;
    }

    bool improveByTwo(uint point)
    {
        std::vector<std::size_t> touched;
        for (const auto& side : patch_.side)
            for (const Weighted& w : side[point])
                if (w.weight > 0.0f) touched.push_back(w.texel);
        for (std::size_t first : touched)
            for (std::size_t second : touched)
                for (const ivec2 way : {ivec2(-1, -1), ivec2(-1, 1), ivec2(1, -1), ivec2(1, 1)}) {
                    if (!(first < second)) continue;
                    const float was[2] = {values_[first], values_[second]};
                    // A point about both counts twice before and after
                    const double before = excessAbout(first) + excessAbout(second);
                    if (move(first, way.x) && move(second, way.y) && excessAbout(first) + excessAbout(second) < before) return true;
                    values_[first] = was[0], values_[second] = was[1];
                }
        return false;
    }

    std::vector<float> values_;
    const SeamPatch& patch_;
    const StepOf& stepOf_;
    double target_;
    const std::vector<float>& units_;
    std::vector<std::vector<uint>> pointsOf_; // by texel
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
