// Outlines on white surfaces before a white sky: what is missing from white is line.
#include "shaders/camera.h"
#include "tests/engine/effects/drawn.hpp"
#include "tests/engine/upload/solids.hpp"

namespace afterglow
{
class Outline : public Drawn
{
protected:
    Outline()
    {
        size = {64, 64};
        scene.sky.radiance = vec3(1.0f);
        Material glowing = matte(vec3(1.0f));
        glowing.flags |= kMaterialUnlit;
        white = addMaterial(scene, glowing);
        parts.outline.width = 2.0f;
    }

    // Lines are kept in 8 bits: what is fainter than half a step is the rounding of white.
    void draw(const Camera& camera)
    {
        constexpr float kFaintest = 0.5f / 255.0f;
        const Image image = radiance(camera, parts);
        covered.assign(std::size_t(size.x) * size.y, 0.0f);
        for (uint i = 0; i < covered.size(); ++i)
            if (const float line = 1.0f - image.pixels[4 * i]; line > kFaintest) covered[i] = line;
    }
    float at(uint x, uint y) const { return covered[y * size.x + x]; }
    float row(uint y) const
    {
        float sum = 0;
        for (uint x = 0; x < size.x; ++x) sum += at(x, y);
        return sum;
    }
    float everything() const
    {
        float sum = 0;
        for (const float c : covered) sum += c;
        return sum;
    }

