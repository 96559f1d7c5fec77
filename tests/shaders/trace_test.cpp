// The two tracers against each other: what a ray meets by ray query and by Embree, and what of it passes.
#include "tests/shaders/trace.hpp"

namespace afterglow
{
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
        const std::vector<TracedAnswer> answers = trace(level, rays);
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
    const std::vector<TracedAnswer> answers = trace(scene, rays);
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
    const TracedAnswer answer = trace(scene, {ray})[0];
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
            const std::vector<TracedAnswer> answers = trace(scene, rays);
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
