// Fog as drawn, fog scattered once by the path tracer, and fog scattered by all orders: the two parts of the error, told apart and printed
// (engine/effects/fog/README.md quotes the table). Walls are black, so that nothing but air is compared.
#include "baker/baker.hpp"
#include "engine/frame/frame.hpp"
#include "engine/graph/executor.hpp"
#include "tests/engine/gpu/validated.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <cstdio>

namespace afterglow
{
class FogTruth : public Validated
{
protected:
    // A dark room 4 m wide. A sun comes through slots in its ceiling, or a lamp hangs in the middle of it.
    static Scene room(float extinction, float g, bool sun)
    {
        Scene scene;
        const uint black = addMaterial(scene, matte(vec3(0.0f)));
        addRoom(scene, vec3(-2, -1.5f, -3), vec3(2, 4, 3), black);
        scene.objects.erase(scene.objects.begin() + 1); // without its ceiling
        for (int i = 0; i < 4; ++i) addQuad(scene, vec3(-2, 1.5f, 1.5f * float(i) - 3.0f), vec3(4, 0, 0), vec3(0, 0, 0.75f), black);
        Medium air{};
        air.scattering = vec3(0.9f * extinction), air.absorption = vec3(0.1f * extinction), air.g = g;
        air.lower = vec3(-2, -1.5f, -3), air.upper = vec3(2, 1.5f, 3);
        scene.media.push_back(air);
        Light lamp = pointLight(vec3(0.3f, 0.2f, -0.5f), vec3(20.0f));
        lamp.radius = 0.1f;
        addLight(scene, sun ? sunLight(vec3(0.2f, -1.0f, -0.3f), vec3(20.0f)) : lamp);
        return scene;
    }
    Image drawn(const Scene& scene, const Camera& camera, uvec2 size, uint divisor)
    {
        Settings settings;
        settings.fog.divisor = divisor;
        settings.size = size;
        Stage stage = makeStage(gpu, scene, nullptr, settings);
        Graph graph;
        const Pictures pictures = drawFrame(graph, stage, makeView(camera, size), settings);
        graph.output(pictures.radiance);
        Executor executor(gpu);
        executor.run(graph, stage.level->set);
        return executor.download(pictures.radiance);
    }
    static Image traced(const Scene& scene, const Camera& camera, uvec2 size, std::optional<int> scatterings, uint seed = 1)
    {
        TruthOptions options;
        options.camera = camera;
        options.size = ivec2(size);
        options.samples = 64;
        options.seed = seed;
        options.scatterings = scatterings;
        Progress silent(ProgressStyle::none);
        return truth(scene, options, silent);
    }
};

static double mean(const Image& image)
{
    double sum = 0.0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) sum += double(image.at(x, y)[1]);
    return sum / double(image.width * image.height);
}

// Of tiles of 16 x 16 pixels, which noise hardly reaches: mean difference, relative to the mean.
static double apart(const Image& image, const Image& truth)
{
    const int tile = 16;
    double sum = 0.0;
    for (int y = 0; y < truth.height; y += tile)
        for (int x = 0; x < truth.width; x += tile) {
            double difference = 0.0;
            for (int k = 0; k < tile * tile; ++k)
                difference += double(image.at(x + k % tile, y + k / tile)[1] - truth.at(x + k % tile, y + k / tile)[1]);
            sum += std::abs(difference);
        }
    return sum / double(truth.width * truth.height) / mean(truth);
}

TEST_F(FogTruth, OneOrderIsMetAndTheOthersAreMissed)
{
    const Camera camera = lookAt(vec3(-1.6f, -0.8f, 2.6f), vec3(0.6f, 0.1f, -1.5f), 1.0f);
    const uvec2 size(96, 64);
    std::printf("| light | optical depth of the room | g | drawn at full resolution against one order | at a quarter "
                "| two seeds of one order | light that one order misses |\n");
    for (const bool sun : {true, false})
        for (const auto& [depth, g] : {std::pair{0.1f, 0.0f}, {0.5f, 0.0f}, {2.0f, 0.0f}, {2.0f, 0.7f}}) {
            const Scene scene = room(depth / 6.0f, g, sun);
            const Image picture = drawn(scene, camera, size, 1), quarter = drawn(scene, camera, size, 4);
            const Image once = traced(scene, camera, size, 1), again = traced(scene, camera, size, 1, 2);
            const Image all = traced(scene, camera, size, {});
            const double ours = apart(picture, once), noise = apart(again, once);
            const double darker = 1.0 - mean(once) / mean(all);
            std::printf("| %s | %.1f | %.1f | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", sun ? "sun through slots" : "lamp", double(depth),
                        double(g), 100.0 * ours, 100.0 * apart(quarter, once), 100.0 * noise, 100.0 * darker);
            EXPECT_LT(
                ours,
                0.03 +
                    1.5 *
                        noise); // shadow maps, and lamps asked for from their middle; two pictures of independent noise differ by sqrt(2) of one's
            EXPECT_GT(darker, 0.0);
        }
}
}
