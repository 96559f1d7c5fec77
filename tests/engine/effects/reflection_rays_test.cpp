// Reflection by ray query against mirrored rays worked out on paper, and against what an eye behind the mirror sees.
#include "shaders/random.h"
#include "tests/engine/effects/mirrors.hpp"
#include "tests/engine/upload/solids.hpp"

namespace afterglow
{
class RayReflection : public Mirrors
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }
    Image byRays(const Camera& eye, DrawnParts parts = {})
    {
        parts.reflectionMethod = ReflectionMethod::ray;
        return mirrored(eye, parts);
    }
};

// A box of lamps, each face of its own colour, hangs over the floor: from its place in the picture, what the floor shows of every face, its
// underside too, which no pixel sees, and of the sky.
TEST_F(RayReflection, AMirrorFloorShowsTheUndersideOfWhatHangsOverIt)
{
    const vec3 lower(-0.8f, -0.5f, -4.5f), upper(0.7f, 0.4f, -3.0f), sky(0.25f, 0.5f, 0.125f);
    scene.sky.radiance = sky;
    floorTo(-10, metal(0.0f));
    const auto faceColor = [](int axis, bool high) { return vec3(1.0f + float(axis), high ? 2.0f : 0.5f, 3.0f - float(axis)); };
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            vec3 corner = lower, u(0), v(0);
            u[(axis + 1) % 3] = upper[(axis + 1) % 3] - lower[(axis + 1) % 3];
            v[(axis + 2) % 3] = upper[(axis + 2) % 3] - lower[(axis + 2) % 3];
            if (high) corner[axis] = upper[axis];
            addQuad(scene, corner, high ? u : v, high ? v : u, lamp(faceColor(axis, high)));
        }
    // What a ray from outside of the box meets: slabs
    const auto met = [&](vec3 o, vec3 d, int& face) {
        float in = 0.0f, out = kFloatMax;
        for (int axis = 0; axis < 3; ++axis) {
            const float a = (lower[axis] - o[axis]) / d[axis], b = (upper[axis] - o[axis]) / d[axis];
            if (std::min(a, b) > in) {
                in = std::min(a, b);
                face = 2 * axis + (d[axis] < 0.0f ? 1 : 0);
            }
            out = std::min(out, std::max(a, b));
        }
        if (!(in < out && in > 0.0f)) face = 6;
        return face < 6 ? faceColor(face / 2, face % 2 == 1) : sky;
    };
    const Image picture = byRays(camera);
    const View view = makeView(camera, size);
    std::array<int, 7> judged{};
    for (int y = 0; y < int(size.y); ++y)
        for (int x = 0; x < int(size.x); ++x) {
            // The pixel's ray and those a tenth of a pixel beside it: at an edge two triangles are both right
            vec3 wanted(0.0f);
            int face = -1;
            for (const vec2 off : {vec2(0, 0), vec2(-0.1f, 0), vec2(0.1f, 0), vec2(0, -0.1f), vec2(0, 0.1f)}) {
                const ViewRay ray = viewRay((vec2(x, y) + 0.5f + off) / vec2(size), 0.0f, view.clipToWorld, view.eye);
                int before = 6, after = 6;
                met(ray.origin, ray.direction, before);
                const vec3 p = onFloor(ray), d = ray.direction;
                if (!(d.y < 0.0f) || before != 6 || p.z < -10.0f || std::abs(p.x) > 60.0f)
                    after = -2; // not the floor
                else
                    wanted = met(p, vec3(d.x, -d.y, d.z), after);
                face = face == -1 || face == after ? after : -2;
            }
            if (face < 0) continue;
            expectNear(at(picture, x, y), wanted, 4e-3f);
            ++judged[std::size_t(face)];
        }
    EXPECT_GT(judged[2], 50) << "the underside";
    EXPECT_GT(judged[5], 50) << "the front";
    EXPECT_GT(judged[6], 500) << "the sky";
}

// In a picture of few pixels a triangle that is drawn a little beside its place lies far off it: a floor must not mirror itself.
TEST_F(RayReflection, AFloorWithSnappedCornersShowsTheSky)
{
    scene.sky.radiance = vec3(0.5f);
    Material shining = metal(0.0f); // it would see its own light
    shining.emission = vec3(1.0f);
    shining.flags = kMaterialDoubleSided;
    floorTo(-10, shining);
    size = {16, 16};
    for (const vec2 off : furthestOff()) {
        cornersOff = off;
        const Image picture = byRays(lookAt(vec3(0), vec3(0, -1, -2), 0.9f));
        for (int y = 3; y < 16; ++y) // above is the sky itself
            for (int x = 0; x < 16; ++x) expectNear(at(picture, x, y), vec3(1.5f), 4e-3f);
    }
}

