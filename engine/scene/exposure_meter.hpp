// The exposure that shows what was seen with its mean, that of the logarithms, as middle grey: the display's rule (shaders/exposure.h).
#pragma once
#include "shaders/exposure.h"
#include <cmath>

namespace afterglow
{
class ExposureMeter
{
public:
    void see(vec3 light) // radiance, linear Rec.709; what is too dark has no say
    {
        const float bright = luminance(light);
        if (bright > kDarkestCounted) logs_ += std::log2(double(bright)), counted_ += 1.0;
    }
    float exposure() const { return counted_ > 0.0 ? kMiddleGrey / float(std::exp2(logs_ / counted_)) : 1.0f; }

private:
    double logs_ = 0.0, counted_ = 0.0;
};
}
