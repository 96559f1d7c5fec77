// Irradiance probes: the cell that holds a point, and what lies between its eight.
#include "engine/baked/probe_read.hpp"
#include "tests/shaders/statistics.hpp"

namespace afterglow::test
{
namespace
{
// A box of 2 x 3 x 4 m whose probes hold a linear function of their place.
ProbeTree linearTree()
{
    ProbeTree tree;
    ProbeCell cell{vec3(1, 2, 3), 1.0f / vec3(2, 3, 4), {}};
    for (uint corner = 0; corner < 8; corner++) {
        const vec3 p = cell.lower + vec3(corner & 1u, corner >> 1u & 1u, corner >> 2u) / cell.perExtent;
        cell.probe[corner] = corner;
        tree.probes.push_back({shZero(), vec3(0.0f), vec3(0.0f)});
        tree.probes.back().irradiance.c[0] = vec3(100.0f + 2.0f * p.x - 3.0f * p.y + 0.5f * p.z) / shBasis(0, vec3(0.0f));
    }
    tree.cells = {cell};
    tree.nodes = {{vec3(0.0f), 0.0f, ~0, ~0}};
    return tree;
}
float at(const ProbeTree& tree, vec3 position) { return probeLookup(ProbeSet{&tree}, position, vec3(0, 1, 0)).x; }

// Irradiance / pi about a normal of one light from +z that brings 1 about +z: three bands, with and without the lobe.
Probe oneLight(bool lobe)
{
    Probe probe{shZero(), vec3(lobe ? 1.0f : 0.0f), vec3(0, 0, 1)};
    shAdd(probe.irradiance, vec3(0, 0, 1), vec3(1.0f));
    probe.irradiance = shConvolveCosine(probe.irradiance);
    probe.irradiance = shScaleBands(probe.irradiance, kPi, kPi, kPi);
    return probe;
}
}

TEST(Probe, InterpolationIsExactForLinearFields)
{
    const ProbeTree tree = linearTree();
    Random random;
    for (int i = 0; i < 5000; ++i) {
        const vec3 p = vec3(1, 2, 3) + vec3(2, 3, 4) * vec3(random.next(), random.next(), random.next());
        EXPECT_NEAR(at(tree, p), 100.0f + 2.0f * p.x - 3.0f * p.y + 0.5f * p.z, 1e-4f);
        EXPECT_NEAR(probeMeanRadiance(ProbeSet{&tree}, p).x, at(tree, p), 1e-4f);
    }
}

// H83
TEST(Probe, OutsideIsTheBorder)
{
    const ProbeTree tree = linearTree();
    EXPECT_EQ(at(tree, vec3(99, 3, 4)), at(tree, vec3(3, 3, 4)));
    EXPECT_EQ(at(tree, vec3(-9)), at(tree, vec3(1, 2, 3)));
    EXPECT_TRUE(std::isfinite(at(tree, vec3(std::nanf("")))));
    EXPECT_TRUE(std::isfinite(at(tree, vec3(std::numeric_limits<float>::infinity()))));
}

// H86
TEST(Probe, AFlatCellIsConstantAcross)
{
    ProbeTree tree = linearTree();
    tree.cells[0].perExtent.y = 0.0f;
    for (float y : {-7.0f, 2.0f, 4.0f, 9.0f}) EXPECT_EQ(at(tree, vec3(2, y, 4)), at(tree, vec3(2, 2, 4)));
}

TEST(Probe, AWalkEndsInTheCellThatHoldsThePoint)
{
    ProbeTree tree = linearTree();
    for (int i = 1; i < 4; i++) tree.cells.push_back(tree.cells[0]), tree.cells.back().lower.x = float(i);
    tree.nodes = {{vec3(1, 0, 0), 0.0f, 1, 2}, {vec3(0, 1, 0), 0.0f, ~0, ~1}, {normalize(vec3(0, 1, 1)), 1.0f, ~2, ~3}};
    const auto cell = [&](vec3 p) { return probeCellOf(ProbeSet{&tree}, p).lower.x; };
    EXPECT_EQ(cell(vec3(-1, -1, 9)), 1.0f); // lower.x of the first is 1
    EXPECT_EQ(cell(vec3(-1, 1, 9)), 1.0f);
    EXPECT_EQ(cell(vec3(1, 0.7f, 0.7f)), 2.0f);
    EXPECT_EQ(cell(vec3(1, 0.8f, 0.8f)), 3.0f);
}

// Half-way between probes at 0 and s, of E(x) = (1 + x^2)^(-3/2): the error of linear interpolation falls with s^2.
TEST(Probe, TrilinearErrorIsQuadratic)
{
    struct Row {
        double s, error;
    };
    auto e = [](double x) { return std::pow(1.0 + x * x, -1.5); };
    for (const Row& r : {Row{0.5, 0.05530441785}, Row{0.25, 0.0204744161}, Row{0.125, 0.005663073802}}) {
        double value = 0.0;
        for (int c = 0; c < 8; ++c) value += double(probeTrilinear(vec3(0.5f, 0, 0), c)) * e((c & 1) ? r.s : 0.0);
        expectRelative(e(0.5 * r.s) - value, r.error, 1e-5);
    }
}

// The bands above the second of a clamped cosine: orthogonal to those below, and all of what they lack.
TEST(Probe, TheLobeIsWhatOrderTwoLacksOfOneLight)
{
    double bands[3] = {0, 0, 0};
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; i++) {
        const double c = -1.0 + (2.0 * i + 1.0) / kSteps, r = double(cosineRemainder(float(c)));
        bands[0] += r, bands[1] += r * c, bands[2] += r * (3.0 * c * c - 1.0);
    }
    for (double band : bands) EXPECT_NEAR(band / kSteps, 0.0, 1e-6);

    double lacked = 0.0;
    for (float angle = 0.0f; angle <= kPi; angle += 0.01f) {
        const vec3 n(std::sin(angle), 0.0f, std::cos(angle));
        EXPECT_NEAR(probeIrradiance(oneLight(true), n).x, std::max(n.z, 0.0f), 1e-5f) << angle;
        lacked = std::max(lacked, double(std::abs(probeIrradiance(oneLight(false), n).x - std::max(n.z, 0.0f))));
    }
    EXPECT_NEAR(lacked, 3.0 / 32.0, 1e-3); // at 90 degrees
}

// H84
TEST(Probe, WhatRingsIsNeverNegative)
{
    ProbeTree tree = linearTree();
    for (Probe& probe : tree.probes) probe = oneLight(false);
    float least = 0.0f;
    for (float angle = 0.0f; angle <= kPi; angle += 0.01f) {
        const vec3 n(std::sin(angle), 0.0f, std::cos(angle));
        least = std::min(least, probeIrradiance(tree.probes[0], n).x);
        EXPECT_GE(probeLookup(ProbeSet{&tree}, vec3(2, 3, 4), n).x, 0.0f);
    }
    EXPECT_LT(least, -0.03f);
}
}