    uint white = 0;
    DrawnParts parts;
    std::vector<float> covered; // by the line, of each pixel
};

constexpr float kRightAngle = 1.57079633f; // a field of view whose half has a tangent of 1

// A row that crosses two borders at right angles holds twice the width, near and far, thick and thin.
TEST_F(Outline, TheWidthIsTheSameAtEveryDistance)
{
    addQuad(scene, vec3(-1, -1, 0), vec3(2, 0, 0), vec3(0, 2, 0), white);
    for (const float width : {0.5f, 1.0f, 2.0f, 3.5f})
        for (const float distance : {1.7f, 3.9f, 6.3f}) {
            parts.outline.width = width;
            draw(lookAt(vec3(0.01f, 0.02f, distance), vec3(0.01f, 0.02f, 0), kRightAngle));
            EXPECT_NEAR(row(32), 2.0f * width, 0.02f) << "width " << width << " at " << distance << " m";
        }
}

// A border that runs askew is cut by a row at an angle: its width there is 1 / cos of it. And its edge is grey, not a staircase.
TEST_F(Outline, ASlantedLineIsSmooth)
{
    const float turn = 0.3f;
    const vec3 right(std::cos(turn), std::sin(turn), 0), up(-std::sin(turn), std::cos(turn), 0);
    addQuad(scene, -right - up, 2.0f * right, 2.0f * up, white);
    parts.outline.width = 3.0f;
    draw(lookAt(vec3(0, 0, 2.5f), vec3(0), kRightAngle));
    int grey = 0;
    float sum = 0;
    for (uint y = 28; y < 36; ++y) {
        sum += row(y) / 8.0f;
        for (uint x = 0; x < size.x; ++x) grey += at(x, y) > 0.05f && at(x, y) < 0.95f;
    }
    EXPECT_NEAR(sum, 2.0f * 3.0f / std::cos(turn), 0.05f);
    EXPECT_GE(grey, 16);
}

// H76: a surface that goes on beyond the picture ends in no line there.
TEST_F(Outline, ThePicturesBorderIsNoLine)
{
    addQuad(scene, vec3(-9, -9, -2), vec3(18, 0, 0), vec3(0, 18, 0), white);
    addSphere(scene, white).toWorld[3] = dvec4(9, 0, -1, 1);
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    EXPECT_EQ(everything(), 0.0f);
}

// H76: what is thinner than a pixel is one unbroken line, though the depth buffer misses it in places.
TEST_F(Outline, AWireIsALine)
{
    addQuad(scene, vec3(0.013f, -9, -4), vec3(0.02f, 0, 0), vec3(0.6f, 18, 0), white); // 0.16 px wide, leaning
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    for (uint y = 0; y < size.y; ++y) EXPECT_NEAR(row(y), 2.0f, 0.4f) << "row " << y;
}

// A cube with vertices of its own for every face, seen on a corner: nine edges are seen, three are hidden, six diagonals are none.
TEST_F(Outline, ACubeShowsWhatACubeHas)
{
    addCube(scene, white);
    const Camera camera = lookAt(vec3(4, 3.9f, 4.1f), vec3(0));
    draw(camera);
    const mat4 toClip = makeView(camera, size).worldToClip;
    const auto lineAt = [&](vec3 p) {
        const vec4 clip = toClip * vec4(p, 1.0f);
        const vec2 pixel = ndcToUv(vec2(clip) / clip.w) * vec2(size);
        return at(uint(pixel.x), uint(pixel.y));
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const float a : {-1.0f, 1.0f})
            for (const float b : {-1.0f, 1.0f}) {
                vec3 middle(0.0f);
                middle[(axis + 1) % 3] = a;
                middle[(axis + 2) % 3] = b;
                if (a < 0 && b < 0)
                    EXPECT_LT(lineAt(middle), 0.05f) << "hidden, along axis " << axis;
                else
                    EXPECT_GT(lineAt(middle), 0.6f) << "along axis " << axis << ": " << a << ", " << b;
            }
    for (int axis = 0; axis < 3; ++axis) {
        vec3 face(0.0f);
        face[axis] = 1.0f;
        EXPECT_EQ(lineAt(face), 0.0f) << "a diagonal";
    }
}

// The silhouette of a sphere is a circle of the tangent cone; its seams, poles and rings are no lines.
TEST_F(Outline, ASphereIsARing)
{
    addSphere(scene, white, 96);
    const float distance = 3.0f;
    draw(lookAt(vec3(0, 0, distance), vec3(0), kRightAngle));
    const float radius = 32.0f / std::sqrt(distance * distance - 1.0f);
    std::vector<float> sum(8, 0.0f);
    for (uint y = 0; y < size.y; ++y)
        for (uint x = 0; x < size.x; ++x) {
            const vec2 from(float(x) + 0.5f - 32.0f, float(y) + 0.5f - 32.0f);
            if (at(x, y) > 0.02f) {
                EXPECT_NEAR(length(from), radius, 1.0f + 0.71f + 0.1f) << x << ", " << y;
            }
            sum[std::size_t((std::atan2(from.y, from.x) + kPi) / kTwoPi * 7.999f)] += at(x, y);
        }
    for (const float s : sum) EXPECT_NEAR(s, 2.0f * kTwoPi * radius / 8.0f, 0.12f * s) << "unbroken, everywhere as wide";
}

// A line hidden by a wall stays hidden where something stands before both: every row holds the border of that alone.
TEST_F(Outline, WhatIsHiddenShowsBesideNothing)
{
    addQuad(scene, vec3(-9, -9, -3), vec3(18, 0, 0), vec3(0, 18, 0), white);        // the wall
    addQuad(scene, vec3(-9, -9, -8), vec3(18, 0, 0), vec3(0, 9.02f, 0), white);     // ends behind it, across the picture
    addQuad(scene, vec3(-9, -9, -1), vec3(9.017f, 0, 0), vec3(0.1f, 18, 0), white); // before the left half
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    for (uint y = 0; y < size.y; ++y) EXPECT_NEAR(row(y), 2.0f, 0.05f) << "row " << y;
}

// Where a ball dips into a floor its line goes on all around, at any depth.
TEST_F(Outline, ABallThatTouchesAFloorHasAnUnbrokenLine)
{
    addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), white);
    addSphere(scene, white, 96);
    size = {96, 96};
    for (const float dips : {0.02f, 0.1f, 0.3f}) {
        scene.objects[1].toWorld[3] = dvec4(0, 1.0 - double(dips), 0, 1);
        draw(lookAt(vec3(0, 2.5f, 4), vec3(0, 0.8f, 0), 0.7f));
        const mat4 toClip = makeView(lookAt(vec3(0, 2.5f, 4), vec3(0, 0.8f, 0), 0.7f), size).worldToClip;
        const vec4 clip = toClip * vec4(vec3(0, 1.0f - dips, 0), 1.0f);
        const vec2 middle = ndcToUv(vec2(clip) / clip.w) * vec2(size);
        for (int turn = 0; turn < 64; ++turn) { // outwards from the middle of the ball every ray meets the line
            const vec2 way(std::cos(float(turn) * kTwoPi / 64.0f), std::sin(float(turn) * kTwoPi / 64.0f));
            float most = 0.0f;
            for (float r = 10.0f; r < 44.0f; r += 0.25f) {
                const vec2 p = middle + r * way;
                if (p.x >= 0 && p.y >= 0 && p.x < 96 && p.y < 96) most = std::max(most, at(uint(p.x), uint(p.y)));
            }
            EXPECT_GT(most, 0.5f) << "dips " << dips << " m, turn " << turn;
        }
    }
}

TEST_F(Outline, WhatIsHiddenHasNoLine)
{
    addQuad(scene, vec3(-9, -9, -2), vec3(18, 0, 0), vec3(0, 18, 0), white);
    addCube(scene, white).toWorld[3] = dvec4(0, 0, -6, 1);
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    EXPECT_EQ(everything(), 0.0f);
}