// Half of the facets of slope x along a line lie within so far across it, by quadrature of GGX's density of slopes.
TEST(ReflectionLobe, IsWiderAcrossWhereItsFacetsAreSteeper)
{
    const auto halfWidth = [](double x) {
        const auto within = [&](double limit) { // y = tan a, so that the limit may be infinite
            double sum = 0.0;
            for (int i = 0; i < 2000; ++i) {
                const double y = std::tan(std::atan(limit) * (i + 0.5) / 2000);
                sum += (1.0 + y * y) / ((1.0 + x * x + y * y) * (1.0 + x * x + y * y)) * std::atan(limit) / 2000;
            }
            return sum;
        };
        const double all = within(1e9);
        double low = 0.0, high = 10.0;
        for (int i = 0; i < 40; ++i) (within(0.5 * (low + high)) < 0.5 * all ? low : high) = 0.5 * (low + high);
        return low;
    };
    for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(halfWidth(double(lobeSlope(k))) / halfWidth(0.0), double(std::exp2(lobeWidening(k))), 1e-4) << k;
}

// Of a lobe that reaches over the top of a wall, what comes from beyond fades out as its facets do, without a corner. By their slopes in
// the plane of incidence, each weighed by how much the eye sees of it: where a tenth to an eighth of them sees the sky, less than the
// outermost tap stands for, a sixteenth of that is there at the least. Experiment: 1/14 to 1/6; taps all as wide as the lobe in its middle
// leave 1/39 to 1/16.
TEST_F(RayReflection, ARoughFloorFadesWithoutACorner)
{
    const float roughness = 0.24f, alpha = roughness * roughness, top = 1.0f;
    scene.sky.radiance = vec3(1.0f);
    floorTo(-10, metal(roughness));
    addQuad(scene, vec3(-60, -1, -10), vec3(120, 0, 0), vec3(0, 1 + top, 0), addMaterial(scene, matte(vec3(0.0f))));
    size = {64, 256};
    const Camera eye = lookAt(vec3(0), vec3(0, -0.25f, -1), 0.6f);
    const Image picture = byRays(eye);
    int judged = 0;
    for (int y = 0; y < int(size.y); ++y) {
        const ViewRay ray = eyeRay(eye, 32, y);
        const vec3 p = onFloor(ray);
        if (!(ray.direction.y < 0.0f) || p.z < -9.0f) continue;
        double beyond = 0.0, all = 0.0;
        for (int k = 0; k < 1000; ++k) {
            const float s = (float(k) + 0.5f) / 500.0f - 1.0f, slope = alpha * s / std::sqrt(1.0f - s * s);
            const vec3 facet = normalize(vec3(0, 1, slope)), onward = mirrorDirection(-ray.direction, facet);
            const double weight = std::max(-double(dot(ray.direction, vec3(0, 1, slope))), 0.0);
            all += weight;
            if (p.y + onward.y * (p.z + 10.0f) / -onward.z > top) beyond += weight;
        }
        if (beyond < all / 10 || beyond > all / 8) continue;
        ++judged;
        EXPECT_GT(double(at(picture, 32, y).y), beyond / all / 16.0) << y << ": " << beyond / all;
    }
    EXPECT_GT(judged, 2);
}

// Nothing is by lot that a filter could take away: whatever the frame's number, polish and gloss show the same, bit by bit.
TEST_F(RayReflection, IsTheSameInEveryFrame)
{
    scene.sky.radiance = vec3(0.2f);
    floorTo(-10, metal(0.2f));
    addQuad(scene, vec3(-1, -0.5f, -4), vec3(2, 0, 0), vec3(0, 1, 0), lamp(vec3(2, 1, 0.5f)));
    const Image first = byRays(camera);
    frame = 7;
    EXPECT_EQ(byRays(camera).pixels, first.pixels);
}

