// The filter of what few rays leave, on penumbras and on contact whose closed forms are known, and by the number of rays.
#include "shaders/penumbra.h"
#include "tests/engine/effects/lit_share.hpp"

namespace afterglow
{
class DenoisedShadow : public LitShare
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }
    Image litShare(const Camera& camera, uint denoise, uint rays = 8)
    {
        ShadowParameters parameters = defaultShadowParameters();
        parameters.rays = rays;
        parameters.denoise = denoise;
        return litShareOf(camera, {.shadow = true, .shadowMethod = ShadowMethod::ray, .shadowParameters = parameters});
    }
    // An edge along z at x = 0, `height` m above the floor, under a sun of 4 degrees at the zenith.
    void edgeUnderASun(float height)
    {
        floor();
        addQuad(scene, vec3(-5, height, -5), vec3(0, 0, 10), vec3(5, 0, 0), grey());
        Light sun = sunLight(vec3(0, -1, 0), vec3(3.0f));
        sun.sinAngle = std::sin(2.0f * kPi / 180.0f);
        addLight(scene, sun);
        size = {64, 64};
    }
};

// shadow.penumbra_profile: the penumbra is 45 pixels wide. Pixels share a sequence, so that the picture's mean is one lot a frame.
TEST_F(DenoisedShadow, IsNearerToThePenumbraOfADiscBehindAnEdge)
{
    constexpr int kFrames = 8;
    edgeUnderASun(1.0f);
    const Camera camera = lookAt(vec3(0, 0.5f, 0), vec3(0), 0.2f);
    const float radius = std::tan(2.0f * kPi / 180.0f), half = 0.5f * std::tan(0.1f);
    const auto wanted = [&](int x) { return penumbra(((float(x) + 0.5f) / 32.0f - 1.0f) * half / radius); };
    const auto errors = [&](const Image& lit) { // mean, and mean square
        dvec2 sum(0.0);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const float share = lit.at(x, y)[0];
                EXPECT_TRUE(share >= 0.0f && share <= 1.0f + 1e-3f) << share;
                const double off = double(share - wanted(x));
                sum += dvec2(off, off * off);
            }
        return sum / 4096.0;
    };
    const double raw = std::sqrt(errors(litShare(camera, 0)).y);
    double square = 0, shift = 0, shifts = 0;
    for (frame = 0; frame < kFrames; ++frame) {
        const dvec2 e = errors(litShare(camera, 1)) / double(kFrames);
        shift += e.x, square += e.y, shifts += e.x * e.x * kFrames;
    }
    std::printf("penumbra of 45 px, 8 rays: RMSE %.4f, filtered %.4f, mean off by %.4f\n", raw, std::sqrt(square), shift);
    EXPECT_LE(std::sqrt(square), 0.6 * raw);
    EXPECT_NEAR(shift, 0.0, 4.0 * std::sqrt((shifts - shift * shift) / (kFrames - 1)) + 0.5 / 255.0);
}

// 2 cm above the floor the penumbra is narrower than a pixel: no pixel but those that hold it is other than light or dark.
TEST_F(DenoisedShadow, StaysSharpAtContact)
{
    edgeUnderASun(0.02f);
    const Image lit = litShare(lookAt(vec3(0, 1, 3), vec3(0), 0.4f), 1);
    for (int y = 0; y < 64; ++y) {
        int between = 0;
        for (int x = 0; x < 64; ++x) between += lit.at(x, y)[0] > 0.05f && lit.at(x, y)[0] < 0.95f;
        EXPECT_LE(between, 2) << y;
    }
}

// A board 3 cm under the edge and 2 beside it is lit, over a floor in the penumbra: it takes nothing of that.
TEST_F(DenoisedShadow, KeepsToASurface)
{
    edgeUnderASun(1.0f);
    addQuad(scene, vec3(0.02f, 0.97f, -0.01f), vec3(0, 0, 0.02f), vec3(0.01f, 0, 0), grey());
    const Camera camera = lookAt(vec3(0.02f, 1.5f, 0), vec3(0.02f, 0, 0), 0.05f);
    const Image lit = litShare(camera, 1);
    int board = 0, between = 0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const vec2 at = ((vec2(x, y) + 0.5f) / 32.0f - 1.0f) * (0.53f * std::tan(0.025f)); // on the board's plane, from the middle
            const bool on = at.x > 0.0f && at.x < 0.01f && std::abs(at.y) < 0.01f;
            const float share = lit.at(x, y)[0];
            board += on, between += !on && share > 0.05f && share < 0.95f;
            if (on) {
                EXPECT_GT(share, 0.999f) << x << ' ' << y;
            }
        }
    EXPECT_GT(board, 500);
    EXPECT_GT(between, 500);
}

// Bit by bit: rays to a point agree, and those that a veil dims alike.
TEST_F(DenoisedShadow, ChangesNothingWhereTheRaysAgree)
{
    floor();
    addQuad(scene, vec3(-1, 1, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
    addLight(scene, pointLight(vec3(0.3f, 4, 0.2f), vec3(30.0f)));
    size = {64, 64};
    const Camera camera = lookAt(vec3(0, 0.8f, 6), vec3(0), 0.9f);
    EXPECT_EQ(litShare(camera, 1).pixels, litShare(camera, 0).pixels);
}

class DenoisedContact : public Drawn
{
};

// ao.wall_range: a wall at a distance of t ranges hides 1 - penumbra(t). At the picture's own resolution, 8 rays; and a floor in the open
// stays 1.
TEST_F(DenoisedContact, IsNearerToTheWallsClosedForm)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    addQuad(scene, vec3(-50, 0, -50), vec3(0, 0, 100), vec3(100, 0, 0), addMaterial(scene, matte(vec3(0.64f))));
    addQuad(scene, vec3(0, 0, -50), vec3(0, 50, 0), vec3(0, 0, 100), 0);
    size = {64, 64};
    OcclusionParameters parameters = defaultOcclusionParameters();
    parameters.divisor = 1, parameters.smooth_ = 0;
    const Camera camera = lookAt(vec3(0.8f, 2, 0), vec3(0.8f, 0, 0), 0.38f); // 0.4 m to both sides: x from 0.4 to 1.2 m
    const float half = 2.0f * std::tan(0.19f);
    double error[2] = {};
    for (const uint denoise : {0u, 1u}) {
        parameters.denoise = denoise;
        const Image open = visibility(camera, OcclusionMethod::ray, parameters);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const float at = 0.8f + ((float(x) + 0.5f) / 32.0f - 1.0f) * half;
                if (at < 1.0f)
                    error[denoise] += std::pow(double(open.at(x, y)[0] - penumbra(at)), 2);
                else if (at > 1.1f) {
                    EXPECT_EQ(open.at(x, y)[0], 1.0f) << "out of reach";
                }
            }
    }
    std::printf("wall, 8 rays: squared error %.4f, filtered %.4f\n", error[0], error[1]);
    EXPECT_LE(error[1], 0.25 * error[0]);
}
}
