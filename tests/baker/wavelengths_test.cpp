// Light by wavelength: illuminants against the CIE's tables, and spectral paths against integrals over the spectrum.
// Closed forms, by their names: color.illuminant_xy.
#include "baker/baker.hpp"
#include "baker/daylight.hpp"
#include "baker/wavelengths.hpp"
#include "shaders/spectrum.h"
#include "tests/engine/upload/toy_level.hpp"
#include "tests/shaders/cie_tables.hpp"
#include <functional>
#include <gtest/gtest.h>

namespace afterglow
{
namespace
{
using test::tabledXyz;

const Daylight kWhite(kD65);

// What is seen of white light that reaches the eye by f(wavelength), Rec.709: exactly.
dvec3 seenThrough(const std::function<dvec3(vec3)>& f)
{
    const double step = 0.25; // nm
    dvec3 sum(0.0), white(0.0);
    for (double nm = 360.0 + step / 2; nm < 830.0; nm += step) {
        const dvec3 seen = dvec3(xyzToRec709(colorMatching(float(nm))) * kWhite.at(float(nm)));
        sum += seen * f(primarySpectra(float(nm)));
        white += seen;
    }
    return sum / white;
}
// The spectrum that stands for a colour.
double of(vec3 color, vec3 primaries) { return double(dot(color, primaries)); }

TruthOptions looking(vec3 from, vec3 at, int samples)
{
    TruthOptions options;
    options.camera = lookAt(from, at, 0.1f);
    options.size = ivec2(16, 16);
    options.samples = samples;
    options.spectral = true;
    return options;
}

Image pictureOf(const Scene& scene, const TruthOptions& options)
{
    Progress silent(ProgressStyle::none);
    return truth(scene, options, silent);
}

// Mean of a picture that should be of one colour, four standard errors wide; what the errors themselves are.
dvec3 expectMean(const Image& image, dvec3 wanted, double tolerance = 1e-4)
{
    dvec3 sum(0.0), squares(0.0);
    const double pixels = double(image.width * image.height);
    for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
        const dvec3 pixel(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
        sum += pixel, squares += pixel * pixel;
    }
    const dvec3 mean = sum / pixels, error = sqrt(max(squares / pixels - mean * mean, dvec3(0.0)) / (pixels - 1.0));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], wanted[c], 4.0 * error[c] + tolerance * std::abs(wanted[c])) << "channel " << c;
    return error;
}
}

TEST(Illuminants, HaveTheirChromaticity)
{
    const auto meets = [](const char* name, dvec3 xyz, double x, double y) {
        const vec2 xy = chromaticity(vec3(xyz));
        EXPECT_NEAR(xy.x, x, 2e-5) << name;
        EXPECT_NEAR(xy.y, y, 2e-5) << name;
    };
    const auto day = [](float kelvin) { return tabledXyz([=](double nm) { return double(Daylight(kelvin).at(float(nm))); }); };
    meets("D65", day(kD65), 0.3127115954, 0.3290084044);
    meets("D50", day(5002.8f), 0.34567, 0.35850); // CIE 15, table T.3
    meets("D55", day(5503.1f), 0.33242, 0.34743);
    meets("D75", day(7504.2f), 0.29902, 0.31485);
    // Illuminant A is a black body of 2848 K by the hc/k of 1931, 14350 um K
    const float bulb = 2848.0f * 14387.77f / 14350.0f;
    meets("A", tabledXyz([=](double nm) { return double(planck(float(nm), bulb)); }), 0.4475731972, 0.4074395595);
    meets("E", tabledXyz([](double) { return 1.0; }), 0.3333136203, 0.3332866077);
    meets("F2", tabledXyz([](double nm) {
              const double place = (nm - test::kF2First) / test::kTableStep;
              return place >= 0.0 && place < double(std::size(test::kF2)) ? test::kF2[std::size_t(place)] : 0.0;
          }),
          0.3720655801, 0.3751176955);
    EXPECT_EQ(kWhite.at(560.0f), 1.0f);
    for (float nm : {0.0f, 360.0f, 830.0f, 1e6f}) EXPECT_TRUE(std::isfinite(Daylight(25000.0f).at(nm)));
}

// Every colour comes back as what it was, lit by white light.
TEST(Wavelengths, StandForTheColourThatTheyCameFrom)
{
    for (const vec3 color : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(0.8f, 0.4f, 0.2f), vec3(0.5f)}) {
        const dvec3 seen = seenThrough([=](vec3 primaries) { return dvec3(of(color, primaries)); });
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen[c], color[c], 2e-6);
    }
}

