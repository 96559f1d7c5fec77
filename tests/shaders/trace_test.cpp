// The two tracers against each other: what a ray meets by ray query and by Embree, and what of it passes.
#include "shaders/random.h"
#include "shaders/sampling.h"
#include "tests/shaders/tracing.hpp"

namespace afterglow
{
class Trace : public Tracing
{
protected:
    Scene scene;

    // Rays from random points of the box, uniform in direction.
    static std::vector<Ray> raysIn(vec3 lower, vec3 upper, uint count, float far = kRayFar)
    {
        std::vector<Ray> rays;
        for (uint i = 0; i < count; ++i) {
            shared::Sampler random = makeSampler(7u, i);
            const vec2 xy = next2(random);
            const vec3 at(xy.x, xy.y, next1(random));
            rays.push_back({mix(lower, upper, at), sampleUniformSphere(next2(random)), far});
        }
        return rays;
    }

    void turned(const mat4& toWorld)
    {
        for (Object& object : scene.objects) object.toWorld = dmat4(toWorld);
    }
};

// Rays through whole levels. Where a ray passes an edge closer than the two tracers' rounding they may differ: one in a thousand. Of two
// faces that coincide either may be met, by either tracer; what they share, place and normal, is the same.
TEST_F(Trace, MeetsWhatEmbreeMeets)
{
    for (const char* path : {"content/gallery/gallery.glb", "content/two_rooms/two_rooms_open.glb", "content/cornell/cornell.glb",
                             "content/truth/furnace_clutter.glb", "content/truth/mirror_corridor.glb"}) {
        const Scene level = loadLevel(path);
        const World world(level, Content::everything);
        const std::vector<Instance> placed = instances(level);
        std::vector<Ray> rays = raysIn(level.lower, level.upper, 2048);
        for (std::size_t i = 0; i < rays.size(); i += 2) rays[i].far = 0.2f * distance(level.lower, level.upper);
        const std::vector<Answer> answers = trace(level, rays);
        int hits = 0, same = 0, differ = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Hit hit = world.closestHit(rays[i]);
            differ += distance(world.transmittance(rays[i]), answers[i].passed) > 5e-3f;
            if (std::abs(hit.distance - answers[i].hit.distance) > 1e-5f * std::max(hit.distance, 1.0f)) {
                ++differ;
                continue;
            }
            if (!(hit.distance < kRayFar)) continue;
            ++hits;
            const Surface surface = world.surfaceAt(rays[i], hit);
            EXPECT_LT(distance(surface.position, answers[i].position), 1e-4f) << path;
            EXPECT_GT(dot(surface.geometricNormal, answers[i].geometricNormal), 0.999f) << path;
            if (world.triangles()[hit.triangle].object != placed[answers[i].instance].object)
                continue; // of two that coincide the other one
            ++same;
            EXPECT_GT(dot(surface.frame.normal, answers[i].normal), 0.99f) << path;
            EXPECT_LT(distance(surface.bsdf.diffuse, answers[i].diffuse), 0.02f) << path; // textures are filtered with 8 bits of fraction
            EXPECT_LT(distance(surface.emission, answers[i].emission), 0.02f) << path;
        }
        EXPECT_GT(hits, 200) << path;
        EXPECT_GT(same, hits * 9 / 10) << path;
        EXPECT_LE(differ, 4) << path;
    }
}

