#include "engine/core/metrics.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
Difference difference(const Image& a, const Image& b, double peak)
{
    if (a.width != b.width || a.height != b.height)
        throw Error("cannot compare a picture of " + std::to_string(a.width) + " x " + std::to_string(a.height) + " with one of " +
                    std::to_string(b.width) + " x " + std::to_string(b.height) + ": render both at one size");
    constexpr double darkest = 0.01; // keeps black pixels from dividing by zero; the value that relMSE is usually printed for
    const int channels = std::min({a.channels, b.channels, 3});
    Difference d;
    double squares = 0, relative = 0, brightest = 0;
    std::uint64_t count = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            for (int c = 0; c < channels; ++c) {
                const double va = double(a.at(x, y)[c]), vb = double(b.at(x, y)[c]), apart = va - vb;
                if (!std::isfinite(apart)) {
                    ++d.nonFinite;
                    continue;
                }
                ++count;
                d.meanA += va;
                d.meanB += vb;
                squares += apart * apart;
                relative += apart * apart / (vb * vb + darkest);
                brightest = std::max(brightest, vb);
                if (std::abs(apart) > d.largest) d.largest = std::abs(apart), d.x = x, d.y = y, d.channel = c;
            }
        }
    }
    if (count == 0) throw Error("cannot compare pictures of which one is NaN or infinite everywhere; render it again");
    d.meanA /= double(count);
    d.meanB /= double(count);
    const double mse = squares / double(count);
    d.rmse = std::sqrt(mse);
    d.relativeRmse = d.meanB != 0 ? d.rmse / std::abs(d.meanB) : d.rmse;
    d.relMse = relative / double(count);
    if (peak <= 0) peak = brightest > 0 ? brightest : 1;
    if (mse > 0) d.psnr = 10 * std::log10(peak * peak / mse);
    return d;
}
}
