// Fog against closed forms: dimming, glow, airlight from everywhere, the sky behind it, the borders of its bodies, and none at all.
#include "tests/engine/effects/foggy.hpp"

namespace afterglow
{
// C22: any step count gives (sigma_s / sigma_t) L (1 - exp(-sigma_t D)) + exp(-sigma_t D) behind.
TEST_F(Fog, AConstantSurroundingIsExactAtAnyStepCount)
{
    scene.sky.radiance = vec3(0.5f, 1.0f, 2.0f);
    lamp(vec3(3.0f));
    everywhere(vec3(0.16f), vec3(0.04f, 0.14f, 0.04f), 0.6f);
    for (const uint steps : {1u, 16u}) {
        FogParameters p = defaultFogParameters();
        p.steps = steps;
        const vec3 sigmaT(0.2f, 0.3f, 0.2f), left = exp(-5.0f * sigmaT);
        expectNear(middle(radiance(camera, {.fog = true, .fogParameters = p})),
                   3.0f * left + scene.sky.radiance * (0.16f / sigmaT) * (vec3(1.0f) - left), 3e-3f);
    }
}

// H61, H65: the sky lies at infinity; a medium that fills everything hides it and shows its own albedo.
TEST_F(Fog, HidesTheSkyWhenItFillsEverything)
{
    scene.sky.radiance = vec3(2.0f);
    everywhere(vec3(0.3f), vec3(0.1f), 0.0f);
    expectNear(middle(radiance(camera, {.fog = true})), vec3(2.0f * 0.75f), 3e-3f);
}

TEST_F(Fog, OfABoxDimsTheSkyByTheBoxAlone)
{
    scene.sky.radiance = vec3(1.0f);
    medium(vec3(0.0f), vec3(0.25f), 0.0f, vec3(-9, -9, -6), vec3(9, 9, -2)); // absorbs, scatters nothing
    expectNear(middle(radiance(camera, {.fog = true})), vec3(std::exp(-1.0f)), 3e-3f);
}

TEST_F(Fog, BehindTheEyeDoesNothing)
{
    scene.sky.radiance = vec3(1.0f);
    medium(vec3(9.0f), vec3(9.0f), 0.0f, vec3(-9, -9, 2), vec3(9, 9, 6));
    expectNear(middle(radiance(camera, {.fog = true})), vec3(1.0f), 1e-3f);
}

TEST_F(Fog, OverlappingMediaAddUp)
{
    lamp(vec3(1.0f));
    medium(vec3(0.0f), vec3(0.1f), 0.0f, vec3(-99), vec3(99));
    medium(vec3(0.0f), vec3(0.3f), 0.0f, vec3(-99, -99, -3), vec3(99));
    expectNear(middle(radiance(camera, {.fog = true})), vec3(std::exp(-5.0f * 0.1f - 3.0f * 0.3f)), 3e-3f);
}

// H53: a medium of nothing leaves every bit as it was.
TEST_F(Fog, OfZeroDensityChangesNothing)
{
    scene.sky.radiance = vec3(0.3f, 0.7f, 1.9f);
    addQuad(scene, vec3(-1, -1, -3), vec3(2, 0, 0), vec3(0, 2, 0), addMaterial(scene, matte(vec3(0.5f))));
    everywhere(vec3(0.0f), vec3(0.0f), 0.3f);
    const Camera wide = lookAt(vec3(0), vec3(0, 0, -1));
    EXPECT_EQ(radiance(wide).pixels, radiance(wide, {.fog = true}).pixels);
}

// The probes know the air of a room; where their box ends before the wall, the sky outside does not light the fog.
TEST_F(Fog, OutsideOfTheProbesTheirBorderHolds)
{
    scene.sky.radiance = vec3(1000.0f);
    lamp(vec3(0.0f));
    medium(vec3(0.2f), vec3(0.0f), 0.0f, vec3(-9), vec3(9));
    baked.probes = evenProbes(vec3(-3), vec3(3), vec3(0.5f));
    expectNear(middle(radiance(camera, {.fog = true})), vec3(0.5f * (1.0f - std::exp(-1.0f))), 3e-3f);
}

// Air on either side of a plane has the light of its own cell.
TEST_F(Fog, IsLitByTheCellThatItIsIn)
{
    lamp(vec3(0.0f));
    medium(vec3(0.2f), vec3(0.0f), 0.0f, vec3(-9), vec3(9));
    baked.probes = evenProbes(vec3(-9), vec3(9), vec3(4.0f));
    append(baked.probes, evenProbes(vec3(-9), vec3(9), vec3(0.5f)));
    baked.probes.nodes = {{vec3(0, 0, 1), -2.5f, ~0, ~1}}; // half of the way to the wall, where a step of the march ends
    const float half = std::exp(-0.5f);
    expectNear(middle(radiance(camera, {.fog = true})), vec3(0.5f * (1.0f - half) + 4.0f * half * (1.0f - half)), 3e-3f);
}

// Glow: e / sigma (1 - exp(-sigma d)), e d where nothing is dimmed, and of two media one behind the other.
TEST_F(Fog, SendsOutLightByItself)
{
    lamp(vec3(1.0f));
    medium(vec3(0.0f), vec3(0.2f, 0.0f, 0.6f), 0.0f, vec3(-9, -9, -3), vec3(9, 9, -1));
    scene.media[0].emission = vec3(0.5f, 0.25f, 0.0f);
    const vec3 through = exp(-2.0f * scene.media[0].absorption);
    const vec3 glow(0.5f / 0.2f * (1.0f - through.x), 0.25f * 2.0f, 0.0f);
    expectNear(middle(radiance(camera, {.fog = true})), through + glow, 3e-3f);
    medium(vec3(0.0f), vec3(0.7f), 0.0f, vec3(-9), vec3(9, 9, -2)); // over the far half of the first, and before the eye behind it
    scene.media[1].lower.z = -9;
    const float half = std::exp(-0.7f);
    const vec3 near_(0.5f / 0.2f * (1.0f - std::exp(-0.2f)), 0.25f, 0.0f);
    const vec3 far_(0.5f / 0.9f * (1.0f - std::exp(-0.9f)), 0.25f / 0.7f * (1.0f - half), 0.0f);
    expectNear(middle(radiance(camera, {.fog = true})), through * half * half * half + near_ + far_ * vec3(std::exp(-0.2f), 1.0f, 1.0f),
               3e-3f);
}

// A convex body that is no box along the axes: 2 sqrt(2) m through its middle, and nothing past its edge, where the box around it lies.
TEST_F(Fog, FillsAConvexBodyAndNotTheBoxAroundIt)
{
    lamp(vec3(1.0f));
    medium(vec3(0.0f), vec3(0.5f), 0.0f, vec3(-9), vec3(9));
    turnedBox(vec3(0), 1.0f);
    const float side = std::sqrt(2.0f);
    for (const float y : {0.0f, 0.7f, 1.5f}) {
        const Camera across = lookAt(vec3(-4, y, -2), vec3(0, y, -2), 0.02f);
        scene.objects.clear();
        addQuad(scene, vec3(9, -99, -99), vec3(0, 0, 198), vec3(0, 198, 0), 0u);
        expectNear(middle(radiance(across, {.fog = true})), vec3(std::exp(-0.5f * 2.0f * std::max(side - y, 0.0f))), 3e-3f);
    }
}

// H64: on a border, on both sides of it, and in a medium within a medium the picture is continuous.
TEST_F(Fog, ABorderThroughTheEyeChangesNothing)
{
    scene.sky.radiance = vec3(1.0f);
    lamp(vec3(2.0f));
    medium(vec3(0.1f), vec3(0.1f), 0.3f, vec3(-9), vec3(9));
    medium(vec3(0.2f), vec3(0.0f), 0.0f, vec3(-3, -3, -4), vec3(3, 3, 0));
    medium(vec3(0.2f), vec3(0.1f), 0.0f, vec3(-3, -3, -4), vec3(3, 3, -2)); // shares three borders with the one before
    addLight(scene, pointLight(vec3(1, 1, -2), vec3(5.0f)));
    const vec3 on = middle(radiance(camera, {.fog = true}));
    for (const float z : {-1e-4f, 1e-4f}) {
        const Camera moved = lookAt(vec3(0, 0, z), vec3(0, 0, -1), 0.02f);
        expectNear(middle(radiance(moved, {.fog = true})), on, 2e-3f);
    }
}

// H56 to H58: any g, and a medium so thin that 1 - exp(-x) is 0 in floats (H54).
TEST_F(Fog, IsFiniteForAnyPhaseAndAnyDensity)
{
    lamp(vec3(1.0f));
    addLight(scene, sunLight(vec3(0, 0, 1), vec3(3.0f))); // against the view: straight ahead for the phase function
    addLight(scene, pointLight(vec3(0, 0.5f, -2), vec3(3.0f)));
    everywhere(vec3(0.1f), vec3(0.0f), 0.0f);
    scene.media[0].lower = vec3(-9), scene.media[0].upper = vec3(9);
    const float isotropic = middle(radiance(camera, {.fog = true})).x;
    for (const float g : {1e-7f, -1e-7f, 0.999f, -0.999f, 1.0f, -1.0f}) {
        scene.media[0].g = g;
        const Image picture = radiance(camera, {.fog = true});
        EXPECT_TRUE(finite(picture)) << "g " << g;
        if (std::abs(g) < 0.5f) expectNear(middle(picture), vec3(isotropic), 1e-3f);
    }
    scene.media[0].g = 0.0f;
    for (const float density : {1e-12f, 1e-30f, 1e6f, 1e18f}) {
        scene.media[0].scattering = vec3(density);
        const Image picture = radiance(camera, {.fog = true});
        EXPECT_TRUE(finite(picture)) << density;
        if (density < 1.0f) expectNear(middle(picture), vec3(1.0f), 1e-3f);
    }
}

// Light shafts of a grating: what a march of few steps misses, frames make up for while the eye holds still; eight frames are nearer to
// a march of 256 steps than one, and a moved eye sees what a new one does.
TEST_F(Fog, FramesAddUpToMoreSteps)
{
    size = {48, 48};
    const uint black = addMaterial(scene, matte(vec3(0.0f)));
    addQuad(scene, vec3(-9, -9, -8), vec3(18, 0, 0), vec3(0, 18, 0), black);
    for (int i = -6; i < 6; ++i) addQuad(scene, vec3(-4, 2.5f, float(i) - 2.0f), vec3(8, 0, 0), vec3(0, 0, -0.5f), black);
    medium(vec3(0.2f), vec3(0.0f), 0.0f, vec3(-4, -3, -8), vec3(4, 3, 4));
    addLight(scene, sunLight(vec3(0, -1, -0.4f), vec3(30.0f)));
    const Camera eye = lookAt(vec3(0), vec3(0, 0.1f, -1)), aside = lookAt(vec3(0.05f, 0, 0), vec3(0.05f, 0.1f, -1));
    DrawnParts parts{.shadow = true, .fog = true, .fogParameters = withSteps(4)};
    const auto rmse = [](const Image& a, const Image& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += double(a.pixels[i] - b.pixels[i]) * double(a.pixels[i] - b.pixels[i]);
        return std::sqrt(sum / double(a.pixels.size()));
    };
    DrawnParts many = parts;
    many.fogParameters.steps = 256;
    const Image truth = radiance(eye, many);
    const Image one = radiance(eye, parts);
    parts.fogRemembers = true;
    Image eight;
    for (int frame = 0; frame < 8; ++frame) eight = radiance(eye, parts);
    EXPECT_LT(rmse(eight, truth), 0.5 * rmse(one, truth)) << rmse(one, truth) << " in one frame";
    const Image moved = radiance(aside, parts);
    EXPECT_LT(rmse(moved, radiance(aside, many)), 1.5 * rmse(one, truth));
}

// A post before a far wall: at half and quarter resolution its air and the wall's stay apart, within 2 % of what full resolution shows.
TEST_F(Fog, AtALowerResolutionSilhouettesHaveNoHalo)
{
    size = {96, 64};
    scene.sky.radiance = vec3(1.0f);
    const uint black = addMaterial(scene, matte(vec3(0.0f)));
    addQuad(scene, vec3(-99, -99, -20), vec3(198, 0, 0), vec3(0, 198, 0), black);
    addQuad(scene, vec3(-0.3f, -9, -3), vec3(0.6f, 0, 0), vec3(0, 18, 0), black);
    medium(vec3(0.05f), vec3(0.0f), 0.0f, vec3(-99, -99, -99), vec3(99, 99, 9));
    const Camera eye = lookAt(vec3(0), vec3(0, 0, -1));
    DrawnParts parts{.fog = true};
    parts.fogParameters.divisor = 1;
    const Image full = radiance(eye, parts);
    for (const uint divisor : {2u, 4u}) {
        parts.fogParameters.divisor = divisor;
        EXPECT_LT(apart(radiance(eye, parts), full), 0.02f * full.at(0, 0)[0]) << "1 / " << divisor;
    }
}
}
