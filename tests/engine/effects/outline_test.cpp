// Outlines on white surfaces before a white sky: what is missing from white is line.
#include "shaders/camera.h"
#include "tests/engine/effects/drawn.hpp"
#include "tests/engine/upload/solids.hpp"
#include <glm/gtc/matrix_transform.hpp>

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

// A ball that dips 10 cm into a floor, seen at 22 degrees: it falls away to the line where they meet, which is all but its silhouette
// there, faster and faster. The line is unbroken over all that the eye sees of that circle.
TEST_F(Outline, ABallInAFloorHasAnUnbrokenLine)
{
    addQuad(scene, vec3(-9, 0, 9), vec3(18, 0, 0), vec3(0, 0, -18), white);
    addSphere(scene, white, 192);
    scene.objects[1].toWorld[3] = dvec4(0, 0.9, 0, 1);
    parts.outline.kinds = kEdgeObject;
    size = {96, 96};
    const Camera camera = lookAt(8.0f * vec3(0, std::sin(0.384f), std::cos(0.384f)), vec3(0), 0.45f);
    draw(camera);
    const mat4 toClip = makeView(camera, size).worldToClip;
    int asked = 0;
    for (int k = 0; k < 400; ++k) {
        const float turn = kTwoPi * float(k) / 400.0f, radius = std::sqrt(1.0f - 0.81f);
        const vec3 p(radius * std::sin(turn), 0, radius * std::cos(turn)), normal = p - vec3(0, 0.9f, 0);
        if (dot(normal, normalize(vec3(camera.toWorld[3]) - p)) < 0.03f) continue;
        const vec4 clip = toClip * vec4(p, 1.0f);
        const vec2 pixel = ndcToUv(vec2(clip) / clip.w) * vec2(size);
        EXPECT_GT(at(uint(pixel.x), uint(pixel.y)), 0.5f) << "turn " << k;
        ++asked;
    }
    EXPECT_GT(asked, 30);
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

// A skirting: the picture shows its top in a pixel or two, too few to tell where that meets the wall. No dots in place of a line; from
// above, where it is broad, the line is whole.
TEST_F(Outline, AStripOfAPixelHasNoDotsBesideIt)
{
    addQuad(scene, vec3(-20, -20, -4), vec3(40, 0, 0), vec3(0, 40, 0), white);
    const float lean = 0.1f;
    addCube(scene, white).toWorld =
        translate(dmat4(1), dvec3(0, -2, -4)) * rotate(dmat4(1), double(lean), dvec3(0, 0, 1)) * scale(dmat4(1), dvec3(20, 1, 0.5));
    parts.outline.kinds = kEdgeObject;
    draw(lookAt(vec3(0), vec3(0, 0, -1), kRightAngle));
    EXPECT_EQ(everything(), 0.0f);
    size = {128, 128};
    draw(lookAt(vec3(0, 1.5f, -1.5f), vec3(0, -1, -3.7f), kRightAngle));
    for (uint x = 48; x < 80; ++x) {
        float column = 0;
        for (uint y = 0; y < size.y; ++y) column += at(x, y);
        EXPECT_NEAR(column, 2.0f / std::cos(lean), 0.15f) << "column " << x;
    }
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
