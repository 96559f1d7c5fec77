// Light in steps: bands of a sphere, one tone for shadow and for what is turned away, edges of one class on both sides, rungs of a lamp.
#include "shaders/camera.h"
#include "tests/engine/effects/drawn.hpp"
#include "tests/engine/upload/solids.hpp"
#include <algorithm>
#include <cstring>
#include <limits>

namespace afterglow
{
class Toon : public Drawn
{
protected:
    Toon()
    {
        parts.toon = true;
        parts.shadow = true;
        scene.display.toon = true;
        grey = addMaterial(scene, matte(vec3(0.8f)));
    }

    // The values of the red channel that at least so many pixels share, from the darkest on; they differ by more than `apart` of the
    // brightest.
    static std::vector<float> tones(const Image& image, std::size_t pixels, float apart = 1e-3f)
    {
        std::vector<float> all;
        for (std::size_t i = 0; i < image.pixels.size(); i += 4) all.push_back(image.pixels[i]);
        std::sort(all.begin(), all.end());
        std::vector<float> found;
        for (std::size_t i = 0, next = 0; i < all.size(); i = next) {
            for (next = i; next < all.size() && all[next] - all[i] <= apart * all.back();) ++next;
            if (next - i >= pixels) found.push_back(all[i]);
        }
        return found;
    }

    uint grey = 0;
    DrawnParts parts;
};

// A sun from aside shows every response from 0 to 1 on a sphere: as many tones as steps, each as bright as the ramp says.
TEST_F(Toon, ASphereHasAsManyBandsAsSteps)
{
    size = {96, 96};
    scene.sky.radiance = vec3(0.0f);
    addSphere(scene, grey, 64);
    addLight(scene, sunLight(vec3(-1, 0, -0.4f), vec3(2.0f)));
    for (const uint steps : {1u, 2u, 3u, 5u}) {
        parts.toonParameters.steps = steps;
        const Image image = radiance(lookAt(vec3(0, 0, 2.3f), vec3(0)), parts);
        const std::vector<float> found = tones(image, 40);
        std::vector<float> wanted{0.0f}; // the sky, and the first step
        for (uint i = steps > 1 ? 1 : 0; i < steps; ++i)
            wanted.push_back(0.8f * kInvPi * 2.0f * (steps > 1 ? float(i) / float(steps - 1) : 1.0f));
        ASSERT_EQ(found.size(), wanted.size()) << steps << " steps";
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], wanted[i], 4e-3f * wanted.back()) << "step " << i << " of " << steps;
    }
}

// A roof under a sun that one side faces and the other catches at 0.36, just above an edge of the ramp: within the texels of the map that
// hold both sides neither side shades the other, for both have one tone up to the ridge.
TEST_F(Toon, ARidgeLeavesBothSidesTheirTone)
{
    size = {64, 64};
    addQuad(scene, vec3(-2, -2, 2), vec3(2, 2, 0), vec3(0, 0, -4), grey);
    addQuad(scene, vec3(0, 0, 2), vec3(2, -2, 0), vec3(0, 0, -4), grey);
    addLight(scene, sunLight(vec3(0.405f, -0.914f, 0.03f), vec3(2.0f)));
    const Image image = radiance(lookAt(vec3(0.3f, 3, 0.2f), vec3(0), 0.05f), parts);
    const float half = 0.8f * kInvPi * 2.0f * 0.5f;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) EXPECT_GE(image.pixels[i], 0.99f * half) << "pixel " << i / 4;
}

// What a board shades and what is turned away read the same, to the bit; and neither has a penumbra of other tones.
TEST_F(Toon, ShadowAndTurnedAwayAreOneTone)
{
    size = {64, 64};
    scene.display.toonRamp = {{vec3(0.25f), 0.0f}, {vec3(1.0f), 0.5f}};
    addQuad(scene, vec3(-4, 0, -4), vec3(0, 0, 8), vec3(8, 0, 0), grey);    // a floor
    addQuad(scene, vec3(-1, 1.5f, -1), vec3(2, 0, 0), vec3(0, 0, 2), grey); // a board whose front looks down
    addLight(scene, sunLight(vec3(0.1f, -1, 0.05f), vec3(3.0f)));
    const Image image = radiance(lookAt(vec3(0, 0.5f, 4), vec3(0, 0.5f, 0), 1.2f), parts);
    // By hand: the board's underside above, its shadow below, lit floor at the side
    const auto value = [&](vec3 p) {
        const vec4 clip = makeView(lookAt(vec3(0, 0.5f, 4), vec3(0, 0.5f, 0), 1.2f), size).worldToClip * vec4(p, 1.0f);
        const vec2 pixel = ndcToUv(vec2(clip) / clip.w) * vec2(size);
        return image.at(int(pixel.x), int(pixel.y))[0];
    };
    const float dark = 0.8f * kInvPi * 3.0f * 0.25f;
    EXPECT_NEAR(value(vec3(0, 1.5f, 0.6f)), dark, 2e-3f * dark);
    EXPECT_EQ(value(vec3(0, 0, 0.3f)), value(vec3(0, 1.5f, 0.6f)));
    EXPECT_NEAR(value(vec3(-2, 0, 0.3f)), 4.0f * dark, 8e-3f * dark);
}

