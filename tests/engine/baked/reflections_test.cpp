#include "engine/baked/reflections.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static ReflectionProbe probe()
{
    ReflectionProbe made;
    made.name = "hall \"north\"";
    made.position = vec3(0.1f, -2.0f, 1.0f / 3.0f);
    made.boxLower = vec3(-1.0f, -3e-7f, -4.0f);
    made.boxUpper = vec3(1.0f, 3.0f, 4e7f);
    made.size = 8;
    for (int m = 0; m < 4; ++m) {
        made.mips.emplace_back();
        for (int i = 0; i < 6 * (8 >> m) * (8 >> m); ++i) made.mips.back().push_back(vec3(float(i), 0.25f * float(m), 2.0f));
    }
    return made;
}

static void expectEqual(const ReflectionProbe& a, const ReflectionProbe& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.boxLower, b.boxLower);
    EXPECT_EQ(a.boxUpper, b.boxUpper);
    EXPECT_EQ(a.size, b.size);
    EXPECT_EQ(a.mips, b.mips);
}

TEST(Reflections, come_back_as_they_were)
{
    expectEqual(readReflection(reflectionTexture(probe()), "test"), probe());
    ReflectionProbe sun = probe();
    sun.mips[0][7] = vec3(1.6e9f, 1.5e9f, 1.4e9f);
    expectEqual(readReflection(reflectionTexture(sun), "test"), sun);
}

// Far out, the file speaks the level's own coordinates.
TEST(Reflections, of_a_level_far_out_stand_where_it_stands)
{
    const dvec3 origin(1e6, -2e6, 3e6);
    const Ktx2 texture = reflectionTexture(probe(), origin);
    EXPECT_NEAR(readNumbersText(texture, "ag_position", 3, "test")[1], -2000002.0, 1e-8);
    const ReflectionProbe back = readReflection(texture, "test", origin);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(back.position[axis], probe().position[axis], 1e-7f);
        EXPECT_NEAR(back.boxLower[axis], probe().boxLower[axis], 1e-7f);
    }
}

TEST(Reflections, without_a_place_or_a_cube_are_refused)
{
    Ktx2 texture = reflectionTexture(probe());
    texture.keys.erase("ag_box");
    EXPECT_THROW(readReflection(texture, "test"), Error);
    texture = reflectionTexture(probe());
    texture.faces = 1;
    EXPECT_THROW(readReflection(texture, "test"), Error);
}
}
