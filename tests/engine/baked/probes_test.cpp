#include "engine/baked/probes.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include "shaders/probe.h"
#include <gtest/gtest.h>

namespace afterglow
{
// Coefficients that a half holds exactly.
static ProbeVolume volume()
{
    ProbeVolume made;
    made.name = "hall";
    made.count = ivec3(3, 2, 4);
    made.toWorld = mat4(2.0f);
    made.toWorld[3] = vec4(0.1f, 0.2f, 0.3f, 1.0f);
    for (int p = 0; p < 24; ++p) {
        Sh9 sh;
        for (int i = 0; i < 9; ++i) sh.c[i] = vec3(float(p), float(i), -0.125f * float(p * i));
        made.irradiance.push_back(sh);
        made.validity.push_back(p % 4 == 0 ? 0.0f : 1.0f);
    }
    return made;
}

static void expectEqual(const ProbeVolume& a, const ProbeVolume& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.toWorld, b.toWorld);
    EXPECT_EQ(a.validity, b.validity);
    ASSERT_EQ(a.irradiance.size(), b.irradiance.size());
    for (std::size_t p = 0; p < a.irradiance.size(); ++p)
        for (int i = 0; i < 9; ++i) EXPECT_EQ(a.irradiance[p].c[i], b.irradiance[p].c[i]);
}

TEST(Probes, come_back_as_they_were)
{
    EXPECT_EQ(probeTexture(volume()).format, Ktx2Format::rgba16f);
    expectEqual(readProbes(probeTexture(volume()), "test"), volume());

    ProbeVolume bright = volume();
    bright.irradiance[5].c[0] = vec3(1e5f, 0.1f, 3e-9f);
    EXPECT_EQ(probeTexture(bright).format, Ktx2Format::rgba32f);
    expectEqual(readProbes(probeTexture(bright), "test"), bright);
}

// Far out, the file speaks the level's own coordinates.
TEST(Probes, of_a_level_far_out_stand_where_it_stands)
{
    const dvec3 origin(1e6, -2e6, 3e6);
    const Ktx2 texture = probeTexture(volume(), origin);
    const std::vector<double> placed = readNumbersText(texture, "ag_to_world", 16, "test");
    EXPECT_NEAR(placed[12], 1000000.1, 1e-8);
    EXPECT_NEAR(placed[13], -1999999.8, 1e-8);
    const mat4 back = readProbes(texture, "test", origin).toWorld;
    for (int row = 0; row < 3; ++row) EXPECT_NEAR(back[3][row], volume().toWorld[3][row], 1e-8f);
}

// A runtime that uploads the texture as it is finds number n of probe (i, j, k) in channel n % 4 of texel (i, j, n / 4 * nz + k).
TEST(Probes, lie_in_slabs_along_z)
{
    const ProbeVolume in = volume();
    const Ktx2 texture = probeTexture(in);
    EXPECT_EQ(texture.depth, 4 * kProbeSlabs);
    const std::vector<vec4> texels = unpackTexels(texture.levels[0], texture.format);
    const ivec3 at(2, 1, 3), n = in.count;
    const Sh9& sh = in.irradiance[std::size_t(probeIndex(at, n))];
    const auto texel = [&](int slab) { return texels[std::size_t(at.x + n.x * (at.y + n.y * (slab * n.z + at.z)))]; };
    EXPECT_EQ(texel(0), vec4(sh.c[0], sh.c[1].r));
    EXPECT_EQ(texel(6), vec4(sh.c[8], in.validity[std::size_t(probeIndex(at, n))]));
}

TEST(Probes, of_another_shape_are_refused)
{
    Ktx2 flat = probeTexture(volume());
    flat.keys.erase("ag_to_world");
    EXPECT_THROW(readProbes(flat, "test"), Error);
    flat.keys["ag_to_world"] = "1 2 3";
    EXPECT_THROW(readProbes(flat, "test"), Error);
    flat.keys["ag_to_world"] = "nan 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
    EXPECT_THROW(readProbes(flat, "test"), Error);
    flat = probeTexture(volume());
    flat.depth = 27;
    EXPECT_THROW(readProbes(flat, "test"), Error);
}
}
