// Borders between charts get short, stay on creases, and leave every chart in one part.
#include "baker/atlas_borders.hpp"
#include "baker/atlas_charts.hpp"
#include "tests/baker/shapes.hpp"
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <set>

namespace afterglow
{
namespace
{
constexpr uint kQuads = 40; // along each side

struct Cut {
    Surface surface;
    std::vector<uint> neighbours, chartOf;

    Cut(const Shape& shape, const std::function<uint(dvec3)>& chartAt)
    {
        const Scene scene = levelOf(shape);
        surface = surfaceOf(scene, scene.meshes[0], dmat3(1.0));
        neighbours = growCharts(surface, 1e-3, unheard).neighbours;
        for (uint t = 0; t < surface.triangles(); ++t)
            chartOf.push_back(chartAt((surface.point(t, 0) + surface.point(t, 1) + surface.point(t, 2)) / 3.0));
    }

    double border() const // m
    {
        double length = 0.0;
        for (uint corner = 0; corner < neighbours.size(); ++corner) {
            const uint t = corner / 3, n = neighbours[corner];
            if (n != kNoTriangle && n > t && chartOf[n] != chartOf[t])
                length += distance(surface.point(t, int(corner % 3)), surface.point(t, int(corner + 1) % 3));
        }
        return length;
    }

    uint parts() const // that hang together
    {
        std::vector<bool> done(surface.triangles());
        uint count = 0;
        for (uint first = 0; first < surface.triangles(); ++first) {
            if (done[first]) continue;
            ++count, done[first] = true;
            std::vector<uint> reached{first};
            for (std::size_t k = 0; k < reached.size(); ++k)
                for (uint i = 0; i < 3; ++i)
                    if (const uint n = neighbours[3 * reached[k] + i]; n != kNoTriangle && !done[n] && chartOf[n] == chartOf[first])
                        done[n] = true, reached.push_back(n);
        }
        return count;
    }

    std::size_t charts() const { return std::set<uint>(chartOf.begin(), chartOf.end()).size(); }
};

Shape square()
{
    return grid(kQuads, kQuads, [](float u, float v) { return vec3(u, 0, -v); });
}
}

TEST(AtlasBorders, AWavyBorderOfASquareBecomesItsMiddle)
{
    Cut cut(square(), [](dvec3 p) { return p.x > 0.5 + 0.1 * std::sin(20.0 * p.z) ? 1u : 0u; });
    const double wavy = cut.border();
    moveBorders(cut.surface, cut.neighbours, cut.chartOf);
    EXPECT_GT(wavy, 2.0);
    EXPECT_LT(cut.border(), std::sqrt(2.0)); // along sides of triangles, a straight line gets no longer in any direction
    for (uint t = 0; t < cut.surface.triangles(); ++t)
        if (const double x = cut.surface.point(t, 0).x; std::abs(x - 0.5) > 2.0 / kQuads) {
            EXPECT_EQ(cut.chartOf[t], x > 0.5 ? 1u : 0u);
        }
}

TEST(AtlasBorders, AnIslandJoinsWhatSurroundsIt)
{
    Cut cut(square(), [](dvec3 p) { return p.x > 0.5 || distance(p, dvec3(0.2, 0.0, -0.5)) < 0.1 ? 1u : 0u; });
    moveBorders(cut.surface, cut.neighbours, cut.chartOf);
    EXPECT_NEAR(cut.border(), 1.0, 0.1);
}

TEST(AtlasBorders, NoChartIsLeftInTwoParts)
{
    // Islands side by side on a bumpy square: where one goes, the next may already have left.
    const Shape bumpy =
        grid(kQuads, kQuads, [](float u, float v) { return vec3(u, 0.05f * std::sin(25.0f * u) * std::sin(20.0f * v), -v); });
    for (uint seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        std::array<uint, 64> chartOfField;
        for (uint& chart : chartOfField) chart = random() % 5;
        Cut cut(bumpy, [&](dvec3 p) { return chartOfField[std::size_t(p.x * 8.0) + 8 * std::size_t(-p.z * 8.0)]; });
        EXPECT_GT(cut.parts(), cut.charts());
        moveBorders(cut.surface, cut.neighbours, cut.chartOf);
        EXPECT_EQ(cut.parts(), cut.charts()) << "seed " << seed;
    }
}

TEST(AtlasBorders, ACreaseStaysABorder)
{
    const Shape roof = grid(kQuads, kQuads, [](float u, float v) { return vec3(u < 0.3f ? u : 0.3f, u < 0.3f ? 0.0f : u - 0.3f, -v); });
    Cut cut(roof, [](dvec3 p) { return p.y > 0.0 ? 1u : 0u; });
    const std::vector<uint> before = cut.chartOf;
    moveBorders(cut.surface, cut.neighbours, cut.chartOf);
    EXPECT_EQ(cut.chartOf, before);
}
}
