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

// Two boxes of probes of 2 m, side by side along x: 1 in the left, 3 in the right, and a gap of 1 m between them.
static Baked twoVolumes()
{
    Baked baked = floorWithBlock();
    for (float side : {-1.0f, 1.0f}) {
        ProbeVolume volume;
        volume.toWorld = mat4(vec4(2, 0, 0, 0), vec4(0, 2, 0, 0), vec4(0, 0, 2, 0), vec4(side * 1.5f, 5, 0, 1));
        volume.count = ivec3(3);
        Sh9 sh = shZero();
        sh.c[0] = vec3(2.0f + side) / shBasis(0, vec3(0.0f));
        volume.irradiance.assign(27, sh);
        volume.validity.assign(27, 1.0f);
        baked.probes.push_back(volume);
    }
    return baked;
}

static float airAt(const Baked& baked, vec3 position)
{
    ProbePoint point;
    point.position = position;
    return probeBaked(baked, {point})[0].value[3].x / kPi;
}

// A box fades over half a cell beyond its walls, here half a metre: just outside of the left one only it has a share. Outside of all the
// nearest's border holds.
TEST(Lookup, asksTheBoxesThatReachAPoint)
{
    Baked baked = twoVolumes();
    for (auto [x, value] : {std::pair(-1.0f, 1.0f), {1.0f, 3.0f}, {-0.2f, 1.0f}, {0.2f, 3.0f}, {-40.0f, 1.0f}, {40.0f, 3.0f}})
        EXPECT_NEAR(airAt(baked, vec3(x, 5, 0)), value, 1e-5f) << x;
}

TEST(Lookup, isDarkWhereNoProbeKnowsAnything)
{
    Baked baked = twoVolumes();
    baked.probes[0].validity.assign(27, 0.0f);
    EXPECT_EQ(airAt(baked, vec3(-1.5f, 5, 0)), 0.0f);
    EXPECT_NEAR(airAt(baked, vec3(1.5f, 5, 0)), 3.0f, 1e-5f);
}
}