// H92: all that shines is met, in the mean over the choice: white, a colour, and lines of 1 nm, which a grid of 10 nm misses or takes for
// 10.
TEST(Wavelengths, AreDrawnWithoutBias)
{
    const int draws = 1 << 17;
    const float lines[] = {574.5f, 580.0f};
    const vec3 color(0.2f, 0.9f, 0.4f);
    dvec3 white(0.0), tinted(0.0), lit[2] = {dvec3(0.0), dvec3(0.0)};
    for (int i = 0; i < draws; ++i) {
        const Wavelengths at = drawWavelengths((float(i) + 0.5f) / float(draws));
        white += dvec3(whiteSeen(at)) / double(draws);
        tinted += dvec3(at.seen * (at.power * color)) / double(draws);
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(at.nm[c] >= kViolet && at.nm[c] <= kDeepRed);
            for (int l = 0; l < 2; ++l)
                if (std::abs(at.nm[c] - lines[l]) < 0.5f) lit[l] += dvec3(at.seen[c]) / double(draws);
        }
    }
    dvec3 whole(0.0), exact[2] = {dvec3(0.0), dvec3(0.0)};
    for (double nm = 360.05; nm < 830.0; nm += 0.1) {
        const dvec3 seen(xyzToRec709(colorMatching(float(nm))));
        whole += seen * double(kWhite.at(float(nm)));
        for (int l = 0; l < 2; ++l)
            if (std::abs(nm - double(lines[l])) < 0.5) exact[l] += seen;
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(white[c], 1.0, 1e-5);
        EXPECT_NEAR(tinted[c], color[c], 1e-5);
        for (int l = 0; l < 2; ++l) EXPECT_NEAR(lit[l][c], exact[l][c] / whole[c], 1e-3 * std::abs(exact[l][c] / whole[c])) << lines[l];
    }
}

// The quotient of what came in and what white would have brought is grey where all is grey, however few the paths; of a colour it is off by
// what few wavelengths make of it (baker/reference.cpp says how much). No chance is in this: all first wavelengths in turn.
TEST(Wavelengths, OfFewPathsAreOffByLittle)
{
    constexpr int kFirsts = 1 << 14;
    const std::pair<int, double> kStated[] = {{2, 5e-3}, {4, 4e-4}, {8, 2e-5}};
    for (const auto& [paths, stated] : kStated) {
        double worst = 0.0;
        for (const vec3 color : {vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1), vec3(1, 1, 0), vec3(0, 1, 1), vec3(1, 0, 1)}) {
            dvec3 mean(0.0);
            for (int first = 0; first < kFirsts; ++first) {
                dvec3 sum(0.0), white(0.0);
                for (int i = 0; i < paths; ++i) {
                    const Wavelengths at = drawWavelengths(((float(first) + 0.5f) / kFirsts + float(i)) / float(paths));
                    sum += dvec3(at.seen * (at.power * color));
                    white += dvec3(whiteSeen(at));
                }
                mean += sum / white / double(kFirsts);
            }
            for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(mean[c] - double(color[c])));
        }
        EXPECT_LE(worst, stated) << paths;
        EXPECT_GE(worst, 0.3 * stated) << paths << ": the comment says too much";
    }
}

// A white floor under a white sky sends back what it gets: every pixel, by however few paths.
TEST(SpectralPaths, KeepAWhiteFurnaceWhite)
{
    Scene scene;
    addMaterial(scene, matte(vec3(1.0f)));
    addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), 0);
    scene.sky.radiance = vec3(1.0f);
    for (const int samples : {1, 5, 64})
        for (const float value : pictureOf(scene, looking(vec3(0, 2, 0), vec3(0), samples)).pixels) EXPECT_NEAR(value, 1.0f, 2e-6f);
}

// Grey surfaces, fog and glass in white light: nothing that three channels would not know. Path by path the two are alike, and differ by
// how a path's wavelengths weigh it.
TEST(SpectralPaths, AgreeWithThreeChannelsWhereAllIsGrey)
{
    for (const char* name : {"closed_box", "fog_furnace", "furnace_clutter", "glass_slab", "mirror_corridor", "parallel_plates",
                             "rectangle_light", "sphere_point_light", "sun_plane"}) {
        SCOPED_TRACE(name);
        const Scene scene = loadLevel(std::string("content/truth/") + name + ".glb");
        TruthOptions options = looking(vec3(0), vec3(1), 32);
        options.camera = findCamera(scene, "");
        options.spectral = false;
        const Image three = pictureOf(scene, options);
        options.spectral = true;
        Image difference = pictureOf(scene, options);
        for (std::size_t i = 0; i < three.pixels.size(); ++i) difference.pixels[i] += 1.0f - three.pixels[i];
        expectMean(difference, dvec3(1.0), 1e-5);
    }
}

// A coloured light on a grey floor, and a white one on a coloured floor, are what they are with three channels.
TEST(SpectralPaths, KeepAColourThatMeetsWhite)
{
    const vec3 color(0.7f, 0.3f, 0.1f);
    for (const bool lit : {false, true}) {
        Scene scene;
        addMaterial(scene, matte(lit ? vec3(0.5f) : color));
        addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), 0);
        scene.sky.radiance = lit ? color : vec3(0.5f);
        expectMean(pictureOf(scene, looking(vec3(0, 2, 0), vec3(0), 64)), 0.5 * dvec3(color), 1e-3);
    }
}

