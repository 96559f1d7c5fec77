// Where reflection probes stand, and the boxes that stand for what they see.
#include "baker/reflection_box.hpp"
#include "baker/reflection_places.hpp"
#include "rooms.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static Material glossy(float roughness, float metallic)
{
    Material material = shining(0.0f, 0.8f);
    material.flags = 0u;
    material.ior = 1.5f;
    material.specular = 1.0f;
    material.specularColor = vec3(1.0f);
    material.roughness = roughness;
    material.metallic = metallic;
    return material;
}

// The upper face alone of a plate that lies on a floor at y = -1.5.
static Shape panelAt(float x, vec2 size)
{
    return part(moved(box(vec3(size.x, 0.02f, size.y)), vec3(x, -1.49f, 0)), [](vec3 p) { return p.y > -1.481f; });
}

// Two rooms of 6 x 3 x 4 m side by side, with a wall of a metre between them; a panel of that material lies on the floor of the first.
static Scene twoRooms(const Material& panel)
{
    Scene scene;
    addSurface(scene, moved(flipped(box(vec3(6, 3, 4))), vec3(-3.5f, 0, 0)), shining(1.0f));
    addSurface(scene, moved(flipped(box(vec3(6, 3, 4))), vec3(3.5f, 0, 0)), shining(9.0f));
    addSurface(scene, panelAt(-3.5f, vec2(3, 2)), panel);
    scene.lower = vec3(-6.5f, -1.5f, -2), scene.upper = vec3(6.5f, 1.5f, 2);
    return scene;
}

TEST(ReflectionPlaces, areNotThereWhereNothingIsGlossy)
{
    for (const Material& panel : {shining(0.0f, 0.5f), glossy(0.6f, 0.0f)}) {
        Bakery bakery(twoRooms(panel));
        const PlacedReflections placed = placeReflections(bakery.context, 8);
        EXPECT_TRUE(placed.probes.empty());
        EXPECT_FALSE(placed.error.has_value()); // nothing tells it
    }
}

// One probe is all that a panel in one of two rooms calls for, in its room; its box is the room.
TEST(ReflectionPlaces, lieWhereGlossySurfacesLook)
{
    for (const Material& panel : {glossy(0.9f, 1.0f), glossy(0.1f, 0.0f), glossy(0.0f, 1.0f)}) {
        Bakery bakery(twoRooms(panel));
        const PlacedReflections placed = placeReflections(bakery.context, 8);
        ASSERT_EQ(placed.probes.size(), 1u);
        const ReflectionProbe& probe = placed.probes[0];
        const vec3 lower(-6.5f, -1.5f, -2), upper(-0.5f, 1.5f, 2);
        for (int axis = 0; axis < 3; axis++) {
            EXPECT_GT(probe.position[axis], lower[axis]);
            EXPECT_LT(probe.position[axis], upper[axis]);
            if (axis == 1) continue; // no ray goes down to the floor
            EXPECT_NEAR(probe.boxLower[axis], lower[axis], 0.05f);
            EXPECT_NEAR(probe.boxUpper[axis], upper[axis], 0.05f);
        }
        EXPECT_NEAR(probe.boxUpper.y, upper.y, 0.05f);
        EXPECT_LT(placed.boxErrors[0].value(), 0.02f); // radians
        EXPECT_LT(placed.error.value(), 0.05f);
        const PlacedReflections none = placeReflections(bakery.context, 0);
        EXPECT_TRUE(none.probes.empty());
        EXPECT_EQ(none.error.value(), kUncovered);
    }
}

TEST(ReflectionPlaces, areWhereTheLevelSays)
{
    Scene scene = furnace(0.5f);
    scene.reflectionProbes = {{"by hand", vec3(0.1f, 0.2f, 0.3f), vec3(1.0f, 2.0f, 3.0f)}};
    Bakery bakery(scene);
    const PlacedReflections placed = placeReflections(bakery.context, 8);
    ASSERT_EQ(placed.probes.size(), 1u);
    EXPECT_EQ(placed.probes[0].name, "by hand");
    EXPECT_EQ(placed.probes[0].boxLower, vec3(-0.9f, -1.8f, -2.7f));
    EXPECT_EQ(placed.probes[0].boxUpper, vec3(1.1f, 2.2f, 3.3f));
    EXPECT_FALSE(placed.error.has_value()); // a furnace mirrors nothing, which is not to say that the probe is right
    EXPECT_FALSE(placed.boxErrors[0].has_value());
}

// A hall that is half full of solids, all of them glossy.
TEST(ReflectionPlaces, areInTheOpen)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(8, 4, 8))), shining(1.0f));
    Shape blocks;
    for (int x = -3; x <= 3; x += 2)
        for (int z = -3; z <= 3; z += 2) append(blocks, moved(box(vec3(1.4f, 3.0f, 1.4f)), vec3(x, -0.5f, z)));
    addSurface(scene, blocks, glossy(0.1f, 1.0f));
    scene.lower = vec3(-4, -2, -4), scene.upper = vec3(4, 2, 4);
    Bakery bakery(scene);
    const PlacedReflections placed = placeReflections(bakery.context, 8);
    EXPECT_GT(placed.probes.size(), 0u);
    for (const ReflectionProbe& probe : placed.probes) {
        EXPECT_EQ(bakery.context.solids.shareInside(probe.position), 0.0);
        for (int axis = 0; axis < 3; axis++) EXPECT_LT(std::abs(probe.position[axis]), scene.upper[axis]);
    }
}

