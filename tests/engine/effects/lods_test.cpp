// Levels of detail: what is drawn strays by no more of the picture than is allowed, and the fronts of closed bodies are all that is drawn.
#include "engine/core/metrics.hpp"
#include "engine/effects/surface_draws.hpp"
#include "shaders/camera.h"
#include "shaders/random.h"
#include "tests/engine/effects/drawn.hpp"
#include "tests/engine/upload/solids.hpp"

namespace afterglow
{
namespace
{
constexpr uint kAround = 48;

// Every second row and column of addSphere(): a sphere of half as many.
LodLevel coarserSphere()
{
    LodLevel level;
    level.error = 1.0f - std::cos(kTwoPi / (0.5f * float(kAround)));
    for (uint row = 0; row < kAround / 2; row += 2)
        for (uint column = 0; column < kAround; column += 2) {
            const uint a = row * (kAround + 1) + column, b = a + 2 * (kAround + 1);
            if (row > 0) level.indices.insert(level.indices.end(), {a, b, a + 2});
            if (row + 2 < kAround / 2) level.indices.insert(level.indices.end(), {a + 2, b, b + 2});
        }
    return level;
}
}

class Lods : public Drawn
{
protected:
    // The depths of one sphere before the eye; stats says what was drawn.
    Image depthOf(const View& view)
    {
        GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {}, lods);
        findClosedBodies(uploaded, scene);
        const GpuLevel level(gpu, std::move(uploaded), GpuBaked{});
        Graph graph;
        const GBuffer surfaces = geometry(graph, view, level.scene, {});
        graph.output(surfaces.depth);
        stats = executor.run(graph, level.set);
        return executor.download(surfaces.depth);
    }

    View viewFrom(float distance, float mayStray)
    {
        FrameSample sample;
        sample.mayStray = mayStray;
        return makeView(lookAt(vec3(0, 0, distance), vec3(0)), size, sample);
    }

    void sphere()
    {
        addSphere(scene, addMaterial(scene, matte(vec3(0.5f))), kAround);
        lods = {{{{coarserSphere()}}}};
    }
};

// Two faces at a right angle, their edge rounded by a bevel that is 2 cm wide, along z in kAlong parts. Its first level keeps the bevel and
// loses what lies along it; the second loses the bevel: faces that were flat are then shaded from their own normal to that of the edge.
constexpr uint kAlong = 16;
constexpr float kBevel = 0.02f;
void addRidge(Scene& scene, std::vector<MeshLods>& lods, const Material& material)
{
    const vec3 left = normalize(vec3(-1, 1, 0)), right = normalize(vec3(1, 1, 0));
    const std::pair<vec3, vec3> profile[5] = {{{-1, -1, 0}, left},
                                              {{-kBevel, -kBevel, 0}, left},
                                              {{0, -0.6f * kBevel, 0}, {0, 1, 0}},
                                              {{kBevel, -kBevel, 0}, right},
                                              {{1, -1, 0}, right}};
    for (uint row = 0; row <= kAlong; ++row)
        for (const auto& [place, normal] : profile)
            scene.vertices.push_back(
                {place + vec3(0, 0, 1.0f - 2.0f * float(row) / float(kAlong)), normal, vec4(0, 0, 1, 1), vec2(0), vec2(0), ~0u});
    const auto strips = [](std::initializer_list<uint> columns, uint step) {
        std::vector<uint> indices;
        for (uint row = 0; row < kAlong; row += step)
            for (auto column = columns.begin(); column + 1 != columns.end(); ++column) {
                const uint a = 5 * row + column[0], b = 5 * row + column[1], c = a + 5 * step, d = b + 5 * step;
                indices.insert(indices.end(), {a, b, d, a, d, c});
            }
        return indices;
    };
    scene.indices = strips({0, 1, 2, 3, 4}, 1);
    scene.meshes.push_back({"ridge", {Primitive{0, 5 * (kAlong + 1), 0, uint(scene.indices.size()), addMaterial(scene, material)}}});
    Object object;
    object.name = "ridge";
    scene.objects.push_back(object);
    // The way from one end of a face to the edge's middle passes the bevel at 0.4 of its width; its normals turn by 45 degrees along it.
    MeshLods levels;
    levels.primitives.push_back({LodLevel{strips({0, 1, 2, 3, 4}, kAlong), 0.0f, 0.0f},
                                 LodLevel{strips({0, 2, 4}, kAlong), 0.6f * kBevel, kPi / 4.0f / std::sqrt(3.0f)}});
    lods = {levels};
}

// Any small step from any point of a box that the picture shows: never more pixels than the bound, and the bound is no idle one.
TEST(PixelsPerMetre, BoundWhatAStepCovers)
{
    shared::Sampler random = makeSampler(7u, 0u);
    const vec3 lower(-0.5f, -0.4f, -1.0f), upper(0.6f, 0.3f, 0.5f);
    for (const float fovY : {0.3f, 1.2f, 0.0f}) {
        Camera camera = lookAt(vec3(0.4f, 0.3f, 2.0f), vec3(0));
        camera.fovY = fovY, camera.orthoHeight = 1.5f;
        const View view = makeView(camera, {160, 90});
        const double bound = double(pixelsPerMetre(view, lower, upper));
        const auto pixel = [&](const dvec3& p) {
            const dvec4 c = dmat4(view.worldToClip) * dvec4(p, 1.0);
            return dvec2(c) / c.w * 0.5 * dvec2(view.size);
        };
        double largest = 0.0;
        for (int i = 0; i < 20000; ++i) {
            const vec3 p = mix(lower, upper, vec3(next2(random), next1(random)));
            const vec3 way = normalize(vec3(next2(random), next1(random)) - 0.5f);
            const dvec2 from = pixel(dvec3(p)), to = pixel(dvec3(p) + 1e-5 * dvec3(way));
            if (any(greaterThan(abs(from), 0.5 * dvec2(view.size)))) continue;
            const dvec2 step = abs(to - from) / 1e-5;
            largest = std::max({largest, step.x, step.y});
        }
        EXPECT_LE(largest, 1.001 * bound) << fovY;
        EXPECT_GE(largest, 0.5 * bound) << fovY;
    }
    const View inside = makeView(lookAt(vec3(0.0f), vec3(0, 0, -1)), {16, 16});
    EXPECT_EQ(pixelsPerMetre(inside, lower, upper), std::numeric_limits<float>::infinity());
}

