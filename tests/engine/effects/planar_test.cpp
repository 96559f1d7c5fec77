// The eye behind a mirror, and what it cannot see; whole pictures are held in tests/engine/frame/mirrors_test.cpp.
#include "engine/effects/planar/planar.h"
#include "engine/effects/planar/planar.hpp"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class Planar : public Drawn
{
protected:
    // A mirror as wide as `half` at z = -3, facing +z, in a level 20 m across.
    void glass(float half)
    {
        Material m = matte(vec3(1.0f));
        m.flags = kMaterialMirror;
        m.metallic = 1.0f;
        m.roughness = 0.0f;
        addQuad(scene, vec3(-half, -half, -3), vec3(2 * half, 0, 0), vec3(0, 2 * half, 0), addMaterial(scene, m));
        flats = findFlats(scene);
        gpuScene.lower = vec3(-10), gpuScene.upper = vec3(10);
    }
    std::vector<VirtualView> views(const Camera& camera) { return virtualViews(makeView(camera, size), gpuScene, flats.mirrors, 16); }

    // Where the mirror's picture puts a point, in pixels of the picture.
    vec3 seenAt(const VirtualView& v, vec3 world) const
    {
        const vec4 clip = v.view.worldToClip * vec4(world, 1.0f);
        const vec2 uv = vec2(clip) / clip.w * 0.5f + 0.5f;
        const vec2 own = vec2(v.flipped ? 1.0f - uv.x : uv.x, uv.y) * vec2(v.view.size);
        return vec3(own + vec2(v.corner), clip.z / clip.w);
    }
    Flats flats;
    GpuScene gpuScene;
};

