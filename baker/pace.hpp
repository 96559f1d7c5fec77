// How fast this machine bakes a level, by a short trial, and the finest bake that fits a time. What is chosen is plain options: the bake is
// then the same bits as with them said on the command line, on however many threads.
#pragma once
#include "baker/pace_error.hpp"

namespace afterglow
{
// Seconds, and what they are spent on.
struct Pace {
    double fixed = 0.0; // the level, its atlas, its levels of detail, where its reflection probes stand: whatever is asked for
    double texel = 0.0; // a lightmap's, however many paths it has
    double path = 0.0;  // of a texel
    double probe = 0.0, probePath = 0.0;
    double reflection = 0.0, reflectionPath = 0.0; // of a face's texel
    double texels = 0.0;                           // at 1 texel a metre
    double probes = 0.0;                           // at 1 m
    double reflections = 0.0;                      // cubemaps
    double between = 0.0;                          // what the light between these errs by, relative: as the square of their spacing
    PaceError error;                               // of the lightmaps
    double noise = 0.0;                            // of lookups with one path a probe, relative
};

// `options`: resolved.
double secondsOf(const Pace& pace, const BakeOptions& options);

struct Paced {
    BakeOptions options; // resolved
    double seconds = 0.0;
    bool fits = false;
};

// `finest`: resolved, the finest quality first. Of those that fit with at least a quarter of a quality's paths, at its density or at less,
// the one with the least error; the finest where no error is known. The time that it leaves over goes to its lightmaps, as many paths and
// texels as the finest quality has, or paths alone where no error is known. Where none fits, the last with a quarter of its paths and fewer texels,
// down to kFewestTexels.
Paced within(const Pace& pace, const std::vector<BakeOptions>& finest, double seconds);
constexpr double kFewestTexels = 1.0 / 64.0;

// Of its trials the second to fourth, which tell what goes by paths, are not begun where they would take half of `seconds`.
Pace paceOf(const Scene& scene, const BakeOptions& asked, double seconds, Progress& progress);

// Both of them, for a bake of which all is done in `seconds`, the trial included and a margin left; says what it chose, as words of the
// command line. Quality is `asked`'s at the most.
BakeOptions paced(const Scene& scene, const BakeOptions& asked, double seconds, Progress& progress, nlohmann::json& manifest);
constexpr double kPaceMargin = 0.15; // of the time: files to write, clocks that scatter
}