// H51: sixteen sheets of holes, each shifted by whole texels, alpha at the cutoff keeping: what Embree meets. The rays go through the inner
// nine tenths of texels: nearer to their borders the fraction's 8 bits decide, which Vulkan leaves to the device.
TEST_F(Trace, ObeysAlphaMasksAsEmbreeDoes)
{
    SceneTexture texture;
    texture.image.width = texture.image.height = 16;
    texture.nearest = true;
    texture.image.pixels.assign(16 * 16 * 4, 255);
    for (uint i = 0; i < 256; ++i) texture.image.pixels[4 * i + 3] = std::uint8_t(hash1(i) % 3u * 64u); // 0, 64 or 128
    scene.textures.push_back(texture);
    for (int sheet = 0; sheet < 16; ++sheet) {
        Material leaf = matte(vec3(0.5f));
        leaf.flags |= kMaterialAlphaMask;
        leaf.alphaCutoff = 128.0f / 255.0f;
        leaf.baseColorTexture.texture = 0;
        leaf.baseColorTexture.offset = vec2(float(3 * sheet % 16), float(5 * sheet % 16)) / 16.0f;
        addQuad(scene, vec3(-1, -1, 0.1f * float(sheet)), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, leaf));
    }
    const World world(scene, Content::everything);
    std::vector<Ray> rays;
    for (uint i = 0; i < 2048; ++i) {
        shared::Sampler random = makeSampler(9u, i);
        const vec2 texel = floor(16.0f * next2(random)), at = (texel + 0.05f + 0.9f * next2(random)) / 8.0f - 1.0f;
        const bool down = next1(random) < 0.5f;
        rays.push_back({vec3(at, 1.65f * next1(random) - 0.05f), vec3(0, 0, down ? -1 : 1), 0.8f * next1(random)});
    }
    const std::vector<Answer> answers = trace(scene, rays);
    int open = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const bool passes = world.transmittance(rays[i]) != vec3(0.0f);
        open += passes;
        EXPECT_EQ(passes, answers[i].passed != vec3(0.0f)) << i;
        EXPECT_NEAR(world.closestHit(rays[i]).distance, answers[i].hit.distance, 1e-4f) << i;
    }
    EXPECT_GT(open, 200);
    EXPECT_LT(open, 1848);
}

// H51: all of a mask below its cutoff is absent; a thousand layers of it end, by either tracer.
TEST_F(Trace, PassesAThousandLayersOfNothing)
{
    Material nothing = matte(vec3(0.5f));
    nothing.flags |= kMaterialAlphaMask;
    nothing.baseColor.a = 0.0f;
    const uint material = addMaterial(scene, nothing);
    for (int i = 0; i < 1000; ++i) addQuad(scene, vec3(-1, -1, -0.001f * float(i)), vec3(2, 0, 0), vec3(0, 2, 0), material);
    const Ray ray{vec3(0.1f, 0.2f, 1), vec3(0, 0, -1), kRayFar};
    const Answer answer = trace(scene, {ray})[0];
    EXPECT_EQ(answer.passed, vec3(1.0f));
    EXPECT_EQ(answer.hit.distance, kRayFar);
    const World world(scene, Content::everything);
    EXPECT_EQ(world.transmittance(ray), vec3(1.0f));
    EXPECT_EQ(world.closestHit(ray).distance, kRayFar);
}

// The mean that the baker draws lots for: what passes two sheets of alpha 1/4 and 1/2, and clear glass.
TEST_F(Trace, SharesLightWithBlendedSheetsAndTintsItByGlass)
{
    Material sheet = matte(vec3(0.5f)), glass = matte(vec3(0.5f, 0.8f, 1.0f));
    sheet.flags |= kMaterialAlphaBlend;
    sheet.baseColor.a = 0.25f;
    addQuad(scene, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, sheet));
    sheet.baseColor.a = 0.5f;
    addQuad(scene, vec3(-1, -1, 0.5f), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, sheet));
    const Ray ray{vec3(0.1f, 0.2f, 3), vec3(0, 0, -1), kRayFar};
    EXPECT_EQ(trace(scene, {ray})[0].passed, vec3(0.375f));
    Scene clear;
    glass.transmission = 1.0f;
    glass.roughness = 0.0f;
    glass.flags = 0;
    addQuad(clear, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(clear, glass));
    const World world(clear, Content::everything);
    const vec3 wanted = world.transmittance(ray);
    EXPECT_GT(wanted.y, 0.5f);
    EXPECT_LT(distance(trace(clear, {ray})[0].passed, wanted), 2e-3f);
}