// A floor that answers just below an edge of the ramp: its shadow's blurred border is no brighter than it.
TEST_F(Toon, AShadowHasNoHalo)
{
    size = {64, 64};
    scene.display.toonRamp = {{vec3(0.25f), 0.0f}, {vec3(0.5f), 0.3f}, {vec3(1.0f), 0.65f}};
    addQuad(scene, vec3(-4, 0, -4), vec3(0, 0, 8), vec3(8, 0, 0), grey);
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey); // a board, above the eye
    addLight(scene, sunLight(vec3(0.8f, -0.6f, 0.0f), vec3(3.0f)));
    const Image image = radiance(lookAt(vec3(1.3f, 0.9f, 0.01f), vec3(1.3f, 0, 0), 1.6f), parts);
    const float lit = 0.8f * kInvPi * 3.0f * 0.5f;
    int dark = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        EXPECT_LE(image.pixels[i], 1.002f * lit) << i;
        dark += image.pixels[i] < 0.51f * lit;
    }
    EXPECT_GT(dark, 500);
}

// H75: on an edge, a step of the last bit to either side, infinite, not a number: one class, the same by both compilers.
TEST_F(Toon, EdgesBelongToOneClassOnBothSides)
{
    struct Question {
        float response, edge, width;
    };
    std::vector<Question> questions;
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    for (uint steps = 1; steps <= 64; ++steps)
        for (uint i = 1; i < steps; ++i) {
            const float edge = evenToonStep(i, steps).edge;
            EXPECT_EQ(toonShare(edge, edge, 0.0f), 1.0f);
            EXPECT_EQ(toonShare(std::nextafter(edge, 2.0f), edge, 0.0f), 1.0f);
            EXPECT_EQ(toonShare(std::nextafter(edge, -1.0f), edge, 0.0f), 0.0f);
            for (const float width : {0.0f, 1e-6f, 0.02f, 0.5f, nan, infinite})
                for (const float response : {edge, std::nextafter(edge, 2.0f), std::nextafter(edge, -1.0f), 0.0f, 1.0f, nan, infinite})
                    questions.push_back({response, edge, width});
        }
    Graph graph;
    const Buffer asked = graph.upload("questions", std::span<const Question>(questions));
    const Buffer answers = graph.buffer("answers", questions.size() * sizeof(float));
    graph.compute("ask", "tests/engine/effects/shaders/toon_share.comp").read(asked).write(answers).dispatch(uvec2(questions.size(), 1));
    graph.output(answers);
    executor.run(graph);
    const std::vector<std::uint8_t> bytes = executor.download(answers);
    int wrong = 0;
    for (std::size_t i = 0; i < questions.size(); ++i) {
        float answer;
        std::memcpy(&answer, &bytes[i * sizeof(float)], sizeof(float));
        const Question& q = questions[i];
        const float here = toonShare(q.response, q.edge, q.width);
        const bool smooth = q.width == 0.02f; // a division: to the last bits
        if (std::isnan(q.response) && !smooth) {
            EXPECT_EQ(here, 0.0f);
        }
        wrong += smooth && !std::isnan(q.response) ? !(std::abs(answer - here) < 1e-5f) : smooth ? 0 : answer != here;
    }
    EXPECT_EQ(wrong, 0);
}

