// What points are held against.
#include <fmt/format.h> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/study/studio.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
constexpr int kBakedFrames = 3; // of another bake: it is the bake that is timed

const Truth& visibilityOf(Studio& studio)
{
    if (studio.visibility) return *studio.visibility;
    TruthOptions options = studio.standard.truth;
    options.ao = true;
    options.aoRange = studio.standard.settings.occlusion.range;
    const auto traced = [&](std::uint32_t seed) {
        Progress unseen(ProgressStyle::none);
        options.seed = seed;
        return channels(truth(studio.level, options, unseen), 0, 1);
    };
    studio.visibility = truthOf(traced(kSeedA), traced(kSeedB));
    return *studio.visibility;
}

Image meanPicture(const std::vector<Image>& pictures)
{
    Image mean = pictures.front();
    for (std::size_t i = 0; i < mean.pixels.size(); ++i) {
        double sum = 0.0;
        for (const Image& picture : pictures) sum += double(picture.pixels[i]);
        mean.pixels[i] = float(sum / double(pictures.size()));
    }
    return mean;
}

// The same with the knob at its limit: without noise, as far as its frames average it out.
Truth limitOf(Studio& studio, const Sweep& sweep, std::optional<Stage>& kept)
{
    Setup setup = given(studio, sweep);
    const double limit = sweep.relative ? sweep.limit * sweep.turn.get(setup) : sweep.limit;
    if (sweep.instead) sweep.instead(setup);
    Image picture;
    if (!sweep.made) sweep.turn.set(setup, limit);
    if (sweep.made) {
        picture = sweep.made(studio, limit);
    } else if (sweep.clock == Clock::truth) {
        return truthOf(traced(studio, setup, kSeedA), traced(studio, setup, kSeedB));
    } else if (sweep.clock == Clock::bake) {
        double unasked = 0.0;
        picture = meanPicture(baked(studio, sweep, setup, unasked).pictures);
    } else {
        setup = drawable(setup, sweep);
        if (!kept || !sweep.staged) kept = makeStage(studio.gpu, studio.baked.scene, &studio.baked, setup.settings);
        picture = meanPicture(draw(studio.executor, *kept, setup, sweep, sweep.frames).pictures);
    }
    return truthOf(picture, picture);
}
}

Setup given(const Studio& studio, const Sweep& sweep)
{
    Setup setup = studio.standard;
    if (sweep.given) sweep.given(setup);
    if (sweep.held == Held::picture) // which no path tracer draws in a style
        for (const char* style : {"toon", "outline"}) setup.settings.effects.forced[style] = false;
    return setup;
}

Image traced(const Studio& studio, Setup setup, std::uint32_t seed)
{
    Progress unseen(ProgressStyle::none);
    setup.truth.seed = seed;
    return truth(studio.level, setup.truth, unseen);
}

Shots baked(Studio& studio, const Sweep& sweep, const Setup& asked, double& ms)
{
    const Setup setup = drawable(asked, sweep);
    const std::string product = sweep.product.empty() ? sweep.subject : sweep.product;
    const auto [known, isNew] = studio.editions.try_emplace(editionOf(setup.bake, product));
    Edition& edition = known->second;
    if (isNew) {
        const Baked bake = rebaked(studio, setup, product, edition.ms);
        Stage stage = makeStage(studio.gpu, bake.scene, &bake, setup.settings);
        edition.shots = draw(studio.executor, stage, setup, sweep, std::min(studio.frames, kBakedFrames));
    }
    ms = edition.ms;
    return edition.shots;
}

bool takesTurns(const Sweep& sweep) { return !sweep.made && sweep.clock != Clock::truth && sweep.clock != Clock::bake; }

Truth truthFor(Studio& studio, const Sweep& sweep, std::optional<Stage>& kept)
{
    if (sweep.held == Held::visibility) return visibilityOf(studio);
    if (sweep.held == Held::picture) return studio.picture;
    if (sweep.against.empty()) return limitOf(studio, sweep, kept);
    const auto known = studio.limits.find(sweep.against);
    return known != studio.limits.end() ? known->second : studio.limits[sweep.against] = limitOf(studio, sweep, kept);
}

std::string truthName(const Studio& studio, const Sweep& sweep)
{
    if (!sweep.against.empty()) return sweep.against;
    switch (sweep.held) {
    case Held::picture:
        return fmt::format("the path-traced picture, twice {} paths a pixel", studio.standard.truth.samples);
    case Held::visibility:
        return fmt::format("path-traced visibility within {:g} m, twice {} rays a pixel", studio.standard.settings.occlusion.range,
                           studio.standard.truth.samples);
    default:
        const Setup setup = given(studio, sweep);
        return fmt::format("the same at {} {:.3g}", sweep.knob, sweep.relative ? sweep.limit * sweep.turn.get(setup) : sweep.limit);
    }
}
}