// What moves may come everywhere.
TEST(ReflectionPlaces, serveWhatMoves)
{
    Scene scene = twoRooms(glossy(0.1f, 1.0f));
    scene.objects.back().isStatic = false;
    Bakery bakery(scene);
    const PlacedReflections placed = placeReflections(bakery.context, 8);
    bool left = false, right = false;
    for (const ReflectionProbe& probe : placed.probes) (probe.position.x < 0.0f ? left : right) = true;
    EXPECT_TRUE(left && right);
}

// A cabinet along a wall, a beam under the ceiling: the box is moved to where it errs least, below the room's own.
TEST(ReflectionBox, errsLessThanTheRoom)
{
    Scene scene;
    addSurface(scene, flipped(box(vec3(6, 3, 4))), shining(1.0f));
    addSurface(scene, moved(box(vec3(1.2f, 2.6f, 3.9f)), vec3(-2.3f, -0.15f, 0)), shining(0.0f));
    addSurface(scene, panelAt(1.5f, vec2(2, 3)), glossy(0.1f, 1.0f));
    scene.lower = vec3(-3, -1.5f, -2), scene.upper = vec3(3, 1.5f, 2);
    Bakery bakery(scene);
    const std::vector<MirrorRay> rays = mirrorRays(bakery.world, bakery.context.solids, 1024, 1u);
    ASSERT_GT(rays.size(), 500u);
    const vec3 place(1.0f, 0.2f, 0.3f);
    const std::vector<bool> seen = seenFrom(bakery.world, place, rays);
    const auto errorOf = [&](const ReflectionBox& box) {
        double sum = 0.0, weights = 0.0;
        for (std::size_t i = 0; i < rays.size(); i++)
            if (seen[i]) sum += double(rays[i].weight * lookupError(box, rays[i], true)), weights += double(rays[i].weight);
        return sum / weights;
    };
    const ReflectionBox fitted = fitBox(bakery.world, place, rays, seen);
    EXPECT_LT(errorOf(fitted), 0.5 * errorOf({place, 1.0f, scene.lower, scene.upper}));
    EXPECT_NEAR(fitted.lower.x, -1.7f, 0.2f); // the cabinet's front
}

// A metal so dark that its clear parts mirror more: a texture says, texel by texel, which is which. None mirrors more than the material is
// taken to at most.
TEST(MirrorRays, knowWhatTexturesCallMetal)
{
    for (const float metal : {0.0f, 0.01f, 0.9f}) {
        Scene scene = twoRooms(glossy(0.1f, 1.0f));
        Material& panel = scene.materials.back();
        panel.baseColor = vec4(vec3(metal), 1.0f);
        panel.metallicRoughnessTexture = {0, 0u, vec4(1, 0, 0, 1), vec2(0.0f)};
        scene.textures.resize(1);
        scene.textures[0].image = {.width = 2, .height = 1, .pixels = {0, 255, 0, 255, 0, 255, 255, 255}};
        for (uint i = scene.meshes.back().primitives[0].firstVertex; i < scene.vertices.size(); i++)
            scene.vertices[i].uv0 = vec2(scene.vertices[i].position.z > 0.0f ? 0.75f : 0.25f, 0.5f);
        Bakery bakery(scene);
        const std::vector<MirrorRay> rays = mirrorRays(bakery.world, bakery.context.solids, 512, 1u);
        double clear = 0.0, metallic = 0.0;
        for (const MirrorRay& ray : rays) {
            EXPECT_LE(ray.weight, 1.0f);
            (ray.from.z > 0.0f ? metallic : clear) += double(ray.weight);
        }
        EXPECT_GT(clear, 0.0);
        EXPECT_EQ(metallic > clear, metal > 0.04f) << metal; // F0 of glass, 0.04
    }
}

// The sky is as far as one likes; the box that stands for it is not.
TEST(ReflectionBox, endsWhereOnlySkyIsMirrored)
{
    Scene scene;
    addSurface(scene, panelAt(0.0f, vec2(2, 2)), glossy(0.1f, 1.0f));
    scene.lower = vec3(-1, -1.5f, -1), scene.upper = vec3(1, -1.4f, 1);
    Bakery bakery(scene);
    const std::vector<MirrorRay> rays = mirrorRays(bakery.world, bakery.context.solids, 256, 1u);
    ASSERT_GT(rays.size(), 50u);
    const vec3 place(0.0f, -1.0f, 0.0f);
    const std::vector<bool> seen = seenFrom(bakery.world, place, rays);
    const ReflectionBox box = fitBox(bakery.world, place, rays, seen);
    const float farthest = 100.0f * distance(scene.lower, scene.upper);
    for (int axis = 0; axis < 3; axis++) {
        EXPECT_GE(box.lower[axis], place[axis] - 1.001f * farthest);
        EXPECT_LE(box.upper[axis], place[axis] + 1.001f * farthest);
    }
    for (std::size_t i = 0; i < rays.size(); i++) EXPECT_LT(lookupError(box, rays[i], seen[i]), 0.01f); // radians
}
}