// A wall whose response is an edge of the ramp, seen askew, is one tone: no speckle.
TEST_F(Toon, AWallOnAnEdgeIsOneTone)
{
    size = {64, 64};
    scene.display.toonRamp = {{vec3(0.0f), 0.0f}, {vec3(1.0f), 0.5f}};
    addQuad(scene, vec3(-9, -9, -3), vec3(18, 0, 0), vec3(0, 18, 0), grey);
    addLight(scene, sunLight(vec3(-std::sqrt(3.0f), 0, -1), vec3(1.0f))); // cosine 1/2, give or take a bit
    parts.shadow = false;
    EXPECT_EQ(tones(radiance(lookAt(vec3(1, 0.3f, 0), vec3(0, 0, -3), 0.4f), parts), 64 * 64, 0.0f).size(), 1u);
}

// The light of a lamp falls on rungs of a factor of two, rings on the floor, however the floor lies.
TEST_F(Toon, ALampFallsInRings)
{
    size = {96, 96};
    scene.display.toonRamp = {{vec3(1.0f), 0.0f}};
    addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), grey);
    addLight(scene, pointLight(vec3(0, 1, 0), vec3(5.0f)));
    const Image image = radiance(lookAt(vec3(0, 6, 0), vec3(0), 1.2f), parts);
    int onRung = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
        const float rung = std::log2(image.pixels[i] / (0.8f * kInvPi)) - 0.5f;
        onRung += std::abs(rung - std::round(rung)) < 0.01f;
    }
    EXPECT_GT(onRung, 96 * 96 * 8 / 10);                                  // the rest is the smooth edge of a ring
    EXPECT_NEAR(middle(image).x, 0.8f * kInvPi * std::exp2(2.5f), 0.01f); // 5 / 1 m^2 lies between 4 and 8
    EXPECT_EQ(tones(image, 60).size(), 6u);                               // 5 / d^2 from 5 down to 5 / (1 + 2 * 4.1^2) = 0.14
}

// Baked light keeps its shape in rungs, its colour exactly.
TEST_F(Toon, BakedLightFallsOnRungs)
{
    addQuad(scene, vec3(-9, -9, -3), vec3(18, 0, 0), vec3(0, 18, 0), grey);
    baked = bakedEvenly(scene, vec3(0.3f, 0.15f, 0.6f));
    const vec3 seen = middle(radiance(lookAt(vec3(0), vec3(0, 0, -1)), parts));
    expectNear(seen, vec3(0.5f, 0.25f, 1.0f) * 0.8f * std::exp2(-0.5f), 1e-2f); // 0.6 lies between 1/2 and 1
}

// A ramp of one material, and a material that will have none.
TEST_F(Toon, MaterialsMaySayOtherwise)
{
    const uint other = addMaterial(scene, matte(vec3(0.8f)));
    addQuad(scene, vec3(-9, -9, -3), vec3(9, 0, 0), vec3(0, 18, 0), grey);
    addQuad(scene, vec3(0, -9, -3), vec3(9, 0, 0), vec3(0, 18, 0), other);
    addLight(scene, sunLight(vec3(0, -0.6f, -0.8f), vec3(1.0f)));
    parts.shadow = false;
    const Camera camera = lookAt(vec3(0), vec3(0, 0, -1));
    const auto both = [&] {
        const Image image = radiance(camera, parts);
        return vec2(image.at(2, 8)[0], image.at(13, 8)[0]) / (0.8f * kInvPi);
    };
    scene.toonRamps[other] = {};
    expectNear(vec3(both(), 0), vec3(1.0f, 0.8f, 0), 5e-3f);
    scene.display.toon = false;
    scene.toonRamps[other] = {{vec3(0.1f), 0.0f}, {vec3(0.3f), 0.79f}, {vec3(0.7f), 0.81f}};
    expectNear(vec3(both(), 0), vec3(0.8f, 0.3f, 0), 5e-3f);
}

// A highlight is a disc of one brightness.
TEST_F(Toon, AHighlightIsAStep)
{
    size = {96, 96};
    Material glossy = matte(vec3(0.0f));
    glossy.flags = 0;
    glossy.roughness = 0.4f;
    scene.display.toonRamp = {{vec3(0.0f), 0.0f}, {vec3(1.0f), 0.1f}};
    addSphere(scene, addMaterial(scene, glossy), 64);
    addLight(scene, sunLight(vec3(-0.3f, -0.3f, -1), vec3(2.0f)));
    const std::vector<float> found = tones(radiance(lookAt(vec3(0, 0, 2.3f), vec3(0)), parts), 25);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], 0.0f);
    EXPECT_NEAR(found[1], 2.0f * 0.04f * toonHighlightRadiance(0.16f), 0.02f * found[1]);
}
}