// H76: two objects in one plane, side by side and one on the other: their borders, and no dust where neither is the nearer.
TEST_F(Outline, ObjectsInOnePlaneShowTheirBorders)
{
    addQuad(scene, vec3(-9, -9, -2), vec3(9, 0, 0), vec3(0, 18, 0), white);
    addQuad(scene, vec3(0, -9, -2), vec3(9, 0, 0), vec3(0, 18, 0), white);
    draw(lookAt(vec3(0.1f, 0, 0), vec3(0.1f, 0, -1), kRightAngle));
    for (uint y = 0; y < size.y; ++y) EXPECT_NEAR(row(y), 2.0f, 0.05f) << "row " << y;
    addQuad(scene, vec3(-3, -9, -2), vec3(8, 0, 0), vec3(0, 18, 0), white); // its sides are out of sight
    draw(lookAt(vec3(0.1f, 0, 0), vec3(0.1f, 0.1f, -1), kRightAngle));
    for (uint y = 0; y < size.y; ++y) EXPECT_NEAR(row(y), 2.0f, 0.1f) << "row " << y;
}

// No mesh has an edge where two objects pass through each other. One that stands before the other is told by its own edges.
TEST_F(Outline, ObjectsThatPassThroughEachOtherMeetInALine)
{
    addQuad(scene, vec3(-9, -9, -4), vec3(18, 0, 0), vec3(0, 18, 0), white);
    addQuad(scene, vec3(-5, -9, -9.02f), vec3(10, 0, 10), vec3(0, 18, 0), white); // crosses the first at x = 0.02
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    for (uint y = 0; y < size.y; ++y) EXPECT_NEAR(row(y), 2.0f, 0.1f) << "row " << y;
    parts.outline.kinds = kEveryEdge & ~kEdgeObject;
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    EXPECT_EQ(everything(), 0.0f);

    scene.objects.pop_back();
    addQuad(scene, vec3(-0.5f, -0.5f, -2), vec3(1, 0, 0), vec3(0, 1, 0), white);
    parts.outline.kinds = kEdgeObject;
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    EXPECT_EQ(everything(), 0.0f);
}

TEST_F(Outline, EachKindCanBeLeftOut)
{
    addCube(scene, white);
    const Camera camera = lookAt(vec3(4, 3.9f, 4.1f), vec3(0));
    draw(camera);
    const float both = everything();
    parts.outline.kinds = kEdgeSilhouette;
    draw(camera);
    const float silhouette = everything();
    parts.outline.kinds = kEdgeCrease;
    draw(camera);
    EXPECT_LT(silhouette, 0.8f * both); // six edges of nine
    EXPECT_GT(silhouette, 0.5f * both);
    EXPECT_NEAR(everything(), both, 0.01f * both) << "of a cube every edge is a crease";
    parts.outline.kinds = kEdgeBorder;
    draw(camera);
    EXPECT_EQ(everything(), 0.0f);
}

// The air between dims a line as it dims everything: what is left of it is the transmittance.
TEST_F(Outline, FogCoversALine)
{
    addQuad(scene, vec3(-1, -9, -4), vec3(20, 0, 0), vec3(0, 18, 0), white);
    Medium air{};
    air.absorption = vec3(0.2f);
    air.lower = vec3(-50);
    air.upper = vec3(50);
    scene.media.push_back(air);
    const Camera camera = lookAt(vec3(-1, 0, 0), vec3(-1, 0, -1), kRightAngle);
    parts.fog = true;
    const Image with = radiance(camera, parts);
    parts.outline.width = 0.0f;
    const Image without = radiance(camera, parts);
    EXPECT_NEAR(1.0f - with.at(32, 32)[0] / without.at(32, 32)[0], std::exp(-0.2f * 4.0f), 0.01f);
}

// An edge that begins behind the eye, or runs far out of the picture, ends where it should; an orthographic eye sees the same lines.
TEST_F(Outline, EdgesBehindTheEyeAreCut)
{
    addQuad(scene, vec3(0, -1, 900), vec3(0, 0, -1000), vec3(-500, 0, 0), white); // a floor that passes below
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    EXPECT_NEAR(row(48), 2.0f, 0.1f);
    Camera camera = lookAt(vec3(0, 0, 4), vec3(0));
    camera.fovY = 0.0f;
    camera.orthoHeight = 4.0f;
    addQuad(scene, vec3(-1, -0.9f, 0), vec3(2, 0, 0), vec3(0, 1.8f, 0), white);
    draw(camera);
    EXPECT_NEAR(row(32), 4.0f, 0.1f);
}
}