// A point before the mirror is seen where its mirror image would be, in the very pixel.
TEST_F(Planar, PutsAPointWhereItsMirrorImageIs)
{
    glass(2.0f);
    size = {200, 150};
    Camera slanted = lookAt(vec3(0.5f, 0.2f, 1), vec3(0, 0, -3), 0.9f), parallel = slanted;
    parallel.fovY = 0.0f, parallel.orthoHeight = 4.0f;
    for (const Camera& camera : {slanted, parallel}) {
        ASSERT_EQ(views(camera).size(), 1u);
        const VirtualView v = views(camera)[0];
        for (const vec3 point : {vec3(0.3f, -0.4f, -2.5f), vec3(-1, 0.7f, 0), vec3(1, 1, 6)}) {
            const vec4 clip = makeView(camera, size).worldToClip * vec4(point.x, point.y, -6 - point.z, 1.0f);
            const vec2 wanted = (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(size);
            EXPECT_LT(distance(vec2(seenAt(v, point)), wanted), 0.01f);
        }
        EXPECT_EQ(v.view.eye.w, camera.fovY > 0.0f ? 1.0f : 0.0f);
        EXPECT_LT(distance(vec3(v.view.eye), camera.fovY > 0.0f ? vec3(0.5f, 0.2f, -7) : vec3(makeView(camera, size).eye) * vec3(1, 1, -1)),
                  1e-5f);
    }
}

// H71: the mirror is the near plane. Depth runs from 1 there to 0, and comes back as the place that it was.
TEST_F(Planar, SeesNothingOnOrBehindTheMirror)
{
    glass(2.0f);
    size = {200, 150};
    for (const float fovY : {0.9f, 0.0f}) {
        Camera camera = lookAt(vec3(0.5f, 0.2f, 1), vec3(0, 0, -3), fovY);
        camera.orthoHeight = 4.0f;
        const VirtualView v = views(camera)[0];
        for (const float x : {-1.5f, 0.0f, 1.0f}) {
            for (const float z : {-3.001f, -3.0f, -4.0f}) EXPECT_GT(seenAt(v, vec3(x, 0, z)).z, 1.0f);
            for (const float z : {-2.99f, 0.0f, 8.0f}) {
                const vec3 point(x, 0.1f, z);
                const vec4 clip = v.view.worldToClip * vec4(point, 1.0f);
                EXPECT_LT(clip.z, clip.w);
                EXPECT_GT(clip.z, 0.0f);
                const vec3 back = worldFromDepth(ndcToUv(vec2(clip) / clip.w), clip.z / clip.w, v.view.clipToWorld);
                EXPECT_LT(distance(back, point), 2e-4f);
            }
        }
        EXPECT_FALSE(mayBeSeen(v.view.worldToClip, vec3(-1, -1, -5), vec3(1, 1, -3)));
        EXPECT_TRUE(mayBeSeen(v.view.worldToClip, vec3(-1, -1, -5), vec3(1, 1, -1)));
    }
}

// A ray of the mirror's picture begins on the mirror, and the sky lies where the look is sent.
TEST_F(Planar, RaysBeginOnTheMirror)
{
    glass(2.0f);
    size = {200, 150};
    const VirtualView v = views(lookAt(vec3(0, 0, 1), vec3(0, 0, -3), 0.9f))[0];
    for (const float depth : {0.0f, 0.6f}) {
        const ViewRay ray = viewRay(vec2(0.25f, 0.5f), depth, v.view.clipToWorld, v.view.rayEye());
        EXPECT_NEAR(ray.origin.z, -3.0f, 1e-3f);
        EXPECT_LT(distance(ray.direction, normalize(ray.origin - vec3(0, 0, -7))), 1e-5f);
        EXPECT_GT(ray.direction.z, 0.0f);
    }
}

TEST_F(Planar, OfAnEyeOnThePlaneOrAtTheBackOfWaterDrawsNothing)
{
    glass(2.0f);
    const auto from = [&](float z, float target) { return views(lookAt(vec3(0, 0, z), vec3(0, 0.1f, target))).size(); };
    EXPECT_EQ(from(-2.9f, -3.0f), 1u);
    for (const float z : {-2.9999f, -3.0f, -3.0001f}) EXPECT_EQ(from(z, z - 2.0f) + from(z, z + 2.0f), 0u) << z;
    EXPECT_EQ(from(-5.0f, 0.0f), 1u) << "the back of a metal mirrors too";
    flats.mirrors[0].twoSided = false;
    EXPECT_EQ(from(-5.0f, 0.0f), 0u);
}

// From behind, what lies behind is mirrored, and what lies before is not there.
TEST_F(Planar, TheBackOfAMetalMirrorsItsOwnSide)
{
    glass(2.0f);
    size = {200, 150};
    const Camera camera = lookAt(vec3(0.5f, 0.2f, -7), vec3(0, 0, -3), 0.9f);
    ASSERT_EQ(views(camera).size(), 1u);
    const VirtualView v = views(camera)[0];
    const vec4 clip = makeView(camera, size).worldToClip * vec4(0.3f, -0.4f, -2, 1.0f);
    EXPECT_LT(distance(vec2(seenAt(v, vec3(0.3f, -0.4f, -4))), (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(size)), 0.01f);
    EXPECT_GT(seenAt(v, vec3(0, 0, -2.9f)).z, 1.0f);
    EXPECT_LT(seenAt(v, vec3(0, 0, -3.1f)).z, 1.0f);
}

// A flat normal looks up the mirror's own pixel; one that sends the look into the plane is bent along it.
TEST_F(Planar, RipplesOfNoTiltChangeNothing)
{
    glass(2.0f);
    size = {200, 150};
    const Camera camera = lookAt(vec3(0.5f, 0.2f, 1), vec3(0, 0, -3), 0.9f);
    const VirtualView v = views(camera)[0];
    const vec3 position(0.4f, -0.3f, -3), n(0, 0, 1), toEye = normalize(vec3(0.5f, 0.2f, 1) - position);
    const vec4 clip = makeView(camera, size).worldToClip * vec4(position, 1.0f);
    const vec2 pixel = (vec2(clip) / clip.w * 0.5f + 0.5f) * vec2(size);
    const vec2 own = mirroredUv(pixel, vec2(v.corner), vec2(v.view.size));
    for (const float away : {0.1f, 3.0f, 1e4f})
        EXPECT_LT(distance(rippledUv(position, rippledDirection(toEye, n, n), away, v.view.worldToClip, own), own), 1e-4f);
    const vec3 bent = rippledDirection(toEye, normalize(vec3(-3, 0, 0.5f)), n);
    EXPECT_GT(dot(bent, n), 0.9f * kLeastRise);
    EXPECT_NEAR(length(bent), 1.0f, 1e-5f);
}
}