// A room with all that light can be at a hit: lightmaps at different places of two pages, probes on a back, glossy paint before cubemaps, a
// lamp with shadows, glass, a sky through a window. Its mirror floor shows what an eye as far below it sees where there is no floor.
TEST_F(RayReflection, AMirrorFloorShowsWhatAnEyeBehindItSees)
{
    scene.sky.radiance = vec3(0.3f, 0.6f, 0.9f);
    Material gloss = matte(vec3(0.3f, 0.5f, 0.2f));
    gloss.flags = 0u;
    gloss.roughness = 0.5f;
    Material glass = matte(vec3(1.0f));
    glass.flags = 0u;
    glass.transmission = 1.0f;
    glass.roughness = 0.0f;
    const uint grey = addMaterial(scene, matte(vec3(0.6f))), paint = addMaterial(scene, gloss), pane = addMaterial(scene, glass);
    addQuad(scene, vec3(-3, -1, -6), vec3(6, 0, 0), vec3(0, 2, 0), grey);          // the far wall, sky above it
    addQuad(scene, vec3(-3, -1, 2), vec3(0, 0, -8), vec3(0, 4, 0), paint);         // left
    addQuad(scene, vec3(3, -1, -6), vec3(0, 0, 8), vec3(0, 4, 0), grey);           // right
    addQuad(scene, vec3(-1.5f, -0.6f, -4), vec3(0, 0.8f, 0), vec3(1, 0, 0), grey); // shows its back
    addQuad(scene, vec3(0.2f, -0.4f, -4), vec3(1.2f, 0, 0), vec3(0, 0, 1), lamp(vec3(2, 1, 0.5f)));
    addQuad(scene, vec3(1, -1, -3), vec3(1.5f, 0, 0.5f), vec3(0, 1, 0), pane);
    addQuad(scene, vec3(-60, -1, 4), vec3(120, 0, 0), vec3(0, 0, -64), addMaterial(scene, metal(0.0f))); // the floor, last
    addLight(scene, pointLight(vec3(-0.5f, 2.5f, -2.5f), vec3(9.0f, 7.0f, 5.0f)));

    Scene roomOnly = scene;
    roomOnly.objects.pop_back();
    Scene floorAlone = scene; // as a lamp: where it is seen
    floorAlone.materials.back() = matte(vec3(0.0f));
    floorAlone.materials.back().emission = vec3(1000.0f);
    const Scene whole = scene;
    Baked full = bakedEvenly(scene, vec3(0.0f));
    full.lightmaps.push_back(full.lightmaps[0]);
    uint seed = 1;
    for (Lightmap& page : full.lightmaps)
        for (vec3& texel : page.texels)
            texel = vec3(0.2f) + 0.8f * vec3(hashFloat(seed), hashFloat(seed + 1), hashFloat(seed + 2)), seed += 3;
    for (std::size_t i = 0; i < full.places.size(); ++i)
        full.places[i] = {int(i % 2), vec2(0.4f, 0.3f), vec2(0.1f * float(i % 4), 0.6f - 0.1f * float(i % 5))};
    full.places[2].page = -1; // right: probes
    full.probes = evenProbes(vec3(-4, -2, -7), vec3(4, 4, 3), vec3(0.4f, 0.5f, 0.6f));
    full.reflections.push_back(evenReflection(vec3(-4, -2, -7), vec3(4, 4, 3), vec3(0.7f, 0.6f, 0.5f)));

    // The eye mirrored at y = -1; its picture is upside down
    Camera below = camera;
    for (int axis = 0; axis < 4; ++axis) below.toWorld[axis].y = -below.toWorld[axis].y;
    below.toWorld[3].y -= 2.0f;
    below.toWorld[1] = -below.toWorld[1];

    for (const ShadowMethod method : {ShadowMethod::map, ShadowMethod::ray}) {
        SCOPED_TRACE(method == ShadowMethod::map ? "baked, shadows by map" : "not baked, shadows by ray");
        baked = method == ShadowMethod::map ? full : Baked{};
        const DrawnParts parts{.shadow = true, .shadowMethod = method};
        scene = floorAlone;
        const Image where = radiance(camera);
        scene = roomOnly;
        const Image truth = radiance(below, parts);
        scene = whole;
        const Image picture = byRays(camera, parts);
        int judged = 0;
        for (int y = 1; y + 1 < int(size.y); ++y)
            for (int x = 1; x + 1 < int(size.x); ++x) {
                if (at(where, x, y).x < 999.0f) continue;
                const int flipped = int(size.y) - 1 - y;
                const vec3 wanted = at(truth, x, flipped);
                // Spared: where the image has an edge, for one ray may fall to either side of it
                bool even = true;
                for (const ivec2 off : {ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1)})
                    even = even && distance(at(truth, x + off.x, flipped + off.y), wanted) < 0.1f * length(wanted);
                if (!even) continue;
                expectNear(at(picture, x, y), wanted, 1e-2f); // 8 bits of base colour, as its root: 0.6 %
                ++judged;
            }
        EXPECT_GT(judged, 800);
    }
}

