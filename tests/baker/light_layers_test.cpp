// Light taken apart: the layers sum up to the light of the whole, and a bake after a change of strengths equals one that traces everything,
// bit by bit, without a ray.
#include "again.hpp"
#include "baker/light_layers.hpp"
#include "baker/tile_light.hpp"

namespace afterglow
{
// A grey room, 2 m wide, open on top to the sky, with two lamps and a block that glows.
static Scene lampRoom()
{
    Scene scene;
    addSurface(scene, part(flipped(box(vec3(2.0f))), [](vec3 p) { return p.y < 0.9f; }), shining(0.0f, 0.5f));
    addSurface(scene, moved(box(vec3(0.3f)), vec3(0.4f, -0.7f, 0.4f)), shining(2.0f));
    scene.materials.back().emission = vec3(2.0f, 0.5f, 0.0f);
    scene.lower = vec3(-1.0f), scene.upper = vec3(1.0f);
    scene.lights = {lampAt(vec3(0.5f, 0.5f, 0.0f), vec3(3.0f, 2.0f, 1.0f)), lampAt(vec3(-0.5f, 0.6f, -0.3f), vec3(1.0f), kBakeIndirect)};
    scene.lightNames = {"lamp", "lamp"};
    scene.sky.radiance = vec3(0.1f, 0.2f, 0.4f);
    return scene;
}

static BakeOptions layered()
{
    BakeOptions options = lightmapsOnly(16);
    options.lightLayers = true;
    return options;
}

// Expects the bits of a bake from nothing; returns what share of its rays were traced.
template <typename Change>
static double tracedAfter(Scene scene, Change change, const BakeOptions& options = layered())
{
    const Scene before = scene;
    change(scene);
    const Again made = bakeAgain(before, scene, options);
    EXPECT_EQ(bitsOf(made.again.baked), bitsOf(made.anew.baked));
    EXPECT_EQ(made.again.error(), made.anew.error());
    EXPECT_EQ(made.again.kept() == 1.0, made.again.rays == 0);
    return double(made.again.rays) / double(made.anew.rays);
}

static void dim(Scene& scene)
{
    scene.lights[0].intensity = vec3(0.2f, 5.0f, 0.3f);
    scene.lights[1].intensity *= 7.0f;
    scene.materials[1].emission = vec3(0.1f, 0.1f, 3.0f);
    scene.sky.radiance = vec3(1.0f, 0.0f, 0.0f);
}

TEST(LightLayers, areSummedAnewWithoutARay)
{
    EXPECT_EQ(tracedAfter(lampRoom(), dim), 0.0);
    BakeOptions options = layered();
    options.directional = true;
    options.denoiser = Denoiser::builtin;
    EXPECT_EQ(tracedAfter(lampRoom(), dim, options), 0.0) << "filtered, with directions";
}

// Each layer is traced to the target: the sum is within it, whatever the strengths.
TEST(LightLayers, areSummedAnewWithinAStatedError)
{
    BakeOptions options = layered();
    options.targetError = 0.2f;
    EXPECT_EQ(tracedAfter(lampRoom(), dim, options), 0.0);
    Scene scene = lampRoom();
    EXPECT_LE(make(scene, options).error(), 0.2);
    dim(scene);
    EXPECT_LE(make(scene, options).error(), 0.2);
}

// Four layers, of which one is traced: a moved lamp, recoloured at the same time as all others.
TEST(LightLayers, traceWhatMovedAlone)
{
    const double share = tracedAfter(lampRoom(), [](Scene& scene) {
        scene.lights[0].position.x -= 0.1f;
        scene.lights[0].intensity = vec3(1.0f);
        scene.sky.radiance = vec3(0.3f);
    });
    EXPECT_GT(share, 0.1);
    EXPECT_LT(share, 0.5);
    for (const auto& change : {+[](Scene& s) { s.lights[0].radius = 0.1f; }, +[](Scene& s) { s.lights[0].type = kLightSpot; },
                               +[](Scene& s) { s.lights[0].bake = kBakeIndirect; }}) {
        const double alone = tracedAfter(lampRoom(), change);
        EXPECT_GT(alone, 0.02);
        EXPECT_LT(alone, 0.5);
    }
}

// What a light falls on is in every layer.
TEST(LightLayers, areAllTracedWhenTheLevelIsAnother)
{
    for (const auto& change : {+[](Scene& s) { s.materials[0].baseColor.x = 0.6f; }, +[](Scene& s) { s.objects[1].toWorld[3].x += 0.1; }})
        EXPECT_EQ(tracedAfter(lampRoom(), change), 1.0);
}

TEST(LightLayers, beginWhenALightIsTurnedOn)
{
    Scene off = lampRoom();
    off.lights.pop_back(); // import leaves out what is off
    const double share = tracedAfter(off, [](Scene& scene) { scene.lights = lampRoom().lights; });
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.5);
    EXPECT_EQ(tracedAfter(lampRoom(), [](Scene& scene) { scene.lights.pop_back(); }), 0.0) << "and end when it is turned off";
}

