// Fog against closed forms: the airlight of a sun and of a lamp, and what both lose on their way through air.
#include "tests/engine/effects/foggy.hpp"

namespace afterglow
{
// A sun straight down on a slab 2 cm thick: no light is lost on the way in, L = (sigma_s / sigma_t) p E (1 - exp(-sigma_t D)).
TEST_F(Fog, ASunScattersByThePhaseFunction)
{
    lamp(vec3(0.0f));
    medium(vec3(0.08f), vec3(0.02f), 0.5f, vec3(-99, -0.01f, -99), vec3(99, 0.01f, 99));
    addLight(scene, sunLight(vec3(0, -1, 0), vec3(100.0f)));
    Camera flat = camera;
    flat.fovY = 1e-3f; // the rays stay in the slab for 5 m
    const float wanted = 0.8f * phaseHg(0.5f, 0.0f) * 100.0f * (1.0f - std::exp(-0.5f));
    expectNear(middle(radiance(flat, {.fog = true})), vec3(wanted), 3e-3f);
}

// A lamp 4 m to the side of the wall's middle and 3 m before it: its light crosses 5 m of air, then the 5 m to the eye.
// E = I cos / r^2 exp(-sigma_a r).
TEST_F(Fog, DimsALampOnItsWayToASurface)
{
    addQuad(scene, vec3(-99, -99, -5), vec3(198, 0, 0), vec3(0, 198, 0), addMaterial(scene, matte(vec3(0.64f))));
    addLight(scene, pointLight(vec3(4, 0, -2), vec3(100.0f)));
    const vec3 absorption(0.1f, 0.2f, 0.0f), reflected(0.64f * kInvPi * 100.0f * 0.6f / 25.0f);
    size = {63, 63}; // a pixel whose centre is the axis
    everywhere(vec3(0.0f), absorption, 0.0f);
    expectNear(middle(radiance(camera, {.fog = true})), reflected * exp(-(5.0f + 5.0f) * absorption), 3e-3f);
    // Only between 1 and 3 m to the side: half of the light's way, none of the eye's
    scene.media[0].lower = vec3(1, -99, -99), scene.media[0].upper = vec3(3, 99, 99);
    expectNear(middle(radiance(camera, {.fog = true})), reflected * exp(-2.5f * absorption), 3e-3f);
    expectNear(middle(radiance(camera)), reflected, 3e-3f);
}

// A layer 0.5 m thick above a floor, under a sun at 60 degrees from above: 1 m of it.
TEST_F(Fog, DimsASunByTheLayerThatItCrosses)
{
    addQuad(scene, vec3(-99, -1, 99), vec3(198, 0, 0), vec3(0, 0, -198), addMaterial(scene, matte(vec3(0.64f))));
    addLight(scene, sunLight(vec3(std::sqrt(0.75f), -0.5f, 0), vec3(10.0f)));
    medium(vec3(0.0f), vec3(0.7f), 0.0f, vec3(-99, 3, -99), vec3(99, 3.5f, 99));
    const Camera down = lookAt(vec3(0), vec3(0, -1, 0), 0.02f);
    expectNear(middle(radiance(down, {.fog = true})), vec3(0.64f * kInvPi * 10.0f * 0.5f * std::exp(-0.7f)), 3e-3f);
}

// Chandrasekhar's slab, tau = 1, albedo 0.9, isotropic (H59 with mu = mu0): what a sun is dimmed on its way in, too. Right at one step,
// because both depths run linearly. Values of the closed form for E0 = pi.
TEST_F(Fog, ASunOverASlabIsExactAtAnyStepCount)
{
    struct Row {
        float mu, mu0, reflected, transmitted;
    };
    for (const Row& row : {Row{0.5f, 0.8f, 0.133092802f, 0.09070170817f}, Row{0.5f, 0.5f, 0.1104394906f, 0.06090087746f},
                           Row{0.5f, 0.5000001f, 0.1104395008f, 0.06090088964f}}) {
        scene = {};
        medium(vec3(0.9f), vec3(0.1f), 0.0f, vec3(-1e4f, -1, -1e4f), vec3(1e4f, 0, 1e4f));
        addLight(scene, sunLight(vec3(std::sqrt(1.0f - row.mu0 * row.mu0), -row.mu0, 0), vec3(kPi)));
        const vec3 down(0, -row.mu, -std::sqrt(1.0f - row.mu * row.mu)), up(0, row.mu, down.z);
        for (const uint steps : {1u, 16u}) {
            const DrawnParts parts{.fog = true, .fogParameters = withSteps(steps)};
            expectNear(middle(radiance(lookAt(vec3(0, 2, 0), vec3(0, 2, 0) + down, 1e-3f), parts)), vec3(row.reflected), 2e-3f);
            expectNear(middle(radiance(lookAt(vec3(0, -3, 0), vec3(0, -3, 0) + up, 1e-3f), parts)), vec3(row.transmitted), 2e-3f);
        }
    }
}

// H55: a sun on a wall of fog, a million free paths in 1 m: w p E mu0 / (mu + mu0), square on.
TEST_F(Fog, AWallOfFogShowsItsAlbedoAtAnyStepCount)
{
    medium(vec3(0.5e6f), vec3(0.5e6f), 0.0f, vec3(-99, -99, -9), vec3(99, 99, -2));
    addLight(scene, sunLight(vec3(0, 0, -1), vec3(100.0f)));
    for (const uint steps : {1u, 16u, 64u})
        expectNear(middle(radiance(camera, {.fog = true, .fogParameters = withSteps(steps)})), vec3(0.5f * kInvFourPi * 100.0f * 0.5f),
                   3e-3f);
}

// The airlight integral of a lamp beside the ray: sixteen steps of equal angle, which are 64 over four neighbours. The last row is the hard
// one: 1 cm beside the ray, where steps of equal length are wrong by more than half.
TEST_F(Fog, ALampIsExactFarFromTheRayAndNear)
{
    struct Row {
        float scattering, extinction, along, beside, end, g;
        double value; // for 1 W/sr
    };
    for (const Row& row : {Row{0.08f, 0.1f, 5, 2, 20, 0.0f, 0.003666306671}, Row{0.08f, 0.1f, 5, 2, 20, 0.7f, 0.003444902777},
                           Row{0.01f, 0.01f, 5, 0.01f, 20, 0.9f, 1.493196282}}) {
        scene = {};
        addQuad(scene, vec3(-999, -999, -row.end), vec3(1998, 0, 0), vec3(0, 1998, 0), addMaterial(scene, matte(vec3(0.0f))));
        everywhere(vec3(row.scattering), vec3(row.extinction - row.scattering), row.g);
        addLight(scene, pointLight(vec3(row.beside, 0, -row.along), vec3(100.0f)));
        const Camera narrow = lookAt(vec3(0), vec3(0, 0, -1), 3e-4f);
        size = {15, 15}; // a pixel whose centre is the axis
        expectNear(middle(radiance(narrow, {.fog = true})), vec3(float(100.0 * row.value)), 3e-3f);
    }
}

// H62: the ray goes through the lamp, which is a point, or has a radius. Finite, and brighter the smaller the lamp or the picture's pixels.
TEST_F(Fog, ARayThroughALampIsFinite)
{
    everywhere(vec3(0.05f), vec3(0.0f), 0.0f);
    addLight(scene, pointLight(vec3(0, 0, -3), vec3(1.0f)));
    size = {15, 15};
    const Image point = radiance(camera, {.fog = true});
    scene.lights[0].radius = 0.1f;
    const Image sphere = radiance(camera, {.fog = true});
    EXPECT_TRUE(finite(point) && finite(sphere));
    EXPECT_GT(middle(point).x, 2.0f * middle(sphere).x);
    // Along its axis a sphere's light from all sides adds up to (8 + 4 (pi / 2 - 1)) I / r
    expectNear(middle(sphere), vec3(0.05f * kInvFourPi * (4.0f + kTwoPi) / 0.1f * std::exp(-0.15f)), 0.03f);
    scene.lights[0].position = vec3(0); // in the eye itself
    EXPECT_TRUE(finite(radiance(camera, {.fog = true})));
}

// A lamp inside a body, and one outside of it, light the air by the way through it alone.
TEST_F(Fog, OfABodyDimsALampByTheWayThroughIt)
{
    addQuad(scene, vec3(-99, -99, -5), vec3(198, 0, 0), vec3(0, 198, 0), addMaterial(scene, matte(vec3(0.64f))));
    addLight(scene, pointLight(vec3(0, 3, -1), vec3(100.0f)));
    medium(vec3(0.0f), vec3(0.3f), 0.0f, vec3(-9), vec3(9));
    turnedBox(vec3(2, 2, 0), 1e-3f); // cut away but for a sliver that the light does not cross
    size = {63, 63};
    const vec3 clear = middle(radiance(camera));
    expectNear(middle(radiance(camera, {.fog = true})), clear, 3e-3f);
    scene.media[0].planeCount = 0;
    expectNear(middle(radiance(camera, {.fog = true})), clear * std::exp(-0.3f * 10.0f), 5e-3f);
}
}
