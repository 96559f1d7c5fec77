// What `afterglow probe` reads from a bake, on a floor whose lightmap holds one value and on which a block stands.
#include "baker/baker.hpp"
#include "engine/core/error.hpp"
#include "shapes.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static constexpr float kTexel = 0.25f; // m
static constexpr float kStored = 0.5f; // irradiance / pi
static const Shape kFloor{{{-2, 0, -2}, {-2, 0, 2}, {2, 0, 2}, {2, 0, -2}}, {0, 1, 2, 0, 2, 3}};

// A floor of 4 x 4 m in texels of a quarter metre, and a block that covers x < 0.1 m of it and has no lightmap.
static Baked floorWithBlock()
{
    Baked baked;
    baked.scene = levelOf(kFloor);
    baked.scene.materials.push_back(matte(0.5f));
    for (Vertex& v : baked.scene.vertices) v.uv1 = vec2(v.position.x, v.position.z) / 4.0f + 0.5f;
    addObject(baked.scene, addMesh(baked.scene, moved(box(vec3(1.5f, 1.0f, 3.0f)), vec3(-0.65f, 0.4f, 0.0f))));
    baked.scene.lower = vec3(-2.0f), baked.scene.upper = vec3(2.0f);
    baked.places = {LightmapPlace{0, vec2(1.0f), vec2(0.0f)}, LightmapPlace{}};
    Lightmap page;
    page.width = page.height = 16;
    page.texels.assign(256, vec3(kStored));
    page.valid.assign(256, 1);
    baked.lightmaps = {page};
    return baked;
}

static float irradianceAt(const Baked& baked, float x, vec3 normal = vec3(0, 1, 0))
{
    ProbePoint point;
    point.position = vec3(x, 0.0f, 0.3f);
    point.normal = normal;
    return probeBaked(baked, {point})[0].value[0].x;
}

TEST(Lookup, readsTheLightmapInTheOpen) { EXPECT_FLOAT_EQ(irradianceAt(floorWithBlock(), 1.0f), kPi * kStored); }

TEST(Lookup, isDarkInsideASolid) { EXPECT_EQ(irradianceAt(floorWithBlock(), -0.65f), 0.0f); }

// About the block's foot the answer falls with the open share of one texel's area: 1/2 on the edge itself. It counts eight columns of
// positions, hence the sixteenth.
TEST(Lookup, averagesOverATexelsArea)
{
    for (float share : {0.25f, 0.5f, 0.75f})
        EXPECT_NEAR(irradianceAt(floorWithBlock(), 0.1f + (share - 0.5f) * kTexel), share * kPi * kStored, kPi * kStored / 16.0f) << share;
}

// No lightmapped surface faces down here, and there are no probes.
TEST(Lookup, knowsNothingOfSurfacesThatFaceAway) { EXPECT_THROW(irradianceAt(floorWithBlock(), 1.0f, vec3(0, -1, 0)), Error); }

// Under water (a one-sided sheet of something clear) a floor is as lit as ever: the sheet's back is no solid's inside.
TEST(Lookup, isNotDarkUnderWater)
{
    Baked baked = floorWithBlock();
    Material water = matte(1.0f);
    water.flags = 0;
    water.transmission = 1.0f;
    water.ior = 1.33f;
    water.thickness = 0.5f;
    baked.scene.materials.push_back(water);
    uint sheet = addMesh(baked.scene, moved(kFloor, vec3(0.0f, 0.3f, 0.0f)));
    baked.scene.meshes[sheet].primitives[0].material = 1;
    addObject(baked.scene, sheet);
    baked.places.push_back(LightmapPlace{});
    EXPECT_FLOAT_EQ(irradianceAt(baked, 1.0f), kPi * kStored);
}

// Nor under a sheet whose back looks down, as long as light reaches that back.
TEST(Lookup, isNotDarkUnderASheet)
{
    Baked baked = floorWithBlock();
    baked.scene.sky.radiance = vec3(1.0f);
    addObject(baked.scene, addMesh(baked.scene, moved(kFloor, vec3(0.0f, 1.5f, 0.0f))));
    baked.places.push_back(LightmapPlace{});
    EXPECT_FLOAT_EQ(irradianceAt(baked, 1.0f), kPi * kStored);
    EXPECT_EQ(irradianceAt(baked, -0.65f), 0.0f); // the block is a solid all the same
}

// Two cells of probes, side by side along x: 1 in the left, 3 in the right, 1 m apart.
static Baked twoCells()
{
    Baked baked = floorWithBlock();
    ProbeTree& tree = baked.probes;
    for (float side : {-1.0f, 1.0f}) {
        ProbeCell cell{vec3(side * 1.5f - 1.0f, 4, -1), vec3(0.5f), {}};
        for (uint& probe : cell.probe) {
            probe = uint(tree.probes.size());
            tree.probes.push_back({shZero(), vec3(0.0f), vec3(0.0f)});
            tree.probes.back().irradiance.c[0] = vec3(2.0f + side) / shBasis(0, vec3(0.0f));
            tree.positions.push_back(vec3(0.0f));
        }
        tree.cells.push_back(cell);
    }
    tree.nodes = {{vec3(1, 0, 0), 0.0f, ~0, ~1}};
    return baked;
}

static float airAt(const Baked& baked, vec3 position)
{
    ProbePoint point;
    point.position = position;
    return probeBaked(baked, {point})[0].value[3].x / kPi;
}

// Each side of the plane has its own; outside of a cell's box its border holds.
TEST(Lookup, asksTheCellThatHoldsAPoint)
{
    const Baked baked = twoCells();
    for (auto [x, value] : {std::pair(-1.0f, 1.0f), {1.0f, 3.0f}, {-1e-4f, 1.0f}, {1e-4f, 3.0f}, {-40.0f, 1.0f}, {40.0f, 3.0f}})
        EXPECT_NEAR(airAt(baked, vec3(x, 5, 0)), value, 1e-5f) << x;
}
}
