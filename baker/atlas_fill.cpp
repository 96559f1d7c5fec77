#include "baker/atlas_fill.hpp"
#include "engine/core/error.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
constexpr int kTrials = 6;                  // of the search for a density
constexpr int kMostTrials = 40;             // while nothing has fitted
constexpr double kFull = 0.995;             // of the pages, by height: what is left is not worth a trial
constexpr double kAimed = 0.998;            // of them, by the next trial: packing has its whims
constexpr double kSolved = 0.001;           // of a density: two that are nearer are not told apart
constexpr double kTooLarge = 2.0;           // times a page: a chart that no page holds
constexpr double kPressed = 0.004;          // of a density: what pressing tries to add, at first
constexpr double kLeastStep = kPressed / 4; // once it has failed
constexpr double kMoves = 0.05;             // of one footprint, for every triangle: what took long to unroll may take long to press
constexpr int kFewMoves = 10;               // of each footprint: too few to press them
constexpr double kDense = 0.8;              // of a page: once so much is taken, pressing costs more than it brings

// Of its pages, how much a layout uses: above 1 it does not fit.
double usedOf(const Pages& pages, int count, int edge)
{
    double rows = 0.0, highest = 0.0;
    for (const ivec2& size : pages.sizes) rows += size.y, highest = max(highest, double(size.y));
    return max(rows / (double(count) * edge), highest > edge ? highest / edge : 0.0);
}

struct Filled {
    double factor = 0.0; // on all densities
    Pages pages;
};

bool setOnTexels(std::vector<UnwrappedMesh>& meshes, double factor, int padding, const PageLimits& limits)
{
    return std::all_of(meshes.begin(), meshes.end(), [&](UnwrappedMesh& mesh) { return setOnTexels(mesh, factor, padding, limits); });
}

// What is used grows as the factor's square, but for the whims of packing: from every trial follows the next one.
Filled pack(std::vector<UnwrappedMesh>& meshes, std::size_t objects, int padding, int count, const PageLimits& limits)
{
    double fits = 0.0, spills = 0.0, factor = 1.0;
    int spilled = 0; // trials in a row
    Pages best;
    for (int trial = 0; trial < kMostTrials && (fits == 0.0 || trial < kTrials); ++trial) {
        const bool flat = setOnTexels(meshes, factor, padding, limits);
        const Pages pages = flat ? fillPages(wantedBy(meshes, objects), count, limits) : Pages{};
        const double used = flat ? usedOf(pages, count, limits.edge) : kTooLarge;
        if (used <= 1.0)
            fits = factor, best = pages, spilled = 0;
        else
            spills = factor, ++spilled;
        if (used <= 1.0 && used > kFull) break;
        double next = factor * std::sqrt(kAimed / used);
        const bool known = next < fits * (1 + kSolved) || next > spills * (1 - kSolved);
        if (fits > 0.0 && spills > 0.0 && (known || spilled > 1)) next = 0.5 * (fits + spills);
        if (fits == 0.0) next = min(next, spills * (1 - kSolved));
        if (fits > 0.0 && next < fits * (1 + kSolved)) break;
        factor = next;
    }
    if (fits == 0.0) throw Error("the level falls into too many pieces for its lightmap pages: ask for more or larger ones");
    return {fits, best};
}

// Part of the pages that is taken.
double takenOf(const std::vector<Footprints>& wanted, const Pages& pages)
{
    double taken = 0.0, all = 0.0;
    for (const Footprints& footprints : wanted) taken += footprintArea(footprints);
    for (const ivec2& size : pages.sizes) all += double(size.x) * size.y;
    return all > 0.0 ? taken / all : 1.0;
}

// Ever denser, by smaller steps once the footprints resist, until patience ends.
void press(Filled& filled, std::vector<UnwrappedMesh>& meshes, std::size_t objects, int padding, const PageLimits& limits)
{
    Patience patience{0};
    std::size_t footprints = 0;
    for (const UnwrappedMesh& mesh : meshes) patience.moves += int(kMoves * mesh.surface.triangles());
    for (const Footprints& of : wantedBy(meshes, objects)) footprints += of.size();
    if (patience.moves < kFewMoves * int(footprints)) return;
    for (double step = kPressed; patience.moves > 0;) {
        const double factor = filled.factor * (1 + step);
        if (!setOnTexels(meshes, factor, padding, limits) || takenOf(wantedBy(meshes, objects), filled.pages) > kDense) return;
        const int left = patience.moves;
        if (std::optional<Pages> pages = pressPages(wantedBy(meshes, objects), filled.pages, 1 + step, patience))
            filled = {factor, std::move(*pages)};
        else if (step > kLeastStep || patience.moves < left)
            step = max(step / 2, kLeastStep);
        else
            return;
    }
}
}

// What each object asks of a page: its charts, or the one rectangle of its shared mesh.
std::vector<Footprints> wantedBy(const std::vector<UnwrappedMesh>& meshes, std::size_t objects)
{
    std::vector<Footprints> wanted(objects);
    for (const UnwrappedMesh& mesh : meshes)
        for (std::size_t user = 0; user < mesh.objects.size(); ++user) {
            Footprints& footprints = wanted[mesh.objects[user]];
            if (mesh.shared())
                footprints.push_back(&mesh.rectangles[user]);
            else
                for (const FlatChart& chart : mesh.charts) footprints.push_back(&chart.footprint);
        }
    return wanted;
}

Pages fill(std::vector<UnwrappedMesh>& meshes, std::size_t objects, int padding, int count, const PageLimits& limits)
{
    Filled filled = pack(meshes, objects, padding, count, limits);
    for (ivec2& size : filled.pages.sizes) size = ivec2(limits.edge);
    setOnTexels(meshes, filled.factor, padding, limits);
    if (takenOf(wantedBy(meshes, objects), filled.pages) > kDense) return filled.pages;
    press(filled, meshes, objects, padding, limits);
    setOnTexels(meshes, filled.factor, padding, limits);
    return filled.pages;
}
}
