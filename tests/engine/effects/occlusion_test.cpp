// Occlusion: each method against closed forms and rays, and above all where nothing may be hidden.
#include "shaders/sampling.h"
#include "shaders/visibility.h"
#include "tests/engine/effects/drawn.hpp"
#include <span>

namespace afterglow
{
// Mean absolute errors that the methods may have, of pictures whose occluders the screen shows.
struct Method {
    OcclusionMethod method;
    const char* name;
    float bound;
};
const Method kMethods[] = {{OcclusionMethod::ssao, "ssao", 0.10f},
                           {OcclusionMethod::hbao, "hbao", 0.05f},
                           {OcclusionMethod::voxel, "voxel", 0.08f},
                           {OcclusionMethod::ray, "ray", 0.02f}};

class Occlusion : public Drawn
{
protected:
    // Those that the device can.
    std::span<const Method> methods() const { return std::span(kMethods).first(gpu.device.rayQuery ? 4 : 3); }
    uint grey() { return scene.materials.empty() ? addMaterial(scene, matte(vec3(0.64f))) : 0u; }
    void floor(float half = 5.0f) { addQuad(scene, vec3(-half, 0, -half), vec3(0, 0, 2 * half), vec3(2 * half, 0, 0), grey()); }
    // Across the view at x = `at`, its front towards -x, and `height` m high.
    void wall(float at, float height) { addQuad(scene, vec3(at, 0, 5), vec3(0, 0, -10), vec3(0, height, 0), grey()); }
    // A plane that meets the floor along z at x = 0, at an angle in degrees.
    void slope(float degrees)
    {
        const float angle = degrees * kPi / 180.0f;
        addQuad(scene, vec3(0, 0, 5), vec3(0, 0, -10), 5.0f * vec3(-std::cos(angle), std::sin(angle), 0), grey());
    }
    // A square well: half its width 1 m, its floor at y = 0.
    void pit(float depth)
    {
        addQuad(scene, vec3(-1, 0, -1), vec3(0, 0, 2), vec3(2, 0, 0), grey());
        for (const vec3 side : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
            const vec3 along = cross(vec3(0, 1, 0), side);
            addQuad(scene, side - along, 2.0f * along, vec3(0, depth, 0), grey());
        }
    }

    // Whether a ray meets a quad of the scene nearer than `range`.
    bool meets(vec3 from, vec3 way, float range) const
    {
        for (std::size_t q = 0; q + 3 < scene.vertices.size(); q += 4) {
            const vec3 corner = scene.vertices[q].position, u = scene.vertices[q + 1].position - corner,
                       v = scene.vertices[q + 3].position - corner;
            const vec3 normal = cross(u, v);
            const float along = dot(way, normal);
            if (std::abs(along) < 1e-9f) continue;
            const float t = dot(corner - from, normal) / along;
            if (!(t > 1e-4f && t < range)) continue;
            const vec3 at = from + way * t - corner;
            const float a = dot(at, u) / dot(u, u), b = dot(at, v) / dot(v, v); // u and v are at right angles
            if (a >= 0 && a <= 1 && b >= 0 && b <= 1) return true;
        }
        return false;
    }
    // By rays: right to a few in a thousand.
    float open(vec3 from, vec3 normal, float range, int rays = 4096) const
    {
        int hit = 0;
        const Frame frame = makeFrame(normal);
        for (int i = 0; i < rays; ++i) // Roberts' R2 sequence
            hit += meets(
                from, toWorld(frame, sampleCosineHemisphere(vec2(fract(0.5 + double(i) * dvec2(0.7548776662466927, 0.5698402909980532))))),
                range);
        return 1.0f - float(hit) / float(rays);
    }

