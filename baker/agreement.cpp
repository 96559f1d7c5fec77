// This work is based on: Iwanicki 2013 ("Lighting Technology of The Last of Us": least squares over the texels of seams), Lawson 1961
// ("Contributions to the theory of linear least maximum approximation": weights that grow with what is left bound the largest of it).
#include "baker/agreement.hpp"
#include <algorithm>
#include <Eigen/SparseCholesky>

namespace afterglow
{
namespace
{
using Matrix = Eigen::SparseMatrix<double>;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPower = 2.0;                        // of the factor by which a weight grows; Lawson's is 1
constexpr double kMostGrowth = 8.0, kMostGrown = 1e8; // of a weight, in a round and in all: beyond it doubles have no digits left
constexpr double kHeld = 1e6;                         // times the trust in a texel that would be negative
constexpr double kLifted = 1e-6;                      // of the brightest texel: a pull by less is rounding
constexpr int kRounds = 24;                           // at most

VectorXd trustIn(const std::vector<double>& errors)
{
    VectorXd trust(Index(errors.size()));
    for (std::size_t i = 0; i < errors.size(); i++) trust[Index(i)] = 1.0 / (errors[i] * errors[i]);
    return trust;
}

// (D'WD + T) x = T m: D, the differences of lookups; W and T, how much those and the measured values m count.
class Equations
{
public:
    Equations(const SeamPatch& patch, const Asked& asked)
    {
        for (int s = 0; s < 2; s++) {
            std::vector<Eigen::Triplet<double>> entries;
            for (std::size_t p = 0; p < patch.points.size(); p++)
                for (const Weighted& w : patch.side[s][p])
                    if (w.weight > 0.0f) entries.emplace_back(int(p), int(w.texel), double(w.weight));
            side[s].resize(Index(patch.points.size()), Index(patch.texels.size()));
            side[s].setFromTriplets(entries.begin(), entries.end());
        }
        differences_ = side[0] - side[1];
        weight = trustIn(asked.left);
        trust = trustIn(asked.error);
    }

    VectorXd solve(const VectorXd& aim) const { return solver_.solve(VectorXd(trust.cwiseProduct(aim))); }

    // Of the points on each texel, against its value.
    VectorXd pull(const VectorXd& values) const { return differences_.transpose() * VectorXd(weight.cwiseProduct(differences_ * values)); }

    // After a change of weights or trust; false: doubles cannot tell a solution.
    bool factorize()
    {
        const Matrix normal =
            Matrix(Matrix(differences_.transpose()) * weight.asDiagonal() * Matrix(differences_)) + Matrix(trust.asDiagonal());
        if (!begun_) solver_.analyzePattern(normal), begun_ = true;
        solver_.factorize(normal);
        return solver_.info() == Eigen::Success;
    }

    Rows side[2];
    VectorXd weight, trust;

private:
    Rows differences_;
    Eigen::SimplicialLDLT<Matrix> solver_;
    bool begun_ = false;
};

// What was asked of the texels before any was held.
struct Measured {
    VectorXd values, trust;
};
}

static VectorXd vectorOf(const std::vector<double>& values) { return VectorXd::Map(values.data(), Index(values.size())); }
static std::vector<double> valuesOf(const VectorXd& vector) { return {vector.begin(), vector.end()}; }

std::vector<std::vector<double>> likeliest(const SeamPatch& patch, const Asked& asked, const std::vector<std::vector<double>>& measured)
{
    Equations equations(patch, asked);
    if (!equations.factorize()) return measured;
    std::vector<std::vector<double>> values;
    for (const std::vector<double>& channel : measured) values.push_back(valuesOf(equations.solve(vectorOf(channel))));
    return values;
}

// Makes texels that came out negative black, holds them there, and lets go of those that their neighbours would raise by now; whether either
// came to pass.
static bool holdDark(Equations& equations, const Measured& measured, VectorXd& values, VectorXd& aim)
{
    // Minus half of the gradient: what would raise a texel. By as good as nothing it would be held again in the next round
    const VectorXd lift = measured.trust.cwiseProduct(measured.values - values) - equations.pull(values);
    const double brightest = *std::max_element(measured.values.begin(), measured.values.end());
    bool any = false;
    for (Index i = 0; i < values.size(); i++) {
        const bool isHeld = equations.trust[i] != measured.trust[i],
                   hold = isHeld ? !(lift[i] > kLifted * brightest * measured.trust[i]) : values[i] < 0.0;
        if (values[i] < 0.0) values[i] = 0.0;
        if (hold == isHeld) continue;
        aim[i] = hold ? 0.0 : measured.values[i];
        equations.trust[i] = hold ? measured.trust[i] * kHeld : measured.trust[i];
        any = true;
    }
    return any;
}

// Gives more weight to points that step by more than `target`; whether there were any.
static bool raise(Equations& equations, const VectorXd& most, const VectorXd& values, const StepOf& stepOf, double target)
{
    const VectorXd here = equations.side[0] * values, beyond = equations.side[1] * values;
    bool any = false;
    for (Index p = 0; p < here.size(); p++) {
        const double step = stepOf(here[p], beyond[p]);
        if (!(step > target)) continue;
        equations.weight[p] = std::min(equations.weight[p] * std::pow(std::min(step / target, kMostGrowth), kPower), most[p]);
        any = true;
    }
    return any;
}

std::vector<double> agreed(const SeamPatch& patch, const Asked& asked, const std::vector<double>& light, const StepOf& stepOf,
                           double target)
{
    Equations equations(patch, asked);
    const VectorXd most = kMostGrown * equations.weight;
    const Measured measured{vectorOf(light), equations.trust};
    VectorXd aim = measured.values, values = aim;
    for (int round = 0; round < kRounds && equations.factorize(); round++) {
        values = equations.solve(aim);
        const bool changed = holdDark(equations, measured, values, aim);
        if (!raise(equations, most, values, stepOf, target) && !changed) break;
    }
    return valuesOf(values);
}
}