// H20, H21: a mesh placed turned, flattened a thousand times, and far away.
TEST_F(Trace, MeetsPlacedMeshesWhereTheyAre)
{
    addRoom(scene, vec3(-1), vec3(1), addMaterial(scene, matte(vec3(0.5f))));
    const mat4 turn(vec4(0.6f, 0.8f, 0, 0), vec4(-0.8f, 0.6f, 0, 0), vec4(0, 0, 1, 0), vec4(0, 0, 0, 1));
    for (const vec3 scale : {vec3(1), vec3(1000, 1, 1), vec3(1, 0.001f, 3)})
        for (const vec3 away : {vec3(0), vec3(20, -3, 0.77f)}) {
            mat4 toWorld = turn;
            for (int c = 0; c < 3; ++c) toWorld[c] *= scale[c];
            toWorld[3] = vec4(away, 1);
            turned(toWorld);
            const World world(scene, Content::everything);
            std::vector<Ray> rays;
            for (Ray ray : raysIn(vec3(-0.9f), vec3(0.9f), 256)) {
                ray.origin = vec3(toWorld * vec4(ray.origin, 1.0f));
                rays.push_back(ray);
            }
            const std::vector<Answer> answers = trace(scene, rays);
            int differ = 0;
            for (std::size_t i = 0; i < rays.size(); ++i) {
                const Hit hit = world.closestHit(rays[i]);
                ASSERT_LT(answers[i].hit.distance, kRayFar) << i;
                const bool same = std::abs(answers[i].hit.distance - hit.distance) < 1e-2f * std::max(1.0f, hit.distance);
                const float along = dot(answers[i].geometricNormal, world.surfaceAt(rays[i], hit).geometricNormal);
                differ += !same || std::abs(along - 1.0f) > 1e-4f;
            }
            EXPECT_LE(differ, 2) << "of 256, near the room's edges";
        }
}

