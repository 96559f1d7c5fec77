// Fog against closed forms: dimming, airlight from everywhere and from a sun, the sky behind it, and none at all.
#include "shaders/phase.h"
#include "tests/engine/effects/drawn.hpp"

namespace afterglow
{
class Fog : public Drawn
{
protected:
    void medium(vec3 scattering, vec3 absorption, float g, vec3 lower, vec3 upper)
    {
        Medium m{};
        m.scattering = scattering, m.absorption = absorption, m.g = g, m.lower = lower, m.upper = upper;
        scene.media.push_back(m);
    }
    void everywhere(vec3 scattering, vec3 absorption, float g) { medium(scattering, absorption, g, vec3(-INFINITY), vec3(INFINITY)); }
    // A lamp across the view, 5 m away.
    void lamp(vec3 emission)
    {
        Material m = matte(vec3(0.0f));
        m.emission = emission;
        addQuad(scene, vec3(-99, -99, -5), vec3(198, 0, 0), vec3(0, 198, 0), addMaterial(scene, m));
    }
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1), 0.02f); // narrow: every ray is 5 m long
};

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
    baked.probes.push_back(evenProbes(vec3(-3), vec3(3), vec3(0.5f)));
    expectNear(middle(radiance(camera, {.fog = true})), vec3(0.5f * (1.0f - std::exp(-1.0f))), 3e-3f);
}
}
