// The eye beyond a portal: where it stands and what is upright; whole pictures are held in tests/engine/frame/portals_test.cpp.
#include "engine/effects/portal/portal.hpp"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class Portal : public Drawn
{
protected:
    // Two portals, 2 x 2 m about their nodes' origins, facing the nodes' +z.
    void pair(const dmat4& here, const dmat4& there)
    {
        const uint door = addMaterial(scene, matte(vec3(0.5f)));
        for (const bool first : {true, false}) {
            Object& object = addQuad(scene, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), door);
            object.name = first ? "here" : "there", object.portal = first ? "there" : "here";
            object.toWorld = first ? here : there;
        }
        flats = findFlats(scene);
        gpuScene.lower = vec3(-10), gpuScene.upper = vec3(10);
    }
    Flats flats;
    GpuScene gpuScene;
};

TEST_F(Portal, LeadsOutOfTheFrontOfItsTwinUpright)
{
    dmat4 there(1.0);
    there[3] = dvec4(5, 1, 2, 1); // faces +z as well
    pair(dmat4(1.0), there);
    ASSERT_EQ(flats.portals.size(), 2u);
    const dmat4& way = flats.portals[0].through;
    // 1 m before it, 0.3 to the right, 0.2 up: 1 m behind the twin, as far to the right of who walks on, and as high
    const dvec3 out(way * dvec4(0.3, 0.2, 1, 1));
    EXPECT_LT(distance(out, dvec3(4.7, 1.2, 1)), 1e-9);
    EXPECT_LT(distance(dvec3(way * dvec4(0, 1, 0, 0)), dvec3(0, 1, 0)), 1e-9);
    EXPECT_LT(distance(dvec3(way * dvec4(0, 0, -1, 0)), dvec3(0, 0, 1)), 1e-9);
    EXPECT_LT(distance(flats.portals[0].beyond, dvec3(0, 0, 1)), 1e-9);
    EXPECT_NEAR(flats.portals[0].beyondOffset, 2.0, 1e-9);
    // There and back again
    EXPECT_LT(distance(dvec3(flats.portals[1].through * dvec4(out, 1)), dvec3(0.3, 0.2, 1)), 1e-9);
}

// A node's scale makes the portal larger, not the world beyond.
TEST_F(Portal, KeepsLengthsWhateverItsScale)
{
    dmat4 here(2.0), there(0.5);
    here[3] = dvec4(0, 0, -4, 1), there[3] = dvec4(3, 0, 0, 1);
    pair(here, there);
    const dmat3 way(flats.portals[0].through);
    EXPECT_NEAR(determinant(way), 1.0, 1e-9);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(length(way[axis]), 1.0, 1e-9);
}

// The picture beyond lies pixel on pixel, is not flipped, and begins at the twin.
TEST_F(Portal, ShowsAPointBeyondWhereTheEyeLooksForIt)
{
    dmat4 there(1.0);
    there[3] = dvec4(5, 1, 2, 1);
    pair(dmat4(1.0), there);
    size = {200, 150};
    const View eye = makeView(lookAt(vec3(0.3f, 0.2f, 2), vec3(0), 0.9f), size);
    const std::vector<VirtualView> views = virtualViews(eye, gpuScene, flats.portals, 16);
    ASSERT_EQ(views.size(), 1u) << "the twin is out of sight";
    const VirtualView& v = views[0];
    EXPECT_FALSE(v.flipped);
    const vec3 beyond(5.2f, 1.4f, 4); // as if at (-0.2, 0.4, -2)
    const vec4 wanted = eye.worldToClip * vec4(-0.2f, 0.4f, -2, 1), got = v.view.worldToClip * vec4(beyond, 1.0f);
    const vec2 pixel = (vec2(got) / got.w * 0.5f + 0.5f) * vec2(v.view.size) + vec2(v.corner);
    EXPECT_LT(distance(pixel, (vec2(wanted) / wanted.w * 0.5f + 0.5f) * vec2(size)), 0.01f);
    EXPECT_LT(got.z, got.w);
    const vec4 behind = v.view.worldToClip * vec4(5, 1, 1.9f, 1);
    EXPECT_GT(behind.z, behind.w);
}
}
