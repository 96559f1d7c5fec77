// The equations of a patch of seams: values of its texels with which both sides of every point read the same, as near as may be to those
// that were measured.
#pragma once
#include "baker/seam_patches.hpp"
#include <functional>

namespace afterglow
{
// All are of one unit: that of the values.
struct Asked {
    std::vector<double> error; // of each texel: its standard error
    std::vector<double> left;  // of each point: a difference that counts like one standard error of a texel
};

// By how many steps of a display two values of a channel of light differ.
using StepOf = std::function<double(double, double)>;

// The most likely values: a texel moves the less the better it is known. A column for each channel. Those measured, where there are no others.
std::vector<std::vector<double>> likeliest(const SeamPatch& patch, const Asked& asked, const std::vector<std::vector<double>>& measured);

// The same for one channel of light, none of it negative, with every point the heavier the longer its step stays above `target`.
std::vector<double> agreed(const SeamPatch& patch, const Asked& asked, const std::vector<double>& light, const StepOf& stepOf,
                           double target);
}