// H04: rays at the edges and corners of a closed body, from inside. None may pass an edge. At a corner itself, where no path ever looks on
// purpose, Vulkan only says that devices should be watertight: lavapipe 25.0 lets 49 of 10 000 rays pass that are aimed at one, and none that
// are aimed 1e-5 beside it: of all rays inside a black body fewer than 12 corners * (1e-5 / 2)^2 = 3e-10 see what lies outside.
TEST_F(Trace, DoesNotLeaveAClosedBodyThroughItsEdges)
{
    const uint material = addMaterial(scene, matte(vec3(0.5f)));
    const float g = 1.61803399f; // the golden ratio: an icosahedron's corners
    const std::vector<vec3> corners = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                       {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    const std::vector<uvec3> faces = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (const vec3& corner : corners) scene.vertices.push_back({corner, normalize(corner), vec4(1, 0, 0, 1), vec2(0), vec2(0), ~0u});
    for (const uvec3& face : faces) scene.indices.insert(scene.indices.end(), {face.x, face.y, face.z});
    scene.meshes.push_back({"icosahedron", {Primitive{0, 12, 0, 60, material}}});
    Object object;
    object.toWorld =
        dmat4(mat4(vec4(0.48f, 0.64f, -0.6f, 0), vec4(-0.8f, 0.6f, 0, 0), vec4(0.36f, 0.48f, 0.8f, 0), vec4(0.3f, 5, 0.1f, 1)));
    scene.objects.push_back(object);
    const World world(scene, Content::everything); // for the corners in the world
    std::vector<Ray> edges, points, beside;
    for (uint i = 0; i < 100000; ++i) {
        shared::Sampler random = makeSampler(3u, i);
        const World::Triangle& t = world.triangles()[i % 20u];
        const vec3 a = world.vertices()[t.vertex[i / 20u % 3u]].position, b = world.vertices()[t.vertex[(i / 20u + 1u) % 3u]].position;
        const vec2 xy = next2(random);
        const vec3 from = vec3(0.3f, 5, 0.1f) + (vec3(xy.x, xy.y, next1(random)) - 0.5f);
        edges.push_back({from, normalize(mix(a, b, next1(random)) - from), kRayFar});
        if (i >= 10000) continue;
        const vec3 way = normalize(a - from);
        const Frame f = makeFrame(way);
        const float turn = kTwoPi * next1(random);
        points.push_back({from, way, kRayFar});
        beside.push_back({from, normalize(way + 1e-5f * (f.tangent * std::cos(turn) + f.bitangent * std::sin(turn))), kRayFar});
    }
    int leaks = 0;
    for (const std::vector<Ray>& rays : {edges, beside})
        for (const Answer& answer : trace(scene, rays)) leaks += answer.hit.distance == kRayFar || answer.passed != vec3(0.0f);
    EXPECT_EQ(leaks, 0);
    leaks = 0;
    for (const Answer& answer : trace(scene, points)) leaks += answer.hit.distance == kRayFar || answer.passed != vec3(0.0f);
    EXPECT_LE(leaks, 100);
}

// H24: in the plane of a triangle, along an axis, with components of -0, with no way to go: a hit where there is one, else none, never NaN.
TEST_F(Trace, SurvivesRaysWithoutADirectionOrALength)
{
    addQuad(scene, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, matte(vec3(0.5f))));
    addQuad(scene, vec3(3, -1, -1), vec3(0, 2, 0), vec3(0, 0, 2), 0);
    const std::vector<Ray> rays = {
        {vec3(0.1f, 0.2f, 1), vec3(0, 0, -1), kRayFar}, {vec3(0.1f, 0.2f, 1), vec3(-0.0f, -0.0f, -1), kRayFar},
        {vec3(-5, 0.3f, 0), vec3(1, 0, 0), kRayFar}, // in the first quad's plane, onto the second
        {vec3(0.1f, 0.2f, 1), vec3(0, 0, 0), kRayFar},  {vec3(0.1f, 0.2f, 1), vec3(0, 0, -1), 0.0f},
        {vec3(0.1f, 0.2f, 1), vec3(0, 0, -1), 0.5f},
    };
    const std::vector<Answer> answers = trace(scene, rays);
    EXPECT_NEAR(answers[0].hit.distance, 1.0f, 1e-6f);
    EXPECT_NEAR(answers[1].hit.distance, 1.0f, 1e-6f);
    EXPECT_NEAR(answers[2].hit.distance, 8.0f, 1e-5f);
    for (int i : {3, 4, 5}) EXPECT_EQ(answers[std::size_t(i)].hit.distance, kRayFar) << i;
    for (const Answer& answer : answers) EXPECT_TRUE(std::isfinite(dot(answer.position, vec3(1)))) << answer.position.x;
}

