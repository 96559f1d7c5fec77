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

// Of the first channel.
static double meanDeviation(const Image& image, const Image& from)
{
    const std::size_t count = std::size_t(image.width) * image.height;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += std::abs(double(image.pixels[i * image.channels]) - double(from.pixels[i * from.channels]));
    return sum / double(count);
}

// Points of the hemisphere scatter about their own mean as random ones do, or better: N^-1/2. The mean itself stays off (the study's table).
TEST_F(OcclusionLaws, slowPointsByTheirNumber)
{
    wedge();
    const auto drawn = [&](uint samples) {
        OcclusionParameters p = fine();
        p.samples = samples;
        return visibility(camera, OcclusionMethod::ssao, p);
    };
    const Image limit = drawn(4096);
    std::vector<std::pair<double, double>> points;
    for (const uint samples : {8u, 16u, 32u, 64u, 128u, 256u}) {
        const Image image = drawn(samples);
        points.emplace_back(samples, meanDeviation(image, limit));
        std::printf("ssao, %u points: mean absolute deviation %.4f\n", samples, points.back().second);
    }
    EXPECT_LT(slopeOf(points), -0.5 + 0.15);
}

// Rays scatter about their mean, which the closed forms hold, as independent ones do, or better: they are stratified.
TEST_F(OcclusionLaws, slowRaysByTheirNumber)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    wedge();
    size = {64, 64};
    const auto drawn = [&](uint rays) {
        OcclusionParameters p = fine();
        p.rays = rays;
        return visibility(camera, OcclusionMethod::ray, p);
    };
    const Image limit = drawn(1024);
    std::vector<std::pair<double, double>> points;
    for (const uint rays : {2u, 4u, 8u, 16u, 32u, 64u}) {
        const Image image = drawn(rays);
        points.emplace_back(rays, meanDeviation(image, limit));
        std::printf("ray, %u rays: mean absolute deviation %.4f\n", rays, points.back().second);
    }
    EXPECT_LT(slopeOf(points), -0.5 + 0.15);
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
