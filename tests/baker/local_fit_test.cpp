// The fits that the filter is made of: polynomials come back as they went in, however little of them an island has.
#include "baker/local_fit.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
struct Floor {
    Lightmap page;
    TexelGuides guides;
    std::vector<TexelFields> fields;
};
}

// Texels a metre apart; `light` of each, by its column and row, in all fields.
template <typename Light>
static Floor floorOf(ivec2 size, Light light)
{
    Floor floor;
    floor.page.width = size.x, floor.page.height = size.y;
    for (int y = 0; y < size.y; y++)
        for (int x = 0; x < size.x; x++) {
            floor.page.texels.push_back(vec3(light(x, y)));
            floor.page.valid.push_back(1);
            floor.guides.position.push_back(vec3(float(x), 0.0f, float(y)));
            floor.guides.normal.push_back(vec3(0.0f, 1.0f, 0.0f));
            floor.guides.half.push_back(vec3(0.0f));
            TexelFields fields;
            fields.fill(light(x, y));
            floor.fields.push_back(fields);
        }
    return floor;
}

static bool touching(std::size_t, std::size_t) { return true; }

static float fitAt(const Floor& floor, const FitSpan& span, ivec2 at)
{
    const Islands islands = islandsOf(floor.page, touching);
    return localFit(fitPage(floor.page, floor.guides, islands), span.order, fitTaps(span), floor.fields, at)[0];
}

// In the middle, at an edge and in a corner, where a mean would be off by the slope; the ridge may move it by a thousandth of that.
TEST(LocalFit, findsItsOwnPolynomial)
{
    const auto plane = [](int x, int y) { return 3.0f + 0.25f * float(x) - 0.125f * float(y); };
    const auto bowl = [](int x, int y) { return 3.0f + 0.05f * float(x * x) - 0.02f * float(x * y) + 0.03f * float(y * y); };
    for (const ivec2 at : {ivec2(12, 12), ivec2(0, 12), ivec2(23, 23)}) {
        EXPECT_NEAR(fitAt(floorOf(ivec2(24), plane), {2.0f, 1, 1}, at), plane(at.x, at.y), 2e-2f) << at.x;
        EXPECT_NEAR(fitAt(floorOf(ivec2(24), bowl), {4.0f, 2, 2}, at), bowl(at.x, at.y), 0.1f) << at.x;
    }
}

TEST(LocalFit, isSteadyWhereThereIsLittle)
{
    const auto even = [](int, int) { return 2.0f; };
    for (const ivec2 size : {ivec2(1, 1), ivec2(2, 1), ivec2(1, 24), ivec2(3, 3)})
        for (const FitSpan& span : {FitSpan{1.0f, 1, 1}, FitSpan{4.0f, 2, 2}, FitSpan{10.0f, 4, 2}})
            EXPECT_NEAR(fitAt(floorOf(size, even), span, ivec2(0)), 2.0f, 2e-2f)
                << size.x << " by " << size.y << ", radius " << span.radius;
}

// What turns away or lies off the plane is not asked.
TEST(LocalFit, keepsToItsSurface)
{
    Floor step = floorOf(ivec2(24), [](int x, int) { return x < 12 ? 1.0f : 5.0f; });
    for (std::size_t i = 0; i < step.guides.position.size(); i++)
        if (i % 24 >= 12) step.guides.position[i].y = 20.0f;
    EXPECT_NEAR(fitAt(step, {4.0f, 2, 2}, ivec2(11, 12)), 1.0f, 1e-3f);
    Floor edge = floorOf(ivec2(24), [](int x, int) { return x < 12 ? 1.0f : 5.0f; });
    for (std::size_t i = 0; i < edge.guides.normal.size(); i++)
        if (i % 24 >= 12) edge.guides.normal[i] = vec3(1.0f, 0.0f, 0.0f);
    EXPECT_NEAR(fitAt(edge, {4.0f, 2, 2}, ivec2(11, 12)), 1.0f, 1e-3f);
}
}