// H25: of 1000 random triangles from 1e-8 to 1e8 m, the coordinates of each within a factor of two, none is met again by any of 1000 rays that
// leave it, by either tracer.
// (Where a triangle is a million times as far along one axis as along another, lavapipe 25.0 meets 35 of 1000 again, and Embree none.)
TEST_F(Trace, NeverMeetsAgainWhatItLeaves)
{
    const uint material = addMaterial(scene, matte(vec3(0.5f)));
    const uint each = 1000;
    std::vector<Ray> rays;
    for (uint i = 0; i < 1000; ++i) {
        shared::Sampler random = makeSampler(11u, i);
        vec3 p[3], size(std::pow(10.0f, 16.0f * next1(random) - 8.0f));
        for (int c = 0; c < 3; ++c) size[c] *= next1(random) < 0.5f ? -1.0f : 1.0f;
        for (vec3& corner : p)
            for (int c = 0; c < 3; ++c) corner[c] = size[c] * (1.0f + next1(random));
        const vec3 n = cross(p[1] - p[0], p[2] - p[0]);
        if (!(length(n) > 0.0f) || !(length(n) <= kFloatMax)) continue;
        const vec3 b = sampleTriangle(next2(random)), front = normalize(n);
        const vec3 at = b.x * p[0] + b.y * p[1] + b.z * p[2];
        const uint first = uint(scene.vertices.size()), index = uint(scene.indices.size());
        for (const vec3& corner : p) scene.vertices.push_back({corner, front, vec4(1, 0, 0, 1), vec2(0), vec2(0), ~0u});
        scene.indices.insert(scene.indices.end(), {0u, 1u, 2u});
        scene.meshes.push_back({"triangle", {Primitive{first, 3, index, 3, material}}});
        Object object;
        object.mesh = uint(scene.meshes.size() - 1);
        scene.objects.push_back(object);
        for (uint k = 0; k < each; ++k) {
            const vec3 local = sampleCosineHemisphere(next2(random));
            rays.push_back({offsetRay(at, front), toWorld(makeFrame(front), local), kRayFar});
        }
    }
    const std::vector<Answer> answers = trace(scene, rays);
    const World world(scene, Content::everything);
    int again = 0, againByEmbree = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::size_t left = i / each;
        again += answers[i].hit.distance < kRayFar && answers[i].vertex == 3 * left;
        const Hit hit = world.closestHit(rays[i]);
        againByEmbree += hit.distance < kRayFar && world.triangles()[hit.triangle].object == left;
    }
    EXPECT_EQ(again, 0);
    EXPECT_EQ(againByEmbree, 0);
}

// H26: a glass shell 4e-5 above a ball: the ray that leaves the shell downwards meets the ball, not the shell.
TEST_F(Trace, FindsASurfaceFourHundredthsOfAMillimetreBelow)
{
    const uint material = addMaterial(scene, matte(vec3(0.5f)));
    addQuad(scene, vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), material);
    addQuad(scene, vec3(-1, -4e-5f, -1), vec3(0, 0, 2), vec3(2, 0, 0), material);
    std::vector<Ray> rays;
    for (uint i = 0; i < 500; ++i) {
        shared::Sampler random = makeSampler(5u, i);
        const vec2 at = next2(random) - 0.5f;
        rays.push_back({offsetRay(vec3(at.x, 0, at.y), vec3(0, -1, 0)),
                        -toWorld(makeFrame(vec3(0, 1, 0)), sampleUniformCone(0.866f, next2(random))), kRayFar});
    }
    for (const Answer& answer : trace(scene, rays)) EXPECT_EQ(answer.vertex, 4u);
    const World world(scene, Content::everything);
    for (const Ray& ray : rays) EXPECT_EQ(world.triangles()[world.closestHit(ray).triangle].object, 1u);
}

// H17, H19: nothing, or nothing but an empty range, has nothing to meet and takes no memory.
TEST_F(Trace, OfNothingThereIsNoTree)
{
    const std::uint64_t before = gpu.memory.bytes();
    EXPECT_FALSE(buildRays(gpu, scene, instances(scene)));
    EXPECT_EQ(gpu.memory.bytes(), before);
}

// A tree costs what its buffers take, and gives it back.
TEST_F(Trace, EveryByteOfATreeIsCounted)
{
    addRoom(scene, vec3(-2), vec3(2), addMaterial(scene, matte(vec3(0.5f))));
    const std::uint64_t before = gpu.memory.bytes();
    {
        const GpuRays rays = buildRays(gpu, scene, instances(scene));
        std::uint64_t bytes = rays.level.storage.bytes + rays.triangles.bytes + rays.instances.bytes + rays.meetingErrors.bytes;
        for (const AccelerationStructure& structure : rays.structures) bytes += structure.storage.bytes;
        EXPECT_EQ(gpu.memory.bytes() - before, bytes);
        EXPECT_EQ(rays.structures.size(), 6u);
        EXPECT_FALSE(rays.filtered);
    }
    EXPECT_EQ(gpu.memory.bytes(), before);
}
}
