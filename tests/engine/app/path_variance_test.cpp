// One path of either tracer is a random number whose variance is known: pictures of a path a pixel, judged by their mean and their spread.
// Closed forms, by their names: medium.tracking_variance (analog), medium.random_walk, mc.roulette, mc.binary, mc.hemisphere (cosine).
#include "baker/tracer.hpp"
#include "tests/engine/app/tracers.hpp"
#include "tests/engine/upload/toy_level.hpp"

namespace afterglow
{
class PathVariance : public Tracers
{
protected:
    void SetUp() override {} // the CPU's answers need no device

    Scene scene;
    TruthOptions asked{.size = ivec2(128), .samples = 1};

    // Mean and variance over the pixels, each within four of its standard errors; of the variance that is sqrt((m4 - variance^2) / n).
    static void expectSpread(const char* tracer, const Image& image, double mean, double variance)
    {
        std::vector<double> values;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) values.push_back(double(image.at(x, y)[1]));
        const double n = double(values.size());
        double first = 0.0, second = 0.0, fourth = 0.0;
        for (const double value : values) first += value / n;
        for (const double value : values) {
            const double square = (value - first) * (value - first);
            second += square / (n - 1.0);
            fourth += square * square / n;
        }
        constexpr double kRounding = 1e-5; // of paths of many vertices in fp32
        EXPECT_NEAR(first, mean, 4.0 * std::sqrt(second / n) + kRounding * mean) << tracer;
        EXPECT_NEAR(second, variance, 4.0 * std::sqrt(std::max(fourth - second * second, 0.0) / n) + kRounding * mean) << tracer;
    }
    void expectSpread(double mean, double variance)
    {
        expectSpread("CPU", byEmbree(scene, asked), mean, variance);
        asked.seed = 2; // other paths
        if (canTrace(gpu.device, Tracing::automatic)) expectSpread("GPU", onGpu(scene, asked), mean, variance);
    }

    void air(vec3 scattering, vec3 absorption, vec3 emission, vec3 lower, vec3 upper)
    {
        Medium m{};
        m.scattering = scattering, m.absorption = absorption, m.emission = emission;
        m.lower = lower, m.upper = upper;
        scene.media.push_back(m);
    }
    // Facing mirrors that reflect half and send out 1, before an eye that looks straight at one of them: 2 = 1 + 1/2 + 1/4 ...
    void shiningMirrors()
    {
        Material mirror = matte(vec3(0.5f));
        mirror.flags = 0u;
        mirror.metallic = 1.0f, mirror.roughness = 0.0f;
        mirror.emission = vec3(1.0f);
        const uint material = addMaterial(scene, mirror);
        addQuad(scene, vec3(-1, -1, -1), vec3(2, 0, 0), vec3(0, 2, 0), material);
        addQuad(scene, vec3(-1, -1, 1), vec3(0, 2, 0), vec3(2, 0, 0), material);
        asked.camera = lookAt(vec3(0), vec3(0, 0, -1));
        asked.camera.fovY = 0.0f;
        asked.camera.orthoHeight = 0.5f;
    }
};

// Air that swallows, before a sky of 1: a path arrives or it does not, T (1 - T). What lights ask of air is no path: it has no variance.
TEST_F(PathVariance, AFlightIsAnAnalogTrial)
{
    scene.sky.radiance = vec3(1.0f);
    air(vec3(0.0f), vec3(0.5f), vec3(0.0f), vec3(-9, -9, -4), vec3(9, 9, -2)); // an optical depth of 1
    asked.camera = lookAt(vec3(0), vec3(0, 0, -1));
    asked.camera.fovY = 0.0f;
    asked.camera.orthoHeight = 1.0f;
    expectSpread(std::exp(-1.0), 0.2325441579);
}