// Names say nothing; lights that are the same but for their colours are one layer of their sum.
TEST(LightLayers, areToldApartByWhatTheyAre)
{
    Scene scene = lampRoom();
    EXPECT_EQ(lightLayers(scene, false).size(), 4u); // two lamps, a block, the sky
    scene.lights.push_back(lampAt(scene.lights[0].position, vec3(0.0f, 1.0f, 0.0f)));
    scene.lights.push_back(lampAt(vec3(0.0f), vec3(1.0f), kBakeNone));
    const std::vector<LightLayer> layers = lightLayers(scene, false);
    ASSERT_EQ(layers.size(), 4u);
    EXPECT_EQ(layers[0].strength, vec3(3.0f, 3.0f, 1.0f));
    EXPECT_EQ(lightLayers(scene, /* directAll= */ true).size(), 5u);
    EXPECT_EQ(tracedAfter(lampRoom(), [](Scene& s) { s.lights.push_back(lampAt(s.lights[0].position, vec3(0.5f))); }), 0.0);
}

// Beyond the bound lights share a layer, as bright as they are.
TEST(LightLayers, areBounded)
{
    Scene scene = lampRoom();
    for (int i = 0; i < 40; i++) scene.lights.push_back(lampAt(vec3(0.01f * float(i), 0.3f, 0.0f), vec3(1.0f, 2.0f, float(i))));
    const std::vector<LightLayer> layers = lightLayers(scene, false);
    ASSERT_EQ(layers.size(), kMostLayers);
    const LightLayer& rest = layers.back();
    EXPECT_EQ(rest.glow.lights.size(), 42 - (kMostLayers - 1));
    EXPECT_EQ(rest.glow.lights.back().intensity, vec3(1.0f, 2.0f, 39.0f));
    EXPECT_EQ(rest.glow.sky, scene.sky.radiance);
    EXPECT_EQ(rest.glow.materials[1], scene.materials[1].emission);
    vec3 sum(0.0f), all(0.0f);
    for (const Light& light : scene.lights) all += light.intensity;
    for (const LightLayer& layer : layers)
        for (const Light& light : layer.glow.lights) sum += layer.strength * light.intensity;
    EXPECT_EQ(sum, all);
}

// Layers and whole light are independent estimates of the same: they differ by what their errors explain.
TEST(LightLayers, sumUpToTheLightOfTheWhole)
{
    BakeOptions options = layered();
    options.samples = 64;
    const Made layers = make(lampRoom(), options);
    options.lightLayers = false;
    const Made whole = make(lampRoom(), options);
    const double both = std::hypot(layers.error(), whole.error());
    EXPECT_NEAR(offBy(layers.baked, whole.baked), both, 0.2 * both);
    EXPECT_LT(layers.error(), whole.error()) << "each light has all the paths";
}