    static float least(const Image& image)
    {
        float result = 1.0f;
        for (int i = 0; i < image.width * image.height; ++i) result = std::min(result, image.pixels[std::size_t(i) * image.channels]);
        return result;
    }
    static float at(const Image& image, int x, int y) { return image.at(x, y)[0]; }
    static OcclusionParameters within(float range)
    {
        OcclusionParameters p = defaultOcclusionParameters();
        p.range = range;
        return p;
    }
    // Where a pixel's ray meets the floor.
    vec3 onFloor(const Camera& camera, int x, int y) const
    {
        const View view = makeView(camera, size);
        const vec4 far_ = view.clipToWorld * vec4((vec2(x, y) + 0.5f) / vec2(size) * 2.0f - 1.0f, 0.5f, 1.0f);
        const vec3 eye(camera.toWorld[3]), way = vec3(far_) / far_.w - eye;
        return eye - way * (eye.y / way.y);
    }
    // Mean absolute error over the pixels of the floor with -2 < x < -0.02 and |z| < 1.
    float floorError(const Camera& camera, OcclusionMethod method, const OcclusionParameters& p, std::size_t most = kMostVoxels)
    {
        const Image image = visibility(camera, method, p, most);
        double sum = 0;
        int count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const vec3 place = onFloor(camera, x, y);
                if (!(place.x > -2.0f && place.x < -0.02f && std::abs(place.z) < 1.0f)) continue;
                sum += double(std::abs(at(image, x, y) - open(place + vec3(0, 1e-4f, 0), vec3(0, 1, 0), p.range, 1024)));
                ++count;
            }
        EXPECT_GT(count, 50);
        return float(sum / count);
    }
};

// The arc is the integral of the cosine to the normal times the slices' sine, and all open slices together are the hemisphere.
TEST(HorizonArc, IsItsIntegral)
{
    for (const float n : {-1.4f, -0.5f, 0.0f, 0.3f, 1.2f})
        for (const float h : {0.05f, 0.6f, n + kHalfPi}) {
            if (h < 0.0f) continue;
            double sum = 0;
            for (int i = 0; i < 2000; ++i) {
                const double angle = double(h) * (i + 0.5) / 2000;
                sum += std::sin(angle) * std::cos(angle - double(n)) * double(h) / 2000;
            }
            EXPECT_NEAR(horizonArc(h, n), sum, 1e-5) << n << ' ' << h;
            EXPECT_NEAR(horizonArc(-h, -n), sum, 1e-5) << "the other side";
        }
    for (const float tilt : {0.0f, 0.7f, 1.5f}) { // of the normal from the line of sight
        double whole = 0;
        for (int i = 0; i < 512; ++i) {
            const float turn = (float(i) + 0.5f) * kPi / 512.0f, across = std::sin(tilt) * std::cos(turn), along = std::cos(tilt);
            const float n = std::atan2(across, along);
            whole += double(std::sqrt(across * across + along * along) * openArc(n)) / 512;
            EXPECT_NEAR(horizonArc(n + kHalfPi, n) + horizonArc(n - kHalfPi, n), openArc(n), 1e-5f);
        }
        EXPECT_NEAR(whole, 1.0, 1e-3) << tilt;
    }
}

// H73, H74: a floor hides nothing of itself, seen from above or along it, in a picture of any size, by an orthographic eye, too.
TEST_F(Occlusion, AFloorIsOpen)
{
    floor();
    for (const Method& m : methods())
        for (const uvec2 picture : {uvec2(61, 47), uvec2(64, 48), uvec2(1, 1), uvec2(7, 1)}) {
            size = picture;
            for (const float height : {0.05f, 1.7f, 20.0f})
                EXPECT_GE(least(visibility(lookAt(vec3(0, height, 4), vec3(0.3f, 0, 0)), m.method, within(1.0f))), 0.99f)
                    << m.name << " from " << height << " m, " << picture.x << " x " << picture.y;
            Camera flat = lookAt(vec3(0, 3, 4), vec3(0));
            flat.fovY = 0.0f;
            flat.orthoHeight = 5.0f;
            EXPECT_GE(least(visibility(flat, m.method, within(1.0f))), 0.99f) << m.name << ", orthographic";
        }
}

// A floor that lies across the voxels, in every direction.
TEST_F(Occlusion, ASlantedFloorIsOpenToVoxels)
{
    size = {48, 48};
    for (const vec3 normal : {vec3(1, 1, 0), vec3(1, 1, 1), vec3(0.2f, 1, 0.1f), vec3(1, 3, 2)}) {
        scene.objects.clear(), scene.meshes.clear(), scene.vertices.clear(), scene.indices.clear();
        const Frame f = makeFrame(normalize(normal));
        addQuad(scene, -4.0f * (f.tangent + f.bitangent), 8.0f * f.tangent, 8.0f * f.bitangent, grey());
        const Camera above = lookAt(3.0f * f.normal, vec3(0));
        EXPECT_GE(least(visibility(above, OcclusionMethod::voxel, within(1.0f))), 0.99f) << normal.x << ' ' << normal.y << ' ' << normal.z;
    }
}

