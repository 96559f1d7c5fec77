// This work is based on: Iwanicki 2013 ("Lighting Technology of The Last of Us": least squares over the texels of seams).
#include "baker/stitch.hpp"
#include "engine/core/log.hpp"
#include "shaders/exposure.h"
#include "shaders/lightmap.h"
#include <cmath>
#include <Eigen/SparseCholesky>

namespace afterglow
{
namespace
{
using Matrix = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

constexpr double kStep = 0.25; // steps of a display: what may be left at a point counts like one standard error of a texel
// Of how light bends from texel to texel: by so much do two chains of chords about one parabola differ along an edge, root mean square, where
// their texels lie otherwise. Without it charts of few texels go flat to agree.
constexpr double kBlur = 0.125;
constexpr double kGuess = 0.25;          // of the light: standard error of a dilated texel
constexpr double kRounding = 1.0 / 1024; // of the light: a texel's file knows it no better
constexpr double kGuessSigmas = 4.0;     // standard errors that one may be off: all of the light
constexpr double kSigmas = 3.0;          // standard errors that noise explains
constexpr double kHeld = 1e6;            // times the trust in a texel that may go no further
constexpr int kRounds = 8;               // of holding texels: after the first few hardly any is left

// How well a texel is known.
struct Known {
    double error; // standard error
    double most;  // by how much it may move
};
}

// By how much light may change around a value before a display shows it. Above middle grey it is a share of the light: what is brighter is
// looked at with less exposure, or on a darker surface.
static double tolerance(const Shown& shown, float light)
{
    const float grey = kMiddleGrey / shown.exposure, here = clamp(light, 1e-3f * grey, grey), h = 0.01f * here;
    const float slope = (shown(vec3(here + h)).x - shown(vec3(here - h)).x) / (2.0f * h);
    return double(max(light / here, 1.0f) / slope);
}

static double tolerance(const Shown& shown, vec3 light)
{
    return min(min(tolerance(shown, light.x), tolerance(shown, light.y)), tolerance(shown, light.z));
}

// A row for each point: the difference of its lookups, in what may be left of it.
static Rows differences(const std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown)
{
    Rows rows(Eigen::Index(seams.points.size()), Eigen::Index(seams.texels.size()));
    rows.reserve(Eigen::VectorXi::Constant(rows.rows(), 8));
    for (std::size_t p = 0; p < seams.points.size(); p++) {
        const SeamPoint& point = seams.points[p];
        vec3 light(0.0f);
        double bend = 0.0;
        for (const Lookup& side : point.side) {
            light += 0.5f * lookup(pages[side.page], side.at);
            for (const Weighted& w : footprint(seams, side)) bend += 0.5 * double(w.weight * seams.texels[w.texel].bend);
        }
        const double weight = std::sqrt(double(point.share)) / (kStep * tolerance(shown, light) + kBlur * bend);
        for (int s = 0; s < 2; s++)
            for (const Weighted& w : footprint(seams, point.side[s]))
                rows.coeffRef(Eigen::Index(p), Eigen::Index(w.texel)) += (s == 0 ? weight : -weight) * double(w.weight);
    }
    return rows;
}

// The brightest light at the points that a texel takes part in. Were it its own light, the bright side of a step would give way to the dark.
static std::vector<double> lightAbout(const std::vector<Lightmap>& pages, const Seams& seams, double least)
{
    std::vector<double> light(seams.texels.size(), least);
    for (const SeamPoint& point : seams.points) {
        double brightest = 0.0;
        for (const Lookup& side : point.side) brightest = max(brightest, double(luminance(lookup(pages[side.page], side.at))));
        for (const Lookup& side : point.side)
            for (const Weighted& w : footprint(seams, side)) light[w.texel] = max(light[w.texel], brightest);
    }
    return light;
}

static std::vector<Known> knownOf(const std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown)
{
    const std::vector<double> light = lightAbout(pages, seams, tolerance(shown, 0.0f));
    std::vector<Known> known;
    for (std::size_t i = 0; i < seams.texels.size(); i++) {
        const SeamTexel& texel = seams.texels[i];
        // The mean of a part of it lies up to half a texel from its middle
        const double noise = std::hypot(std::sqrt(double(texel.variance)), kRounding * light[i]),
                     off = double((1.0f - texel.share) * texel.spread);
        known.push_back(texel.measured ? Known{std::hypot(noise, off), kSigmas * noise + off}
                                       : Known{kGuess * light[i], kGuessSigmas * kGuess * light[i]});
    }
    return known;
}

// Of all texels, a column for each channel.
static Eigen::MatrixXd valuesOf(const std::vector<Lightmap>& pages, const Seams& seams)
{
    const bool directional = !pages.front().direction.empty();
    Eigen::MatrixXd values(Eigen::Index(seams.texels.size()), directional ? 7 : 3);
    for (std::size_t i = 0; i < seams.texels.size(); i++) {
        const Lightmap& page = pages[seams.texels[i].page];
        for (int c = 0; c < 3; c++) values(Eigen::Index(i), c) = double(page.texels[seams.texels[i].texel][c]);
        for (int c = 0; directional && c < 4; c++) values(Eigen::Index(i), 3 + c) = double(page.direction[seams.texels[i].texel][c]);
    }
    return values;
}

static void write(const Eigen::MatrixXd& values, const Seams& seams, std::vector<Lightmap>& pages)
{
    for (std::size_t i = 0; i < seams.texels.size(); i++) {
        const SeamTexel& texel = seams.texels[i];
        const Eigen::RowVectorXf row = values.row(Eigen::Index(i)).cast<float>();
        pages[texel.page].texels[texel.texel] = max(vec3(row[0], row[1], row[2]), vec3(0.0f));
        if (row.size() == 3) continue;
        vec4& direction = pages[texel.page].direction[texel.texel];
        direction = vec4(row[3], row[4], row[5], row[6]);
        if (texel.measured) direction = directionAbout(vec3(direction), texel.normal);
    }
}

// By how much the channel that changes most does.
static double movedBy(const Eigen::MatrixXd& before, const Eigen::MatrixXd& after, Eigen::Index texel)
{
    return (after.row(texel) - before.row(texel)).head(3).cwiseAbs().maxCoeff();
}

// Texels that `after` takes too far are aimed at as far as they may go, and held there; whether there were any.
static bool hold(const std::vector<Known>& known, const Eigen::MatrixXd& before, const Eigen::MatrixXd& after, Eigen::MatrixXd& aim,
                 Eigen::VectorXd& trust)
{
    bool any = false;
    for (Eigen::Index i = 0; i < before.rows(); i++) {
        const double moved = movedBy(before, after, i), most = known[std::size_t(i)].most;
        const bool isHeld = aim.row(i) != before.row(i);
        if (isHeld || !(moved > most)) continue;
        aim.row(i) = before.row(i) + most / moved * (after.row(i) - before.row(i));
        trust[i] *= kHeld;
        any = true;
    }
    return any;
}

void stitch(std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown)
{
    if (seams.points.empty()) return;
    const Rows rows = differences(pages, seams, shown);
    const std::vector<Known> known = knownOf(pages, seams, shown);
    const Eigen::MatrixXd before = valuesOf(pages, seams);
    Eigen::MatrixXd aim = before, after;
    Eigen::VectorXd trust(before.rows());
    for (std::size_t i = 0; i < known.size(); i++) trust[Eigen::Index(i)] = 1.0 / (known[i].error * known[i].error);

    const Matrix steps = Matrix(rows.transpose()) * Matrix(rows);
    Eigen::SimplicialLDLT<Matrix> solver;
    bool begun = false;
    for (int round = 0; round < kRounds; round++) {
        const Matrix normal = steps + Matrix(trust.asDiagonal());
        if (!begun) solver.analyzePattern(normal), begun = true;
        solver.factorize(normal);
        if (solver.info() != Eigen::Success) {
            warning("the seams of the lightmaps are left as they are: their equations could not be solved");
            return;
        }
        after = solver.solve(Eigen::MatrixXd(trust.asDiagonal() * aim));
        if (!hold(known, before, after, aim, trust)) break;
    }
    for (Eigen::Index i = 0; i < after.rows(); i++) // those that the last round found, and what holding left
        if (const double moved = movedBy(before, after, i), most = known[std::size_t(i)].most; moved > most)
            after.row(i) = before.row(i) + most / moved * (after.row(i) - before.row(i));
    write(after, seams, pages);
}
}
