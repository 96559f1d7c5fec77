// H89: ten million paths, of a pixel and of a texel. A sum of floats stands still long before: 0.1 added to 2^19 changes it by 0.125 or
// 0.0625.
#include "asked.hpp"
#include <nlohmann/json.hpp>

namespace afterglow::test
{
namespace
{
constexpr int kMany = 10'000'000;

// A black plate of 2 cm under a sky that shines with 0.1 from the side of +x, and from the other one not at all: by symmetry half of it is
// seen.
Scene halfASky()
{
    Scene scene;
    add(scene, plate(vec3(0.0f), 0.01f), matte(0.0f));
    scene.lower = vec3(-0.01f, 0.0f, -0.01f), scene.upper = vec3(0.01f, 0.0f, 0.01f);
    scene.sky.radiance = vec3(0.1f);
    scene.sky.image = Image(8, 4, 3);
    for (int y = 0; y < 4; y++)
        for (int x = 2; x < 6; x++)
            for (int c = 0; c < 3; c++) scene.sky.image.at(x, y)[c] = 1.0f;
    return scene;
}
constexpr double kHalf = 0.05, kDeviation = 0.05; // of a path: at most that of 0 and 0.1

Image upwards(const Scene& scene, ivec2 size, int samples, int threads)
{
    TruthOptions options;
    options.camera.toWorld = mat4(vec4(0, 0, 1, 0), vec4(1, 0, 0, 0), vec4(0, -1, 0, 0), vec4(0, 1, 0, 1));
    options.size = size;
    options.samples = samples;
    options.threads = threads;
    Progress silent(ProgressStyle::none);
    return truth(scene, options, silent);
}
}

TEST(Film, slowErrorOfAPixelFallsToTheEnd)
{
    const Scene scene = halfASky();
    for (int samples = kMany; samples >= 1000; samples /= 10)
        EXPECT_NEAR(double(upwards(scene, ivec2(1, 1), samples, 1).pixels[0]), kHalf, 4.0 * kDeviation / std::sqrt(double(samples)))
            << samples;
}

// All paths bring the same: chance hides nothing of what rounding does.
TEST(Film, slowATexelLosesNothing)
{
    Scene scene = halfASky();
    scene.sky.image = {};
    BakeOptions options;
    options.texelsPerMetre = 50.0f;
    options.samples = kMany;
    options.denoiser = Denoiser::none;
    options.probes = options.reflections = options.lods = options.voxels = false;
    Progress silent(ProgressStyle::none);
    nlohmann::json told;
    const Lightmap page = bakeScene(scene, options, silent, told).lightmaps[0];
    int texels = 0;
    for (std::size_t i = 0; i < page.texels.size(); i++) {
        if (page.valid[i] != 1) continue;
        EXPECT_NEAR(page.texels[i].x, 0.1f, 1e-7f);
        texels++;
    }
    EXPECT_GT(texels, 0);
}

// Of the wavefront tests/baker/waves_test.cpp asks it, of a bake bake_test.cpp.
TEST(Film, IsTheSameBitsForOneThreadAndThree)
{
    const Scene scene = halfASky();
    EXPECT_EQ(upwards(scene, ivec2(40, 33), 16, 1).pixels, upwards(scene, ivec2(40, 33), 16, 3).pixels);
}
}
