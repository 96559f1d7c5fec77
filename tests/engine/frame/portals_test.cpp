// Portals in whole frames: the room beyond is held against a picture from its own side.
#include "tests/engine/frame/windows.hpp"
#include <set>

namespace afterglow
{
class Portals : public WindowsTest
{
protected:
    // Room A before a wall with a portal, room B 100 m away, whose portal is turned by a right angle; nothing in B is alike.
    Portals()
    {
        door = addMaterial(scene, matte(vec3(0.5f)));
        const auto twin = [&](const char* name, const char* other, const dmat4& toWorld) {
            Object& object = addQuad(scene, vec3(-1, -1.2f, 0), vec3(2, 0, 0), vec3(0, 2.4f, 0), door);
            object.name = name, object.portal = other, object.toWorld = toWorld;
        };
        a[3] = dvec4(0, 0, -3, 1);                                                                  // faces +z
        b = dmat4(dvec4(0, 0, 1, 0), dvec4(0, 1, 0, 0), dvec4(-1, 0, 0, 0), dvec4(100, 0.2, 0, 1)); // faces -x
        twin("A", "B", a);
        twin("B", "A", b);
        addQuad(scene, vec3(95, -3, -4), vec3(0, 0, 3.3f), vec3(0, 4, 0), lampOf(vec3(1, 0, 0)));
        addQuad(scene, vec3(96, -3, 0.4f), vec3(0, 0, 3.3f), vec3(0, 4, 0), lampOf(vec3(0, 1, 0)));
        addQuad(scene, vec3(96.5f, 0.4f, -1), vec3(0, 0, 1), vec3(0, 0.4f, 0), lampOf(vec3(0, 0, 1)));
        scene.sky.radiance = vec3(0.2f, 0.3f, 0.4f);
    }
    // Half a turn about y, from A's place to B's.
    mat4 there() const
    {
        dmat4 half(1.0);
        half[0][0] = half[2][2] = -1.0;
        return mat4(b * half * inverse(a));
    }
    uint door;
    dmat4 a{1.0}, b{1.0};
};

TEST_F(Portals, ShowWhatTheEyeWouldSeeOnTheOtherSide)
{
    const Camera camera = lookAt(vec3(0.3f, 0.1f, 1), vec3(0, 0, -3), 0.9f);
    const std::vector<bool> mask = seen(door, camera);
    const Image picture = draw(scene, camera);
    EXPECT_EQ(ran("portal.0.geometry"), 1u);
    EXPECT_EQ(ran("portal.1.geometry"), 0u); // out of sight

    Camera moved = camera;
    moved.toWorld = there() * camera.toWorld;
    Scene open = scene;
    open.objects.erase(open.objects.begin(), open.objects.begin() + 2);
    const Image beyond = draw(open, moved);
    EXPECT_EQ(differing(picture, beyond, mask), 0);
    std::set<std::pair<float, float>> colors;
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (mask[i]) colors.insert({picture.pixels[i * 4], picture.pixels[i * 4 + 1]});
    EXPECT_GE(colors.size(), 4u) << "three lamps and the sky";
}

// What a mirror and a portal put into the picture is in its layers, too.
TEST_F(Portals, AndMirrorsKeepTheLayersInStep)
{
    addQuad(scene, vec3(-2, -1.2f, 3), vec3(4, 0, 0), vec3(0, 0, -6), addMaterial(scene, mirror()));
    addLight(scene, pointLight(vec3(0, 2, 0), vec3(9.0f)));
    Material pane = matte(vec3(0.5f));
    pane.baseColor.w = 0.25f;
    pane.flags |= kMaterialAlphaBlend;
    addQuad(scene, vec3(0, -1.2f, -1), vec3(2, 0, 0), vec3(0, 2.4f, 0), addMaterial(scene, pane)); // before one half of both
    settings.layers = true;
    const Image picture = draw(scene, lookAt(vec3(0.3f, 0.1f, 1), vec3(0, -0.3f, -3), 0.9f));
    EXPECT_EQ(ran("portal.0"), 1u);
    EXPECT_EQ(ran("planar.0"), 1u);
    EXPECT_EQ(differing(sum, picture, std::vector<bool>(64 * 48, true)), 0);
}

TEST_F(Portals, AreDimmedByAClearSurfaceBeforeThem)
{
    const Camera camera = lookAt(vec3(0.3f, 0.1f, 1), vec3(0, 0, -3), 0.9f);
    const std::vector<bool> mask = seen(door, camera);
    Image without = draw(scene, camera);
    for (float& value : without.pixels) value *= 0.75f;
    Material pane = matte(vec3(0.0f));
    pane.baseColor.w = 0.25f;
    pane.flags |= kMaterialAlphaBlend;
    addQuad(scene, vec3(-9, -9, -1), vec3(18, 0, 0), vec3(0, 18, 0), addMaterial(scene, pane));
    EXPECT_EQ(differing(draw(scene, camera), without, mask), 0);
}

// Mirrors and portals share what a frame may draw.
TEST_F(Portals, AndMirrorsHaveOneBound)
{
    addQuad(scene, vec3(-2, -1.2f, 3), vec3(4, 0, 0), vec3(0, 0, -6), addMaterial(scene, mirror()));
    Stage stage = makeStage(gpu, scene, nullptr, settings);
    Windows windows = windowsOf(stage, makeView(lookAt(vec3(0.3f, 0.1f, 1), vec3(0, -0.3f, -3), 0.9f), settings.size), settings);
    EXPECT_EQ(windows.left, 64u);
    windows.left = 1;
    Graph graph;
    EXPECT_EQ(lookThrough(graph, stage, windows.mirrors, {}, settings, windows.left).size(), 1u);
    EXPECT_EQ(lookThrough(graph, stage, windows.portals, {}, settings, windows.left).size(), 0u);
}

TEST_F(Portals, AreTheirOwnSurfaceFromBehindAndWhenTurnedOff)
{
    const Camera behind = lookAt(vec3(0, 0, -5), vec3(0, 0, -3));
    draw(scene, behind);
    EXPECT_EQ(ran("portal.0.geometry"), 0u);
    settings.portal.depth = 0;
    draw(scene, lookAt(vec3(0), vec3(0, 0, -3)));
    EXPECT_EQ(ran("portal.0.geometry"), 0u);
}

// Two portals that face each other, as deep as one asks: each look ends.
TEST_F(Portals, ThatFaceEachOtherEndAtTheirDepth)
{
    scene.objects[1].toWorld = dmat4(dvec4(-1, 0, 0, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, -1, 0), dvec4(0, 0, 3, 1)); // faces -z, at z = 3
    const Camera camera = lookAt(vec3(0.1f, 0.2f, 2), vec3(0, 0, -3), 0.9f);
    for (const uint depth : {1u, 3u, kDeepestPortal}) {
        settings.portal.depth = depth;
        const Image picture = draw(scene, camera);
        std::size_t frames = 0;
        for (const PassStats& p : stats.passes) frames += p.name.ends_with("geometry") ? 1 : 0;
        EXPECT_EQ(frames, 1u + depth);
        for (const float value : picture.pixels) ASSERT_TRUE(std::isfinite(value));
    }
}

TEST_F(Portals, WithoutATwinAreCalledByName)
{
    scene.objects[0].portal = "C";
    scene.objects[1].portal.clear();
    EXPECT_FALSE(need(needs(scene), "portal").on);
    EXPECT_EQ(need(needs(scene), "portal").reason, "node \"A\": no mesh node is called \"C\"");
}
}