// Closed forms (projected solid angle): the wedge's (1 - cos theta) / 2 at its edge, the wall's (1 + cos atan(h / d)) / 2, the wall within a
// range 1 - (acos t - t sqrt(1 - t^2)) / pi. They are what the rays of this test find.
TEST_F(Occlusion, TheRaysOfThisTestMeetTheClosedForms)
{
    for (const auto& [degrees, value] : {std::pair(60.0f, 0.25f), {90.0f, 0.5f}, {135.0f, 0.85355339f}}) {
        scene = Scene();
        slope(degrees);
        EXPECT_NEAR(open(vec3(-1e-3f, 0, 0), vec3(0, 1, 0), 9.0f), value, 5e-3f) << degrees;
    }
    scene = Scene();
    wall(0, 1);
    EXPECT_NEAR(open(vec3(-0.1f, 0, 0), vec3(0, 1, 0), 99.0f), 0.54975186f, 5e-3f);
    scene = Scene();
    wall(0, 9);
    for (const auto& [t, value] : {std::pair(0.5f, 0.80449889f), {0.3f, 0.68808117f}, {0.1f, 0.56355571f}})
        EXPECT_NEAR(open(vec3(-t, 0, 0), vec3(0, 1, 0), 1.0f), value, 5e-3f) << t;
    scene = Scene();
    pit(1);
    EXPECT_NEAR(open(vec3(0), vec3(0, 1, 0), 99.0f), 0.55412642f, 5e-3f);
    scene = Scene();
    pit(3);
    EXPECT_NEAR(open(vec3(0), vec3(0, 1, 0), 99.0f), 0.12331759f, 5e-3f);
}

// Two planes at 60, 90 and 135 degrees, both seen by the eye.
TEST_F(Occlusion, OfAWedgeIsNearTheTruth)
{
    size = {96, 96};
    for (const float degrees : {60.0f, 90.0f, 135.0f}) {
        scene = Scene();
        floor();
        slope(degrees);
        const float middle = (180.0f - 0.5f * degrees) * kPi / 180.0f; // half way between the planes
        const Camera camera = lookAt(5.0f * vec3(std::cos(middle), std::sin(middle), 0), vec3(-0.5f, 0, 0), 0.7f);
        for (const Method& m : methods()) {
            const float error = floorError(camera, m.method, within(1.0f));
            EXPECT_LE(error, m.bound) << m.name << ' ' << degrees;
            std::printf("wedge of %3.0f degrees, %s: mean absolute error %.4f\n", double(degrees), m.name, double(error));
        }
    }
}

TEST_F(Occlusion, OfAWallIsNearTheTruth)
{
    size = {96, 96};
    floor();
    wall(0, 1);
    const Camera camera = lookAt(vec3(-4, 3, 0), vec3(-0.5f, 0, 0), 0.7f);
    for (const float range : {0.5f, 1.0f, 2.0f})
        for (const Method& m : methods()) {
            const float error = floorError(camera, m.method, within(range));
            EXPECT_LE(error, m.bound) << m.name << ' ' << range;
            std::printf("wall of 1 m within %.1f m, %s: mean absolute error %.4f\n", double(range), m.name, double(error));
        }
}

// The middle of a pit 2 m wide, looked into from above; the rim hides the sky from 1.4 m of it on.
TEST_F(Occlusion, OfAPitIsNearTheTruth)
{
    size = {97, 97};
    for (const float depth : {1.0f, 3.0f}) {
        scene = Scene();
        pit(depth);
        const Camera camera = lookAt(vec3(0, depth + 3.0f, 0), vec3(0), 0.8f);
        const float truth = open(vec3(0, 1e-4f, 0), vec3(0, 1, 0), 1.5f);
        OcclusionParameters p = within(1.5f);
        p.steps = 32; // the walls are nine pixels wide in the picture, and the range 45
        const auto found = [&](OcclusionMethod method) { return at(visibility(camera, method, p), 48, 48); };
        EXPECT_NEAR(found(OcclusionMethod::hbao), truth, 0.05f) << depth;
        EXPECT_NEAR(found(OcclusionMethod::voxel), truth, 0.08f) << depth;
        EXPECT_GT(found(OcclusionMethod::ssao), truth - 0.02f) << "few points lie in the walls: too bright, says the study";
    }
}