// Noise adds up as independent noise does, and where light comes from by how much of it there is.
TEST(LightLayers, addTheirVarianceAndDirection)
{
    TexelLight layer;
    layer.half[0] = dvec3(8.0), layer.half[1] = dvec3(16.0);
    layer.count[0] = layer.count[1] = 8;
    layer.points = 1;
    layer.squares = 16.0 * (1.5 * 1.5 + 0.5); // of mean 1.5 and variance 0.5
    layer.turn[0] = vec3(24.0f, 0.0f, 0.0f);  // of luminance 1.5 all
    TexelLight few = layer;                   // the same by half the paths
    few.half[0] *= 0.5, few.half[1] *= 0.5, few.squares *= 0.5, few.turn[0] = vec3(0.0f, 12.0f, 0.0f), few.count[0] = few.count[1] = 4;
    TexelLight sum;
    sum.add(layer, vec3(2.0f));
    EXPECT_NEAR(sum.mean().x, 3.0, 1e-6);
    EXPECT_NEAR(sum.variance(), 2.0, 1e-5);
    sum.add(few, vec3(3.0f));
    EXPECT_NEAR(sum.mean().x, 7.5, 1e-6);
    EXPECT_NEAR(sum.variance() / 16.0, 2.0 / 16.0 + 4.5 / 8.0, 1e-5);
    EXPECT_LT(length(vec3(sum.direction()) - vec3(0.4f, 0.6f, 0.0f)), 1e-5f);
    EXPECT_NEAR(sum.halfDifference().x, 0.5 * (2.0 + 3.0) * (1.0 - 2.0), 1e-6);
}

// A light without a channel, and strengths that a float barely holds.
TEST(LightLayers, areFiniteWhateverTheStrength)
{
    EXPECT_EQ(tracedAfter(lampRoom(), [](Scene& s) { s.lights[0].intensity = vec3(1e-30f, 0.0f, 0.0f); }), 0.0);
    for (const float strength : {1e-38f, 1e10f, 1e18f}) {
        Scene scene = lampRoom();
        for (Light& light : scene.lights) light.intensity *= strength;
        scene.materials[1].emission *= strength;
        const Made made = make(scene, layered());
        for (vec3 texel : made.baked.lightmaps[0].texels) ASSERT_TRUE(std::isfinite(texel.x + texel.y + texel.z)) << strength;
    }
}

// Beside the folder: what is gone or damaged there costs time and nothing else.
TEST(LightLayers, lieBesideTheFolder)
{
    const Ground ground("folder");
    Progress silent(ProgressStyle::none);
    BakeOptions options = layered();
    options.force = true; // the level is the same
    const auto bake = [&] {
        bakeLevel("content/truth/lamps.glb", ground.place, options, silent);
        return nlohmann::json::parse(readText(ground.place / "bake.json"));
    };
    const nlohmann::json first = bake();
    const std::filesystem::path file = ground.folder / "level.baked.kept";
    EXPECT_GT(first["rays"], 0);
    EXPECT_GT(first["light_layers"].size(), 1u);
    const Contents kept = readFile(file), page = readFile(ground.place / "lightmap_0.ktx2");
    EXPECT_EQ(bake()["rays"], 0);
    EXPECT_EQ(readFile(file).size(), kept.size());
    for (const std::size_t size : {std::size_t(0), std::size_t(90), kept.size() / 2}) {
        writeFile(file, kept.data(), size);
        EXPECT_EQ(bake()["rays"] > 0, true) << size;
        EXPECT_EQ(readFile(ground.place / "lightmap_0.ktx2"), page);
    }
    options.lightLayers = false;
    EXPECT_FALSE(bake().contains("light_layers"));
    options.lightLayers = true;
    EXPECT_EQ(bake()["rays"], 0) << "a bake without layers leaves it";
}
}