// Endless air that shines: each flight brings 1, and half of the collisions end the path, so that no weight is ever other than 1.
TEST_F(PathVariance, ACollisionEndsPathsByTheAlbedo)
{
    air(vec3(0.5f), vec3(0.5f), vec3(1.0f), vec3(-999), vec3(999));
    asked.camera = lookAt(vec3(0), vec3(0, 0, -1));
    expectSpread(2.0, 2.0);
}

// A surface that may end a path from the first on does so by its albedo, too.
TEST_F(PathVariance, ASurfaceEndsPathsByTheAlbedo)
{
    shiningMirrors();
    asked.rouletteFrom = 0;
    expectSpread("CPU", byEmbree(scene, asked), 2.0, 2.0);
}

// Where surfaces end paths only after the fourth, five vertices are sure; what lies beyond, with the weight 1/32, lives by q = 1/32 and is
// then a path of the test before: of mean 2 and mean square 2 + 2^2, so that the variance is q (2 + 4) - (2 q)^2.
TEST_F(PathVariance, ASurfaceSparesPathsUntilTheyAreDim)
{
    shiningMirrors();
    const double q = 1.0 / 32.0;
    expectSpread(2.0, 6.0 * q - 4.0 * q * q);
}

// A white floor beside a black wall that leaves the share p of its sky: p (1 - p). Alone under the sky there is nothing left to chance.
TEST_F(PathVariance, ABounceSeesTheSkyOrItDoesNot)
{
    scene.sky.radiance = vec3(1.0f);
    const uint white = addMaterial(scene, matte(vec3(1.0f))), black = addMaterial(scene, matte(vec3(0.0f)));
    addQuad(scene, vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), white);
    asked.camera = lookAt(vec3(0.1f, 0.09f, 0), vec3(0.1f, 0, 0), 0.01f);
    expectSpread(1.0, 0.0);
    for (const auto& [degrees, p] : {std::pair(90.0f, 0.5), std::pair(60.0f, 0.25)}) { // (1 - cos) / 2
        scene.objects.resize(1), scene.meshes.resize(1);
        const float angle = degrees * kPi / 180.0f;
        addQuad(scene, vec3(0, 0, -1000), vec3(std::cos(angle), std::sin(angle), 0) * 1000.0f, vec3(0, 0, 2000), black);
        expectSpread(p, p * (1.0 - p));
    }
}

// Mean squared distance of n flights: 2 / sigma^2 [n / (1 - g) - g (1 - g^n) / (1 - g)^2]. No picture tells how far a path went: the CPU's
// own steps do, one collision each.
TEST_F(PathVariance, AWalkThroughAirStraysAsFarAsItMust)
{
    struct Row {
        int flights;
        float g, sigma;
        double value;
    };
    for (const Row& row : {Row{10, 0.0f, 1.0f, 20.0}, Row{10, 0.9f, 1.0f, 82.76211922}, Row{1, 0.5f, 2.0f, 0.5}}) {
        scene.media.clear();
        air(vec3(row.sigma), vec3(0.0f), vec3(0.0f), vec3(-9999), vec3(9999));
        scene.media[0].g = row.g;
        const World world(scene, Content::everything);
        const LightTransport transport(world, {});
        RayCount rays;
        const Tracer tracer{&transport, &transport.none, &rays};
        constexpr uint kWalks = 100000;
        double sum = 0.0, squares = 0.0;
        for (uint walk = 0; walk < kWalks; ++walk) {
            Path path = beginPath(Ray{vec3(0.0f), vec3(0, 0, 1), kRayFar}, 0.0f, makeSampler(hash2(1u, walk), 0u));
            for (int k = 0; k < row.flights; ++k) ASSERT_TRUE(advance(tracer, tracer, closestHit(tracer, path.ray), path));
            const double strayed = double(dot(path.ray.origin, path.ray.origin));
            sum += strayed / kWalks;
            squares += strayed * strayed / kWalks;
        }
        EXPECT_NEAR(sum, row.value, 4.0 * std::sqrt((squares - sum * sum) / kWalks) + 1e-5 * row.value) << row.flights << ' ' << row.g;
    }
}
}
