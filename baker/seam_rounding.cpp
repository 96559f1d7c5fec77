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

    // One after the other moves the texel of each point that helps most; whether any did.
    bool sweep()
    {
        bool any = false;
        for (uint p = 0; p < patch_.points.size(); p++)
            if (excess(p) > 0.0) any |= improve(p);
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
                const float was = values_[w.texel], unit = units_[w.texel];
                const double before = excessAbout(w.texel);
                for (float to : {was - unit, was + unit}) {
                    if (to < 0.0f || to > kMantissaMax * unit) continue;
                    values_[w.texel] = to;
                    if (const double gain = before - excessAbout(w.texel); gain > most) best = w.texel, value = to, most = gain;
                }
                values_[w.texel] = was;
            }
        if (most > 0.0) values_[best] = value;
        return most > 0.0;
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
        for (int sweep = 0; sweep < kSweeps && channel.sweep();) ++sweep;
        for (std::size_t i = 0; i < light.size(); i++) rounded[i][c] = channel[i];
    }
    for (std::size_t i = 0; i < light.size(); i++)
        if (rounded[i] != plain[i]) light[i] = rounded[i];
}
}