// A lightmap holds the contact of its front alone, and only while it is drawn: backs are dimmed, and fronts when no page is there to read.
TEST_F(Occlusion, DimsWhatNoLightmapLights)
{
    floor();
    addQuad(scene, vec3(0, -1, 5), vec3(0, 0, -10), vec3(0, 2, 0), grey()); // a wall through the floor
    scene.sky.radiance = vec3(1);
    size = {33, 33};
    const auto kept = [&](const Camera& camera) {
        DrawnParts parts;
        const float without = middle(radiance(camera, parts)).x;
        parts.occlusion = true;
        return middle(radiance(camera, parts)).x / without;
    };
    const Camera above = lookAt(vec3(-3, 2, 0), vec3(-0.2f, 0, 0)), below = lookAt(vec3(-3, -2, 0), vec3(-0.2f, 0, 0));
    const Baked even = bakedEvenly(scene, vec3(1));
    baked = even;
    EXPECT_EQ(kept(above), 1.0f);
    EXPECT_LT(kept(below), 0.95f);
    baked.lightmaps.clear();
    EXPECT_LT(kept(above), 0.95f);
}

// What lies farther than the range hides nothing.
TEST_F(Occlusion, EndsWithTheRange)
{
    floor();
    wall(0, 3);
    size = {64, 64};
    const Camera camera = lookAt(vec3(-1.5f, 2, 0), vec3(-1.5f, 0, 0), 0.4f); // the floor from 1 m before the wall on
    for (const Method& m : methods()) EXPECT_GE(least(visibility(camera, m.method, within(0.9f))), 0.99f) << m.name;
}

// H65: the sky is no wall, neither for the sky itself nor for what stands before it.
TEST_F(Occlusion, TheSkyHidesNothing)
{
    addQuad(scene, vec3(-0.5f, -0.5f, -3), vec3(1, 0, 0), vec3(0, 1, 0), grey());
    size = {33, 33};
    for (const Method& m : methods())
        EXPECT_GE(least(visibility(lookAt(vec3(0), vec3(0, 0, -1)), m.method, within(1.0f))), 0.99f) << m.name;
    scene = Scene();
    for (const Method& m : methods()) EXPECT_EQ(least(visibility(lookAt(vec3(0), vec3(0, 0, -1)), m.method, within(1.0f))), 1.0f) << m.name;
}

// H73: at the border of the picture the samples that it has say what is hidden: no bright frame, no dark one.
TEST_F(Occlusion, AtTheBorderOfThePictureTheSamplesThereAreCount)
{
    floor();
    wall(0, 1);
    // Along a row of the picture the wall is everywhere as near
    size = {64, 64};
    const Camera camera = lookAt(vec3(-2, 2, 0), vec3(-0.2f, 0, 0), 0.8f);
    for (const Method& m : methods()) {
        const Image image = visibility(camera, m.method, within(1.0f));
        for (int y = 0; y < 64; ++y)
            for (const int x : {0, 1, 2, 61, 62, 63})
                EXPECT_NEAR(at(image, x, y), at(image, 32, y), 0.2f) << m.name << ' ' << x << ' ' << y;
        EXPECT_LT(at(image, 0, 31), 0.8f) << m.name << " at the foot of the wall";
    }
}

// H73: an object of one pixel leaves no dark fringe on what lies far behind it.
TEST_F(Occlusion, AnObjectOfOnePixelLeavesNoFringe)
{
    floor();
    addQuad(scene, vec3(-0.015f, 2.0f, -0.015f), vec3(0, 0, 0.03f), vec3(0.03f, 0, 0), grey());
    for (const uvec2 picture : {uvec2(64, 64), uvec2(65, 63)}) {
        size = picture;
        for (const Method& m : methods())
            EXPECT_GE(least(visibility(lookAt(vec3(0, 4, 0), vec3(0), 0.9f), m.method, within(1.0f))), 0.98f) << m.name;
    }
}