// A furnace of colour: light that is reflected ever again is purer by wavelength than by channel, L = Le / (1 - rho).
TEST(SpectralPaths, ReflectByWavelength)
{
    Scene scene = loadLevel("content/truth/furnace.glb");
    const vec3 albedo(0.8f, 0.6f, 0.2f);
    for (Material& material : scene.materials) material.emission = vec3(0.5f), material.baseColor = vec4(albedo, 1.0f);
    TruthOptions options = looking(vec3(0), vec3(1), 256);
    options.camera = scene.cameras.at(0);
    const dvec3 exact = seenThrough([=](vec3 primaries) { return dvec3(0.5 / (1.0 - of(albedo, primaries))); });
    const dvec3 error = expectMean(pictureOf(scene, options), exact, 1e-3);
    // By three channels it would be something else, beyond what chance explains
    EXPECT_GT(std::abs(0.5 / (1.0 - double(albedo.y)) - exact.y), 8.0 * error.y);
}

// What fog and panes of glass swallow: along the camera's ray and on the way from a lamp alike.
TEST(SpectralPaths, AreSwallowedByWavelength)
{
    const vec3 absorption(0.1f, 0.6f, 1.5f), tint(0.9f, 0.5f, 0.3f);
    Scene scene;
    Material lamp = matte(vec3(0.0f));
    lamp.emission = vec3(1.0f);
    addMaterial(scene, lamp);
    addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), 0);
    Medium fog{};
    fog.absorption = absorption, fog.lower = vec3(-99, 0.5f, -99), fog.upper = vec3(99, 1.5f, 99);
    scene.media = {fog};
    expectMean(pictureOf(scene, looking(vec3(0, 2, 0), vec3(0), 64)),
               seenThrough([=](vec3 primaries) { return dvec3(std::exp(-of(absorption, primaries))); }), 1e-3);

    // Two panes of one tint over a white floor in the sun
    scene.media = {};
    scene.materials[0] = matte(vec3(1.0f));
    Material pane = matte(tint);
    pane.flags = 0, pane.roughness = 0.0f, pane.transmission = 1.0f, pane.specular = 0.0f;
    const uint glass = addMaterial(scene, pane);
    for (const float height : {0.5f, 0.7f}) addQuad(scene, vec3(-9, height, -9), vec3(0, 0, 18), vec3(18, 0, 0), glass);
    Light sun{};
    sun.type = kLightDirectional;
    sun.direction = vec3(0, -1, 0);
    sun.intensity = vec3(kPi);
    scene.lights = {sun};
    const dvec3 twice = seenThrough([=](vec3 primaries) { return dvec3(std::pow(of(tint, primaries), 2.0)); });
    expectMean(pictureOf(scene, looking(vec3(0, 0.4f, 0), vec3(0), 64)), twice, 1e-3); // below them
    const dvec3 fourTimes = seenThrough([=](vec3 primaries) { return dvec3(std::pow(of(tint, primaries), 4.0)); });
    expectMean(pictureOf(scene, looking(vec3(0, 2, 0), vec3(0), 64)), fourTimes, 1e-3); // through them
}

// A light that says its temperature has the spectrum of a black body: its colour on white, and not that of its own colour's on green.
TEST(SpectralPaths, MeetABlackBody)
{
    const float kelvin = 2856.0f;
    for (const vec3 albedo : {vec3(1.0f), vec3(0.05f, 0.9f, 0.1f)}) {
        Scene scene;
        addMaterial(scene, matte(albedo));
        addQuad(scene, vec3(-9, 0, -9), vec3(0, 0, 18), vec3(18, 0, 0), 0);
        Light sun{};
        sun.type = kLightDirectional;
        sun.direction = vec3(0, -1, 0);
        sun.intensity = kPi * blackbodyColor(kelvin);
        scene.lights = {sun};
        scene.hotLights[0] = {kelvin, vec3(kPi / blackbodyXyz(kelvin).y)};
        dvec3 sum(0.0), white(0.0);
        double hot = 0.0;
        for (double nm = 360.125; nm < 830.0; nm += 0.25) {
            const dvec3 xyz(colorMatching(float(nm))), seen(xyzToRec709(vec3(xyz)));
            const double power = double(planck(float(nm), kelvin));
            sum += seen * (power * of(albedo, primarySpectra(float(nm))));
            hot += xyz.y * power;
            white += seen * double(kWhite.at(float(nm)));
        }
        const double unit = double(luminance(vec3(white))) / hot;
        expectMean(pictureOf(scene, looking(vec3(0, 2, 0), vec3(0), 64)), sum * unit / white, 1e-3);
        if (albedo != vec3(1.0f)) continue;
        // What three channels show, but for the fit's own white
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c] * unit / white[c] / double(blackbodyColor(kelvin)[c]), 1.0, 4e-3);
    }
}
}
