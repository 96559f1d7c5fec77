#include "baker/pace_error.hpp"
#include "baker/area.hpp"
#include "baker/baked_surface.hpp"
#include "engine/core/error.hpp"
#include "shaders/color.h"
#include <algorithm>
#include <cmath>
#include <optional>

namespace afterglow
{
namespace
{
constexpr int kPoints = 512;
constexpr uint kSeed = 17;
constexpr double kLeastSlope = 0.5, kMostSlope = 2.0; // edges of shadows; smooth light

double square(double x) { return x * x; }

struct Point {
    vec3 position, normal;
};

// Uniform over the area of what is baked, on the fronts.
std::vector<Point> pointsOf(const World& world)
{
    const Area area(world);
    std::vector<Point> points;
    for (int i = 0; area.whole() > 0.0 && i < kPoints; ++i) {
        Sampler random = makeSampler(kSeed, uint(i));
        const AreaPoint at = area.point(random);
        points.push_back({at.position, normalize(world.front(at.triangle))});
    }
    return points;
}

// What the runtime finds there; nothing where no lightmap reaches.
std::vector<std::optional<double>> lookUp(const Baked& baked, const World& world, const std::vector<Point>& points)
{
    std::vector<std::optional<double>> found;
    for (const Point& p : points) {
        const std::optional<SurfacePoint> surface = nearestSurface(baked, world, p.position, p.normal);
        found.push_back(surface ? std::optional(double(luminance(lightmapValue(baked, world, *surface, p.normal)))) : std::nullopt);
    }
    return found;
}

double meanSquare(const std::vector<std::optional<double>>& a, const std::vector<std::optional<double>>& b)
{
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] && b[i]) sum += square(*a[i] - *b[i]), ++count;
    return count ? sum / count : 0.0;
}

double meanOf(const std::vector<std::optional<double>>& found)
{
    double sum = 0.0;
    int count = 0;
    for (const std::optional<double>& value : found)
        if (value) sum += *value, ++count;
    return count ? sum / count : 0.0;
}
}

double errorOf(const PaceError& error, const BakeOptions& options)
{
    return std::hypot(error.noise / std::sqrt(double(*options.samples)),
                      error.texels * std::pow(double(*options.texelsPerMetre), -error.slope));
}

double paceDifference(const Baked& a, const Baked& b)
{
    const World world(b.scene, Content::staticOnly);
    const std::vector<Point> points = pointsOf(world);
    const auto found = lookUp(a, World(a.scene, Content::staticOnly), points), wanted = lookUp(b, world, points);
    const double mean = meanOf(wanted);
    return mean > 0.0 ? std::sqrt(meanSquare(found, wanted)) / mean : 0.0;
}

PaceError paceError(const TrialBake& fewer, const TrialBake& fine, const TrialBake& half, const TrialBake& quarter)
{
    check(fewer.samples != fine.samples && half.samples == fine.samples && quarter.samples == fine.samples,
          "trials that tell noise and texels apart");
    const double ofPath = square(paceDifference(fewer.baked, fine.baked)) / (1.0 / fewer.samples + 1.0 / fine.samples); // variance
    const auto changed = [&](const TrialBake& a, const TrialBake& b) { // beyond the noise of both
        return std::sqrt(std::max(square(paceDifference(a.baked, b.baked)) - 2.0 * ofPath / double(fine.samples), 0.0));
    };
    const double first = changed(half, fine), second = changed(quarter, half);
    PaceError error{.noise = std::sqrt(ofPath)};
    if (!(first > 0.0)) return error;
    error.slope = std::clamp(std::log2(second / first), kLeastSlope, kMostSlope);
    error.texels = first / (std::exp2(error.slope) - 1.0) * std::pow(double(fine.texelsPerMetre), error.slope);
    return error;
}
}