TEST_F(Lods, AreDrawnWhereTheyStrayLessThanAllowed)
{
    size = {64, 64};
    sphere();
    const std::uint64_t fine = scene.indices.size() / 3, coarse = lods[0].primitives[0][0].indices.size() / 3;
    const float pixels = pixelsPerMetre(viewFrom(20.0f, 0.0f), vec3(-1), vec3(1)) * lods[0].primitives[0][0].error;
    depthOf(viewFrom(20.0f, 1.01f * pixels));
    EXPECT_EQ(stats.triangles, coarse);
    depthOf(viewFrom(20.0f, 0.99f * pixels));
    EXPECT_EQ(stats.triangles, fine);
    depthOf(viewFrom(20.0f, 0.0f));
    EXPECT_EQ(stats.triangles, fine);
    scene.objects[0].toWorld = dmat4(dvec4(3, 0, 0, 0), dvec4(0, 3, 0, 0), dvec4(0, 0, 3, 0), dvec4(0, 0, 0, 1));
    depthOf(viewFrom(20.0f, 1.01f * pixels));
    EXPECT_EQ(stats.triangles, fine) << "a larger body strays farther";
}

// Where the triangles stray by nothing to be seen, their normals may: the picture stays near the finest at every size.
TEST_F(Lods, AreNotDrawnWhereTheirNormalsWouldMoveTheLight)
{
    Material glossy = matte(vec3(0.5f));
    glossy.flags = 0u;
    glossy.roughness = 0.4f;
    addRidge(scene, lods, glossy);
    addLight(scene, sunLight(vec3(0.5f, -1, -0.3f), vec3(3.0f)));
    const Camera camera = lookAt(vec3(0, 5, 5), vec3(0, -0.5f, 0), 0.5f);
    const auto differs = [&]() {
        mayStray = 0.0f;
        const Image fine = radiance(camera);
        mayStray = 0.25f;
        return difference(radiance(camera), fine, 0.0).relativeRmse;
    };
    for (const uint edge : {16u, 32u, 64u, 128u}) {
        size = {edge, edge};
        EXPECT_LT(differs(), 0.02) << edge;
        EXPECT_EQ(stats.triangles, 8u + 1u) << "the level that turns nothing, and the picture's own, at " << edge;
    }
    lods[0].primitives[0][1].turn = 0.0f; // were it not known
    size = {32, 32};
    EXPECT_GT(differs(), 0.1);
    EXPECT_EQ(stats.triangles, 4u + 1u);
}

// The coarser sphere stands where the finer one does, to what it says of itself.
TEST_F(Lods, KeepToTheirError)
{
    size = {64, 64};
    sphere();
    const View close = viewFrom(4.0f, 0.0f);
    View coarser = close;
    coarser.mayStray = 1000.0f;
    const Image fine = depthOf(close), coarse = depthOf(coarser);
    int both = 0;
    double largest = 0.0;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const float a = *fine.at(x, y), b = *coarse.at(x, y);
            if (!(a > 0.0f && b > 0.0f)) continue;
            const vec2 uv = (vec2(float(x), float(y)) + 0.5f) / vec2(size);
            const vec3 p = worldFromDepth(uv, b, close.clipToWorld);
            ++both;
            largest = std::max(largest, double(1.0f - length(p)));
        }
    EXPECT_GT(both, 500);
    EXPECT_LE(largest, 1.01 * double(lods[0].primitives[0][0].error));
    EXPECT_GT(largest, 0.0);
}

// The backs of a closed body are left out for an eye outside of it alone: from inside they are all there is.
TEST_F(Lods, ABodySeenFromInsideShowsItsBacks)
{
    size = {32, 32};
    sphere();
    GpuScene uploaded = uploadScene(gpu, scene, instances(scene), {});
    EXPECT_FALSE(uploaded.draws[0].closed) << "nobody asked";
    findClosedBodies(uploaded, scene);
    EXPECT_TRUE(uploaded.draws[0].closed);
    const Image inside = depthOf(makeView(lookAt(vec3(0.2f, 0, 0), vec3(1, 0, 0)), size));
    for (std::size_t i = 0; i < inside.pixels.size(); ++i) EXPECT_GT(inside.pixels[i], 0.0f);
    Camera cutting = lookAt(vec3(0, 0, 4), vec3(0));
    cutting.nearPlane = 4.0f; // through the middle: the eye looks into the half that remains
    const Image half = depthOf(makeView(cutting, size));
    const vec3 p = worldFromDepth(vec2(0.5f + 0.5f / 32.0f), *half.at(16, 16), makeView(cutting, size).clipToWorld);
    EXPECT_NEAR(length(p), 1.0f, 0.02f);
    EXPECT_LT(p.z, 0.0f);
}
}
