// A level that is baked, changed, and baked again on what the first bake kept.
#pragma once
#include "baker/journal.hpp"
#include "bits.hpp"
#include "engine/core/file.hpp"
#include "rooms.hpp"
#include <nlohmann/json.hpp>

namespace afterglow
{
struct Made {
    Baked baked;
    nlohmann::json told;
    std::uint64_t rays = 0;
    double error() const { return told["products"]["lightmaps"]["estimated_error"]; }
    double kept() const { return told["products"]["lightmaps"]["kept"]; }
};

inline Made make(const Scene& scene, const BakeOptions& options, Journal* journal = nullptr, const Journal* earlier = nullptr)
{
    Progress silent(ProgressStyle::none);
    Made made;
    made.baked = bakeScene(scene, options, silent, made.told, journal, earlier);
    made.rays = made.told["rays"];
    return made;
}

struct Again {
    Made again, anew;
};

// The second bake, on top of the first and from nothing. For any number of threads, and from any place where it was stopped.
inline Again bakeAgain(const Scene& before, const Scene& after, const BakeOptions& options)
{
    const std::string key(64, 'k');
    const Ground ground("before"), second("after"), third("stopped");
    Journal first(ground.place, key, Journal::Start::afresh);
    make(before, options, &first);
    const Journal earlier(ground.file);
    Journal journal(second.place, key, Journal::Start::afresh);
    Again made{make(after, options, &journal, &earlier), make(after, options)};

    BakeOptions alone = options;
    alone.threads = 1;
    EXPECT_EQ(bitsOf(make(after, alone, nullptr, &earlier).baked), bitsOf(made.again.baked)) << "of one thread";
    Contents half = readFile(second.file);
    half.resize(half.size() / 2);
    writeFile(third.file, half.data(), half.size());
    testing::internal::CaptureStderr(); // it says that it resumes
    Journal resumed(third.place, key, Journal::Start::resume);
    testing::internal::GetCapturedStderr();
    EXPECT_EQ(bitsOf(make(after, options, &resumed, &earlier).baked), bitsOf(made.again.baked)) << "resumed";
    const Made once = make(after, options, nullptr, std::make_unique<const Journal>(second.file).get());
    EXPECT_EQ(once.rays, 0u) << "what it kept serves the next one";
    EXPECT_EQ(bitsOf(once.baked), bitsOf(made.again.baked));
    EXPECT_EQ(once.error(), made.again.error());
    return made;
}

// Relative RMSE of the baked texels of one against another.
inline double offBy(const Baked& one, const Baked& other)
{
    double squares = 0.0, sum = 0.0, texels = 0.0;
    for (std::size_t p = 0; p < other.lightmaps.size(); p++)
        for (std::size_t t = 0; t < other.lightmaps[p].texels.size(); t++) {
            if (other.lightmaps[p].valid[t] != 1) continue;
            const dvec3 b(other.lightmaps[p].texels[t]), d = dvec3(one.lightmaps[p].texels[t]) - b;
            squares += dot(d, d) / 3.0;
            texels++;
            sum += (b.x + b.y + b.z) / 3.0;
        }
    return std::sqrt(squares / texels) / (sum / texels);
}

// Of lightmaps alone, not filtered: the error that is stated is theirs.
inline BakeOptions lightmapsOnly(int samples)
{
    BakeOptions options;
    options.quality = Quality::draft;
    options.texelsPerMetre = 4.0f;
    options.samples = samples;
    options.probes = options.reflections = options.lods = options.voxels = false;
    options.denoiser = Denoiser::none;
    options.threads = 2;
    return options;
}

inline Light lampAt(vec3 position, vec3 intensity, uint bake = kBakeAll)
{
    Light light{};
    light.type = kLightPoint;
    light.position = position;
    light.direction = vec3(0, -1, 0);
    light.intensity = intensity;
    light.bake = bake;
    return light;
}
}
