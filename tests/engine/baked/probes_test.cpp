#include "engine/baked/probes.hpp"
#include "engine/baked/texels.hpp"
#include "engine/core/error.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
// Two cells beside one another that share four of their probes; numbers that a half holds exactly.
static ProbeTree pair()
{
    ProbeTree tree;
    for (uint p = 0; p < 12; ++p) {
        Probe probe{shZero(), vec3(0.5f, float(p), 0.25f), vec3(0, 0, 1)};
        for (int i = 0; i < 9; ++i) probe.irradiance.c[i] = vec3(float(p), float(i), -0.125f * float(p) * float(i));
        tree.probes.push_back(probe);
        tree.positions.push_back(vec3(float(p % 3) - 1.0f, float(p / 3 % 2), float(p / 6)));
        tree.stands.push_back(p % 3 == 0 ? ProbeStand::buried : ProbeStand::corner);
    }
    for (uint side : {0u, 1u}) {
        ProbeCell cell{vec3(float(side) - 1.0f, 0, 0), vec3(1.0f), {}};
        for (uint corner = 0; corner < 8; corner++) cell.probe[corner] = side + (corner & 1u) + 3u * (corner >> 1u);
        tree.cells.push_back(cell);
    }
    tree.nodes = {{vec3(1, 0, 0), 0.125f, ~0, ~1}};
    return tree;
}

static ProbeTree again(const ProbeTree& tree, dvec3 origin = dvec3(0.0), dvec3 now = dvec3(0.0))
{
    return readProbes(probeTexture(tree), probeTreeTexture(tree, origin), "test", now);
}

static void expectEqual(const ProbeTree& a, const ProbeTree& b)
{
    EXPECT_EQ(a.stands, b.stands);
    ASSERT_EQ(a.probes.size(), b.probes.size());
    for (std::size_t p = 0; p < a.probes.size(); ++p) {
        for (int i = 0; i < 9; ++i) EXPECT_EQ(a.probes[p].irradiance.c[i], b.probes[p].irradiance.c[i]);
        EXPECT_EQ(a.probes[p].lobe, b.probes[p].lobe);
        EXPECT_EQ(a.probes[p].toward, b.probes[p].toward);
        EXPECT_EQ(a.positions[p], b.positions[p]);
    }
    ASSERT_EQ(a.cells.size(), b.cells.size());
    for (std::size_t c = 0; c < a.cells.size(); ++c) {
        EXPECT_EQ(a.cells[c].lower, b.cells[c].lower);
        EXPECT_EQ(a.cells[c].perExtent, b.cells[c].perExtent);
        for (int k = 0; k < 8; ++k) EXPECT_EQ(a.cells[c].probe[k], b.cells[c].probe[k]);
    }
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(a.nodes[0].normal, b.nodes[0].normal);
    EXPECT_EQ(a.nodes[0].offset, b.nodes[0].offset);
    EXPECT_EQ(a.nodes[0].below, b.nodes[0].below);
    EXPECT_EQ(a.nodes[0].above, b.nodes[0].above);
}

TEST(Probes, come_back_as_they_were)
{
    EXPECT_EQ(probeTexture(pair()).format, Ktx2Format::rgba16f);
    expectEqual(again(pair()), pair());

    ProbeTree bright = pair();
    bright.probes[5].irradiance.c[0] = vec3(1e5f, 0.1f, 3e-9f);
    EXPECT_EQ(probeTexture(bright).format, Ktx2Format::rgba32f);
    expectEqual(again(bright), bright);
}

// Order 1 is four coefficients and a place: less than half of the bytes.
TEST(Probes, of_order_1_come_back_without_the_rest)
{
    ProbeTree tree = pair();
    tree.order = 1;
    ProbeTree first = tree;
    for (Probe& probe : first.probes) {
        for (int i = 4; i < 9; ++i) probe.irradiance.c[i] = vec3(0.0f);
        probe.lobe = probe.toward = vec3(0.0f);
    }
    const ProbeTree back = again(tree);
    EXPECT_EQ(back.order, 1);
    expectEqual(back, first);
    EXPECT_EQ(9 * probeTexture(tree).width, 4 * probeTexture(pair()).width);
}

// A program that reads the level about another origin moves them with it.
TEST(Probes, of_a_level_far_out_stand_where_it_stands)
{
    const dvec3 origin(1e6, -2e6, 3e6);
    expectEqual(again(pair(), origin, origin), pair());
    const ProbeTree moved = again(pair(), origin, origin - dvec3(2, 3, 4));
    EXPECT_EQ(moved.cells[1].lower, pair().cells[1].lower + vec3(2, 3, 4));
    EXPECT_EQ(moved.nodes[0].offset, pair().nodes[0].offset + 2.0f);
    EXPECT_EQ(moved.positions[7], pair().positions[7] + vec3(2, 3, 4));
}

// Number n of a probe lies in channel n % 4 of its texel n / 4: nine texels a probe.
TEST(Probes, lie_nine_texels_each)
{
    const ProbeTree in = pair();
    const Ktx2 texture = probeTexture(in);
    const std::vector<vec4> texels = unpackTexels(texture.levels[0], texture.format);
    const Probe& probe = in.probes[5];
    EXPECT_EQ(texels[5 * 9], vec4(probe.irradiance.c[0], probe.irradiance.c[1].r));
    EXPECT_EQ(texels[5 * 9 + 6], vec4(probe.irradiance.c[8], probe.lobe.r));
}

// H: a walk down a tree from a file ends.
TEST(Probes, of_another_shape_are_refused)
{
    const auto refused = [](auto spoil) {
        Ktx2 probes = probeTexture(pair()), tree = probeTreeTexture(pair(), dvec3(0.0));
        std::vector<vec4> texels = unpackTexels(tree.levels[0], tree.format);
        spoil(probes, tree, texels);
        tree.levels[0] = packTexels(texels, Ktx2Format::rgba32f);
        EXPECT_THROW(readProbes(probes, tree, "test", dvec3(0.0)), Error);
    };
    using Texels = std::vector<vec4>;
    refused([](Ktx2& probes, Ktx2&, Texels&) { probes.keys.erase("ag_count"); });
    refused([](Ktx2& probes, Ktx2&, Texels&) { probes.keys["ag_count"] = "1000"; });
    refused([](Ktx2& probes, Ktx2&, Texels&) { probes.keys["ag_lower"] = "nan 0 0"; });
    refused([](Ktx2& probes, Ktx2&, Texels&) { probes.keys["ag_order"] = "3"; });
    refused([](Ktx2& probes, Ktx2&, Texels&) { probes.keys.erase("ag_order"); });
    refused([](Ktx2&, Ktx2& tree, Texels&) { tree.keys["ag_cells"] = "1e300"; });
    refused([](Ktx2&, Ktx2&, Texels& texels) { texels[1].x = 0.0f; });  // the root's child is the root
    refused([](Ktx2&, Ktx2&, Texels& texels) { texels[1].y = -4.0f; }); // a cell that is not there
    refused([](Ktx2&, Ktx2&, Texels& texels) { texels[1].y = std::nanf(""); });
    refused([](Ktx2&, Ktx2&, Texels& texels) { texels[4].x = 12.0f; }); // a probe that is not there
}
}
