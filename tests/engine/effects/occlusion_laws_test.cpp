// The cost laws of the occlusion methods: error against their knobs.
#include "tests/engine/effects/occluded.hpp"

namespace afterglow
{
// Slope of log error over log parameter, by least squares.
static double slopeOf(const std::vector<std::pair<double, double>>& points)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [parameter, error] : points) {
        const double a = std::log(parameter), b = std::log(error);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    const double n = double(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

// Of the first channel.
static double meanDeviation(const Image& image, const Image& from)
{
    const std::size_t count = std::size_t(image.width) * image.height;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += std::abs(double(image.pixels[i * image.channels]) - double(from.pixels[i * from.channels]));
    return sum / double(count);
}

class OcclusionLaws : public Occlusion
{
protected:
    OcclusionParameters fine()
    {
        OcclusionParameters p = within(1.0f);
        p.divisor = 1;
        p.slices = 16;
        p.smooth_ = 0;
        p.cones = 64;
        p.aperture = 0.0f; // the finest voxels all along
        return p;
    }
    void wedge()
    {
        size = {128, 128};
        floor();
        slope(60.0f);
    }
    // The slope by which pictures of `first` samples, and of 2, 4 ... 32 times as many, scatter about one of `limit`.
    double scatter(OcclusionMethod method, const char* samples, uint OcclusionParameters::*number, uint first, uint limit)
    {
        const auto drawn = [&](uint count) {
            OcclusionParameters p = fine();
            p.*number = count;
            return visibility(camera, method, p);
        };
        const Image mean = drawn(limit);
        std::vector<std::pair<double, double>> points;
        for (uint count = first; count <= 32 * first; count *= 2) {
            points.emplace_back(count, meanDeviation(drawn(count), mean));
            std::printf("%u %s: mean absolute deviation %.4f\n", count, samples, points.back().second);
        }
        return slopeOf(points);
    }
    const Camera camera = lookAt(5.0f * vec3(std::cos(2.618f), std::sin(2.618f), 0), vec3(-0.5f, 0, 0), 0.7f);
};

// On a depth buffer that sees both planes the error of the horizons falls as 1 / steps, until pixels are as coarse as the halved steps.
TEST_F(OcclusionLaws, slowHorizonsByTheirSteps)
{
    wedge();
    std::vector<std::pair<double, double>> points;
    for (const uint steps : {2u, 4u, 8u}) {
        OcclusionParameters p = fine();
        p.steps = steps;
        points.emplace_back(steps, floorError(camera, OcclusionMethod::hbao, p));
        std::printf("hbao, %u steps: mean absolute error %.4f\n", steps, points.back().second);
    }
    EXPECT_NEAR(slopeOf(points), -1.0, 0.15);
}

// Points of the hemisphere scatter about their own mean as random ones do, or better: N^-1/2. The mean itself stays off (the study's
// table).
TEST_F(OcclusionLaws, slowPointsByTheirNumber)
{
    wedge();
    EXPECT_LT(scatter(OcclusionMethod::ssao, "points", &OcclusionParameters::samples, 8, 4096), -0.5 + 0.15);
}

// Rays scatter about their mean, which the closed forms hold, as independent ones do, or better: they are stratified.
TEST_F(OcclusionLaws, slowRaysByTheirNumber)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    wedge();
    size = {64, 64};
    EXPECT_LT(scatter(OcclusionMethod::ray, "rays", &OcclusionParameters::rays, 2, 1024), -0.5 + 0.15);
}

// The error of the cones falls with the edge of a voxel.
TEST_F(OcclusionLaws, slowConesByTheEdgeOfAVoxel)
{
    size = {96, 96};
    floor();
    wall(0, 1);
    const Camera before = lookAt(vec3(-4, 3, 0), vec3(-0.5f, 0, 0), 0.7f);
    std::vector<std::pair<double, double>> points;
    for (const double edge : {0.32, 0.16, 0.08, 0.04, 0.02}) {
        const auto most = std::size_t(10.0 * 10.0 * 1.0 / (edge * edge * edge));
        points.emplace_back(edge, floorError(before, OcclusionMethod::voxel, fine(), most));
        std::printf("voxel, edge %.2f m: mean absolute error %.4f\n", edge, points.back().second);
    }
    EXPECT_NEAR(slopeOf(points), 1.0, 0.15);
}
}
