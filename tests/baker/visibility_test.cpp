// The truth of ambient occlusion: cosine-weighted visibility within a range by rays, against closed forms.
#include "baker/baker.hpp"
#include "tests/engine/upload/toy_level.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
class Visibility : public testing::Test
{
protected:
    Visibility() { addMaterial(scene, matte(vec3(0.5f))); }
    void floor() { addQuad(scene, vec3(-99, 0, -99), vec3(0, 0, 198), vec3(198, 0, 0), 0); }
    // From the floor at x = 0 along z, at an angle to the floor's half with x < 0, `length` m far.
    void slope(float degrees, float length)
    {
        const float angle = degrees * kPi / 180.0f;
        addQuad(scene, vec3(0, 0, 99), vec3(0, 0, -198), length * vec3(-std::cos(angle), std::sin(angle), 0), 0);
    }
    void pit(float depth)
    {
        addQuad(scene, vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), 0);
        for (const vec3 side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
            const vec3 along = cross(vec3(0, 1, 0), side);
            addQuad(scene, side - along, 2.0f * along, vec3(0, depth, 0), 0);
        }
    }
    // Of the floor at x, seen from 1 mm above it: the pixels' mean, four standard errors wide.
    void expectOpen(float x, float range, double value)
    {
        TruthOptions options;
        options.camera = lookAt(vec3(x, 1e-3f, 0), vec3(x, 0, 0), 1e-2f);
        options.camera.nearPlane = 1e-5f;
        options.size = ivec2(16, 16);
        options.samples = 256;
        options.ao = true;
        options.aoRange = range;
        Progress silent(ProgressStyle::none);
        const Image image = truth(scene, options, silent);
        double sum = 0, squares = 0;
        for (int i = 0; i < 256; ++i) {
            const double open = double(image.pixels[std::size_t(i) * 3]);
            sum += open, squares += open * open;
        }
        const double mean = sum / 256, error = std::sqrt(std::max(squares / 256 - mean * mean, 0.0) / 255);
        EXPECT_NEAR(mean, value, 4 * error + 1e-5) << "x " << x << ", range " << range;
    }
    Scene scene;
};

// At the edge of two endless planes: (1 - cos theta) / 2.
TEST_F(Visibility, AtTheEdgeOfAWedge)
{
    for (const auto& [degrees, value] : {std::pair(60.0f, 0.25), {90.0f, 0.5}, {135.0f, 0.8535533906}}) {
        scene.objects.clear(), scene.meshes.clear(), scene.vertices.clear(), scene.indices.clear();
        floor();
        slope(degrees, 99);
        expectOpen(-0.01f, 90.0f, value);
    }
}

// Before an endless wall: (1 + cos atan(h / d)) / 2 of its height, 1 - (acos t - t sqrt(1 - t^2)) / pi within the range d / t.
TEST_F(Visibility, BeforeAWall)
{
    floor();
    slope(90, 1);
    expectOpen(-1.0f, 90.0f, 0.8535533906);
    expectOpen(-0.1f, 90.0f, 0.5497518595);
    expectOpen(-0.5f, 1.0f, 0.8044988905);
    expectOpen(-0.3f, 1.0f, 0.688081168);
    expectOpen(-0.1f, 1.0f, 0.5635557142);
    expectOpen(-1.0f, 0.99f, 1.0); // it is farther than the range
}

// In the corner of two endless walls at right angles a quarter of the hemisphere is left.
TEST_F(Visibility, InACorner)
{
    floor();
    slope(90, 99);
    addQuad(scene, vec3(-99, 0, 0.001f), vec3(0, 99, 0), vec3(198, 0, 0), 0);
    expectOpen(-0.001f, 90.0f, 0.25);
}

// On the floor of a square well: four rectangles' form factors from its mouth.
TEST_F(Visibility, OnTheFloorOfAPit)
{
    pit(1);
    expectOpen(0.0f, 9.0f, 0.554126424);
    scene.objects.clear(), scene.meshes.clear(), scene.vertices.clear(), scene.indices.clear();
    pit(3);
    expectOpen(0.0f, 9.0f, 0.1233175894);
}
}