// The wall goes on above the picture, and so does its image: the mirror's last row shows it like any other.
TEST_F(RayReflection, NothingFadesAtTheBorderOfThePicture)
{
    for (const float roughness : {0.0f, 0.2f}) {
        scene = Scene{};
        floorTo(-10, metal(roughness));
        addQuad(scene, vec3(-600, -1, -10), vec3(1200, 0, 0), vec3(0, 600, 0), lamp(vec3(1.0f)));
        const Image picture = byRays(camera);
        for (int y = 0; y < int(size.y); ++y)
            for (int x = 0; x < int(size.x); ++x)
                if (eyeRay(camera, x, y).direction.y < 0.0f) expectNear(at(picture, x, y), vec3(1.0f), 2e-3f);
    }
}

// Everything has radiance 1, cubemaps too: what rays find is what is taken from the probes, to the rim of the mirror.
TEST_F(RayReflection, ReplacesExactlyWhatLightingTookFromTheProbes)
{
    scene.sky.radiance = vec3(1.0f);
    for (const float roughness : {0.0f, 0.15f, 0.25f, 0.3f}) {
        scene.materials.clear(), scene.vertices.clear(), scene.indices.clear(), scene.meshes.clear(), scene.objects.clear();
        Material floor = metal(roughness);
        floor.metallic = 0.5f;
        floor.baseColor = vec4(0.3f, 0.6f, 0.9f, 1.0f);
        addQuad(scene, vec3(-1, -1, -2), vec3(2, 0, 0), vec3(0, 0, -4), addMaterial(scene, floor));
        addQuad(scene, vec3(-1, -1, -6), vec3(2, 0, 0), vec3(0, 1, 0), lamp(vec3(1.0f)));
        baked = bakedEvenly(scene, vec3(1.0f));
        baked.reflections.push_back(evenReflection(vec3(-60, -2, -12), vec3(60, 60, 12), vec3(1.0f)));
        const Image plain = radiance(camera), picture = byRays(camera);
        for (std::size_t i = 0; i < plain.pixels.size(); ++i)
            ASSERT_NEAR(picture.pixels[i], plain.pixels[i], 2e-3f) << roughness << ' ' << i;
    }
}

// H65, roughness 1: what mirrors nothing that rays may tell keeps every bit; and where everything is too far away to blur nothing is.
TEST_F(RayReflection, WhatIsRoughOrMatteKeepsEveryBit)
{
    scene.sky.radiance = vec3(3.0f, 2.0f, 1.0f);
    floorTo(-10, metal(1.0f));
    addQuad(scene, vec3(-60, -1, -10), vec3(120, 0, 0), vec3(0, 9, 0), lamp(vec3(5.0f)));
    for (const Material& m : {metal(1.0f), metal(kScreenRoughness), matte(vec3(0.5f))}) {
        scene.materials[0] = m;
        EXPECT_EQ(byRays(camera).pixels, radiance(camera).pixels) << m.roughness;
    }
    scene.materials[0] = metal(0.1f);
    EXPECT_NE(byRays(camera).pixels, radiance(camera).pixels) << "and this test can fail";
}

// A ball of few faces with smooth normals mirrors the sky alone, down to its silhouette: no ray of its own meets it, or it would glow
// twice.
TEST_F(RayReflection, ARoundThingDoesNotMirrorItself)
{
    scene.sky.radiance = vec3(1.0f);
    Material ball = metal(0.0f);
    ball.emission = vec3(5.0f);
    addSphere(scene, addMaterial(scene, ball), 12).toWorld[3] = dvec4(0, -0.4, -4, 1);
    const Image picture = byRays(camera);
    int judged = 0;
    for (int y = 0; y < int(size.y); ++y)
        for (int x = 0; x < int(size.x); ++x) {
            if (at(picture, x, y).x < 2.0f) continue; // the sky itself
            expectNear(at(picture, x, y), vec3(6.0f), 2e-3f);
            ++judged;
        }
    EXPECT_GT(judged, 500);
}
}