// A roof half a metre above the floor, out of sight: voxels know of it.
TEST_F(Occlusion, ByVoxelsKnowsWhatTheScreenDoesNotSee)
{
    floor();
    addQuad(scene, vec3(-5, 0.5f, -5), vec3(10, 0, 0), vec3(0, 0, 10), grey());
    size = {48, 48};
    const Camera under = lookAt(vec3(0, 0.25f, 0), vec3(1, 0, 0), 0.3f);
    const float truth = open(vec3(0, 1e-4f, 0), vec3(0, 1, 0), 1.0f); // 1 - cos^2 60 = 0.25 of an endless one
    EXPECT_NEAR(truth, 0.25f, 5e-3f);
    EXPECT_NEAR(middle(visibility(under, OcclusionMethod::voxel, within(1.0f))).x, truth, 0.08f);
    for (const OcclusionMethod screen : {OcclusionMethod::ssao, OcclusionMethod::hbao})
        EXPECT_GT(middle(visibility(under, screen, within(1.0f))).x, 0.9f) << "the study says that the screen does not know";
}

// H74: a room smaller than a voxel, and one of nothing but a surface that is flat.
TEST_F(Occlusion, OfARoomSmallerThanAVoxelIsFinite)
{
    addRoom(scene, vec3(-0.01f), vec3(0.01f), grey());
    addQuad(scene, vec3(-500, -1, -500), vec3(0, 0, 1000), vec3(1000, 0, 0), grey());
    size = {16, 16};
    const Image image = visibility(lookAt(vec3(0), vec3(0, 0, -1)), OcclusionMethod::voxel, within(1.0f));
    for (int i = 0; i < 16 * 16; ++i) {
        EXPECT_GE(image.pixels[std::size_t(i) * image.channels], 0.0f);
        EXPECT_LE(image.pixels[std::size_t(i) * image.channels], 1.0f);
    }
}

// It dims the light from everywhere, with the tint of several bounces, and neither direct light nor emission.
TEST_F(Occlusion, DimsTheLightFromEverywhereAlone)
{
    floor();
    wall(0, 1);
    size = {32, 32};
    const Camera camera = lookAt(vec3(-3, 2, 0), vec3(-0.4f, 0, 0), 0.4f);
    const DrawnParts hidden{.occlusion = true, .occlusionMethod = OcclusionMethod::hbao};
    addLight(scene, sunLight(vec3(0.3f, -1, 0), vec3(2.0f)));
    scene.materials[0].emission = vec3(0.25f);
    EXPECT_EQ(radiance(camera).pixels, radiance(camera, hidden).pixels);

    scene.lights.clear();
    scene.materials[0].emission = vec3(0.0f);
    scene.sky.radiance = vec3(1.0f);
    const Image open = visibility(camera, OcclusionMethod::hbao, within(1.0f)), lit = radiance(camera, hidden);
    EXPECT_LT(least(open), 0.7f);
    for (int i = 0; i < 32 * 32; ++i)
        EXPECT_NEAR(lit.pixels[std::size_t(i) * lit.channels],
                    0.64f * bouncedVisibility(open.pixels[std::size_t(i) * open.channels], vec3(0.64f)).x, 4e-3f);
}

// A lightmap holds what hides the light: it is not taken twice.
TEST_F(Occlusion, LeavesWhatHasALightmapAsItIs)
{
    floor();
    wall(0, 1);
    baked = bakedEvenly(scene, vec3(0.7f));
    size = {32, 32};
    const Camera camera = lookAt(vec3(-3, 2, 0), vec3(-0.4f, 0, 0), 0.4f);
    EXPECT_EQ(radiance(camera).pixels, radiance(camera, {.occlusion = true}).pixels);
    baked.places[0].page = -1; // the floor moves, say
    baked.probes.push_back(evenProbes(vec3(-5), vec3(5), vec3(0.7f)));
    const Image without = radiance(camera), with = radiance(camera, {.occlusion = true});
    EXPECT_NE(without.pixels, with.pixels);
}

// ---- Cost laws --------------------------------------------------------------------------------------------------------------------

