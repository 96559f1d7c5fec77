// What is shown of probes: spheres against where they must stand on the picture, surfaces against the law of the lookup.
#include "engine/baked/probe_read.hpp"
#include "engine/effects/probe_view/probe_view.hpp"
#include "engine/upload/storage.hpp"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class ProbeView : public Drawn
{
protected:
    ProbeView() { size = {96, 96}; }

    Image shown(const Camera& camera, uint what)
    {
        const GpuLevel level(gpu, uploadScene(gpu, scene, placed(), {}), uploadBaked(gpu, baked, {}));
        const GpuBuffer marks = storage(gpu, "probe marks", probeMarks(baked.probes));
        const View view = makeView(camera, size);
        Graph graph;
        const GBuffer surfaces = geometry(graph, view, level.scene, {});
        const LightingParts parts{.lightmaps = true, .probes = true};
        Texture image = lighting(graph, view, surfaces, {}, {}, level, {}, parts).radiance;
        image = probeView(graph, view, surfaces, level, marks, image, what);
        graph.output(image);
        stats = executor.run(graph, level.set);
        return executor.download(image);
    }

    // A dark wall 4 m before the eye, and a cell of 1.2 m before it, whose probes hold 2.
    void darkWall()
    {
        addQuad(scene, vec3(-9, -9, -4), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, matte(vec3(0.0f))));
        baked = bakedEvenly(scene, vec3(1.0f));
        baked.probes = evenProbes(vec3(-0.6f, -0.6f, -3.2f), vec3(0.6f, 0.6f, -2.0f), vec3(2.0f));
    }
    vec2 pixelOf(vec3 position) const
    {
        const vec4 clip = makeView(camera, size).worldToClip * vec4(position, 1.0f);
        return ndcToUv(vec2(clip) / clip.w) * vec2(size);
    }
    static vec3 at(const Image& image, vec2 pixel)
    {
        const float* p = image.at(int(pixel.x), int(pixel.y));
        return vec3(p[0], p[1], p[2]);
    }
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1));
};

TEST_F(ProbeView, SpheresStandWhereTheProbesDoAndAreAsLargeAsSaid)
{
    darkWall();
    const Image picture = shown(camera, kShowProbes);
    double expected = 0.0, lit = 0.0;
    for (const vec3& position : baked.probes.positions) {
        expectNear(at(picture, pixelOf(position)), vec3(2.0f), 1e-2f); // light from everywhere: every normal sees 2
        const float radius = 1.2f * kSphereOfCell / -position.z / std::tan(0.5f * camera.fovY) * 0.5f * float(size.y);
        expected += double(kPi * radius * radius);
    }
    for (int i = 0; i < picture.width * picture.height; i++) lit += picture.pixels[std::size_t(i * picture.channels)] > 0.0f;
    EXPECT_NEAR(lit, expected, 0.08 * expected); // off its axis an outline is longer by a few percent, and pixels are whole
}

TEST_F(ProbeView, SpheresHideAndAreHidden)
{
    darkWall();
    for (vec3& position : baked.probes.positions) position.x = position.y = 0.0f; // two places, one behind the other
    for (uint corner = 0; corner < 8; corner++)                                   // those in front are dim
        baked.probes.probes[corner].irradiance.c[0] = vec3(corner < 4 ? 2.0f : 0.5f) / shBasis(0, vec3(0.0f));
    size = {95, 95};
    expectNear(middle(shown(camera, kShowProbes)), vec3(0.5f), 1e-2f);
    for (vec3& position : baked.probes.positions) position.z = -4.5f; // behind the wall
    EXPECT_EQ(middle(shown(camera, kShowProbes)), vec3(0.0f));
}

TEST_F(ProbeView, AMovedProbeIsRedAndOneAtItsCornerGreen)
{
    darkWall();
    baked.probes.positions[0] += vec3(0.6f);
    EXPECT_EQ(probeMarks(baked.probes)[7].moved, 0.0f);
    EXPECT_NEAR(probeMarks(baked.probes)[0].moved, 0.5f, 1e-5f);
    const Image picture = shown(camera, kShowValidity);
    expectNear(at(picture, pixelOf(baked.probes.positions[0])), colorOfMove(0.5f), 2e-2f);
    expectNear(at(picture, pixelOf(baked.probes.positions[7])), colorOfMove(0.0f), 2e-2f);
}

TEST_F(ProbeView, CellsPartWhereTheirPlaneIs)
{
    darkWall();
    append(baked.probes, evenProbes(vec3(-0.6f), vec3(0.6f), vec3(1.0f)));
    baked.probes.nodes = {{vec3(1, 0, 0), 0.5f, ~0, ~1}};
    const Image picture = shown(camera, kShowCells);
    const float form = formOf(1.0f);
    expectNear(at(picture, pixelOf(vec3(0.4f, 0, -4))), colorOfNumber(0u) * form, 3e-2f);
    expectNear(at(picture, pixelOf(vec3(0.6f, 0, -4))), colorOfNumber(1u) * form, 3e-2f);
    EXPECT_GT(length(colorOfNumber(0u) - colorOfNumber(1u)), 0.3f);
}

// The weights of the law add up to 1, whichever is largest; of a wall behind the cell four count.
TEST_F(ProbeView, WeightsAreThoseOfTheLaw)
{
    darkWall();
    const ProbeCell& cell = baked.probes.cells[0];
    const Image picture = shown(camera, kShowWeights);
    for (const vec3 p : {vec3(0, 0, -4), vec3(0.3f, 0.1f, -4), vec3(-0.5f, 0.55f, -4), vec3(1.5f, 1.5f, -4)}) {
        const vec3 fraction = probeFraction(cell, p);
        float most = 0.0f, sum = 0.0f;
        for (int corner = 0; corner < 8; corner++) {
            const float weight = probeTrilinear(fraction, corner);
            most = max(most, weight), sum += weight;
        }
        EXPECT_NEAR(sum, 1.0f, 1e-6f);
        const vec3 got = at(picture, pixelOf(p)), toEye = normalize(-p);
        EXPECT_LT(length(got - heatColor((most - 0.125f) / 0.875f) * formOf(toEye.z)), 0.05f) << p.x << " " << p.y;
    }
}

// Two boxes side by side: each wall half mirrors its own; beyond both it is grey.
TEST_F(ProbeView, InfluenceIsThatOfTheBoxes)
{
    darkWall();
    baked.reflections = {evenReflection(vec3(-1.2f, -1, -5), vec3(-0.2f, 1, -3), vec3(1.0f)),
                         evenReflection(vec3(0.2f, -1, -5), vec3(1.2f, 1, -3), vec3(1.0f))};
    const Image picture = shown(camera, kShowInfluence);
    for (uint i : {0u, 1u}) expectNear(at(picture, pixelOf(vec3(i == 0 ? -0.7f : 0.7f, 0, -4))), colorOfNumber(i), 4e-2f);
    expectNear(at(picture, pixelOf(vec3(0, 1.6f, -4))), vec3(0.25f * formOf(4.0f / length(vec2(1.6f, 4.0f)))), 4e-2f);
}
}