// Slope of log error over log parameter, by least squares.
static double slopeOf(const std::vector<std::pair<double, double>>& points)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [parameter, error] : points) {
        const double a = std::log(parameter), b = std::log(error);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    const double n = double(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

class OcclusionLaws : public Occlusion
{
protected:
    OcclusionParameters fine()
    {
        OcclusionParameters p = within(1.0f);
        p.divisor = 1;
        p.slices = 16;
        p.smooth_ = 0;
        p.cones = 64;
        p.aperture = 0.0f; // the finest voxels all along
        return p;
    }
    void wedge()
    {
        size = {128, 128};
        floor();
        slope(60.0f);
    }
    const Camera camera = lookAt(5.0f * vec3(std::cos(2.618f), std::sin(2.618f), 0), vec3(-0.5f, 0, 0), 0.7f);
};

// On a depth buffer that sees both planes the error of the horizons falls as 1 / steps.
TEST_F(OcclusionLaws, slowHorizonsByTheirSteps)
{
    wedge();
    std::vector<std::pair<double, double>> points;
    for (const uint steps : {2u, 4u, 8u, 16u, 32u}) {
        OcclusionParameters p = fine();
        p.steps = steps;
        points.emplace_back(steps, floorError(camera, OcclusionMethod::hbao, p));
        std::printf("hbao, %u steps: mean absolute error %.4f\n", steps, points.back().second);
    }
    EXPECT_NEAR(slopeOf(points), -1.0, 0.15);
}

// Of the first channel.
static double meanDeviation(const Image& image, const Image& from)
{
    const std::size_t count = std::size_t(image.width) * image.height;
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
        sum += std::abs(double(image.pixels[i * image.channels]) - double(from.pixels[i * from.channels]));
    return sum / double(count);
}

// Points of the hemisphere scatter about their own mean as random ones do, or better: N^-1/2. The mean itself stays off (the study's table).
TEST_F(OcclusionLaws, slowPointsByTheirNumber)
{
    wedge();
    const auto drawn = [&](uint samples) {
        OcclusionParameters p = fine();
        p.samples = samples;
        return visibility(camera, OcclusionMethod::ssao, p);
    };
    const Image limit = drawn(4096);
    std::vector<std::pair<double, double>> points;
    for (const uint samples : {8u, 16u, 32u, 64u, 128u, 256u}) {
        const Image image = drawn(samples);
        points.emplace_back(samples, meanDeviation(image, limit));
        std::printf("ssao, %u points: mean absolute deviation %.4f\n", samples, points.back().second);
    }
    EXPECT_LT(slopeOf(points), -0.5 + 0.15);
}

// Rays scatter about their mean, which the closed forms hold, as independent ones do, or better: they are stratified.
TEST_F(OcclusionLaws, slowRaysByTheirNumber)
{
    if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    wedge();
    size = {64, 64};
    const auto drawn = [&](uint rays) {
        OcclusionParameters p = fine();
        p.rays = rays;
        return visibility(camera, OcclusionMethod::ray, p);
    };
    const Image limit = drawn(1024);
    std::vector<std::pair<double, double>> points;
    for (const uint rays : {2u, 4u, 8u, 16u, 32u, 64u}) {
        const Image image = drawn(rays);
        points.emplace_back(rays, meanDeviation(image, limit));
        std::printf("ray, %u rays: mean absolute deviation %.4f\n", rays, points.back().second);
    }
    EXPECT_LT(slopeOf(points), -0.5 + 0.15);
}

// The error of the cones falls with the edge of a voxel.
TEST_F(OcclusionLaws, slowConesByTheEdgeOfAVoxel)
{
    size = {96, 96};
    floor();
    wall(0, 1);
    const Camera before = lookAt(vec3(-4, 3, 0), vec3(-0.5f, 0, 0), 0.7f);
    std::vector<std::pair<double, double>> points;
    for (const double edge : {0.32, 0.16, 0.08, 0.04, 0.02}) {
        const auto most = std::size_t(10.0 * 10.0 * 1.0 / (edge * edge * edge));
        points.emplace_back(edge, floorError(before, OcclusionMethod::voxel, fine(), most));
        std::printf("voxel, edge %.2f m: mean absolute error %.4f\n", edge, points.back().second);
    }
    EXPECT_NEAR(slopeOf(points), 1.0, 0.15);
}
}
