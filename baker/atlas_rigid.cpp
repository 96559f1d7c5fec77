#include "baker/atlas_rigid.hpp"
#include <array>
#include <Eigen/SparseCholesky>
#include <optional>

namespace afterglow
{
namespace
{
constexpr int kRounds = 3;            // of turning and solving: further ones hardly move a chart that is all but developable
constexpr double kSteepest = 1e4;     // of a cotangent: slivers are stiff, not rigid
constexpr double kTether = 1e-9;      // of a vertex to where it began, relative to its stiffness: fixes the place of the whole
constexpr double kDegenerate = 1e-30; // m2
constexpr Eigen::Index kLarge = 300;  // vertices: tried 150, 250, 400

using Stiffness = Eigen::SparseMatrix<double>; // its lower half

struct Rigid {                       // one triangle
    std::array<dvec2, 3> side;       // i: from corner i to i + 1, laid flat, m
    std::array<double, 3> stiffness; // of that side: half the cotangent of the angle that faces it
};

Rigid rigidOf(const Surface& surface, uint t)
{
    const dvec3 e = surface.point(t, 1) - surface.point(t, 0), f = surface.point(t, 2) - surface.point(t, 0);
    const double base = length(e), twice = 2.0 * surface.areas[t];
    Rigid rigid{};
    if (surface.normals[t] == dvec3(0.0) || twice < kDegenerate) return rigid;
    const dvec2 b(base, 0.0), c(dot(e, f) / base, twice / base);
    rigid.side = {b, c - b, -c};
    for (std::size_t i = 0; i < 3; ++i) {
        const double cotangent = -dot(rigid.side[(i + 1) % 3], rigid.side[(i + 2) % 3]) / twice;
        rigid.stiffness[i] = 0.5 * clamp(cotangent, -kSteepest, kSteepest);
    }
    return rigid;
}

// A small net is eliminated in the order that it has; of a large one, minimum degree saves more filling in than it costs.
class Solver
{
public:
    explicit Solver(const Stiffness& stiffness)
    {
        if (stiffness.rows() < kLarge)
            small_.compute(stiffness);
        else
            large_.emplace(stiffness);
    }

    bool sound() const { return (large_ ? large_->info() : small_.info()) == Eigen::Success; }
    Eigen::MatrixX2d solve(const Eigen::MatrixX2d& pull) const { return large_ ? large_->solve(pull).eval() : small_.solve(pull).eval(); }

private:
    Eigen::SimplicialLDLT<Stiffness, Eigen::Lower, Eigen::NaturalOrdering<int>> small_;
    std::optional<Eigen::SimplicialLDLT<Stiffness>> large_;
};

double cross2(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }
}

void relax(const Surface& surface, Net& net)
{
    const auto count = Eigen::Index(net.points.size());
    std::vector<Rigid> rigid;
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> own(net.points.size()), tether(net.points.size());
    for (std::size_t t = 0; t < net.triangles.size(); ++t) {
        rigid.push_back(rigidOf(surface, net.triangles[t]));
        for (std::size_t i = 0; i < 3; ++i) {
            const uint a = net.vertex[3 * t + i], b = net.vertex[3 * t + (i + 1) % 3];
            const double w = rigid.back().stiffness[i];
            entries.emplace_back(int(max(a, b)), int(min(a, b)), -w);
            own[a] += w, own[b] += w;
            tether[a] += std::abs(w), tether[b] += std::abs(w);
        }
    }
    for (std::size_t v = 0; v < net.points.size(); ++v) {
        tether[v] = max(kTether * tether[v], kTether);
        entries.emplace_back(int(v), int(v), own[v] + tether[v]);
    }
    Stiffness stiffness(count, count);
    stiffness.setFromTriplets(entries.begin(), entries.end());
    const Solver solver(stiffness);
    if (!solver.sound()) return;

    const std::vector<dvec2> begin = net.points;
    for (int round = 0; round < kRounds; ++round) {
        Eigen::MatrixX2d pull(count, 2);
        for (Eigen::Index v = 0; v < count; ++v)
            for (int axis = 0; axis < 2; ++axis) pull(v, axis) = tether[std::size_t(v)] * begin[std::size_t(v)][axis];
        for (std::size_t t = 0; t < net.triangles.size(); ++t) {
            // The turn that brings the rigid triangle nearest to where it lies.
            dvec2 turn(0.0);
            for (std::size_t i = 0; i < 3; ++i) {
                const dvec2 lies = net.points[net.vertex[3 * t + (i + 1) % 3]] - net.points[net.vertex[3 * t + i]];
                turn += rigid[t].stiffness[i] * dvec2(dot(rigid[t].side[i], lies), cross2(rigid[t].side[i], lies));
            }
            const double size = length(turn);
            turn = size > 0.0 ? turn / size : dvec2(1.0, 0.0);
            for (std::size_t i = 0; i < 3; ++i) {
                const dvec2& s = rigid[t].side[i];
                const dvec2 wanted = rigid[t].stiffness[i] * dvec2(turn.x * s.x - turn.y * s.y, turn.y * s.x + turn.x * s.y);
                for (int axis = 0; axis < 2; ++axis) {
                    pull(net.vertex[3 * t + (i + 1) % 3], axis) += wanted[axis];
                    pull(net.vertex[3 * t + i], axis) -= wanted[axis];
                }
            }
        }
        const Eigen::MatrixX2d solved = solver.solve(pull);
        for (Eigen::Index v = 0; v < count; ++v) net.points[std::size_t(v)] = dvec2(solved(v, 0), solved(v, 1));
    }
}

Strain normalise(const Surface& surface, Net& net)
{
    Strain strain;
    double area = 0.0, flat = 0.0, stretch = 0.0;
    for (std::size_t t = 0; t < net.triangles.size(); ++t) {
        const Rigid rigid = rigidOf(surface, net.triangles[t]);
        const double twice = 2.0 * surface.areas[net.triangles[t]];
        if (rigid.side[0] == dvec2(0.0)) continue;
        const dvec2 &a = net.points[net.vertex[3 * t]], p = net.points[net.vertex[3 * t + 1]] - a,
                    q = net.points[net.vertex[3 * t + 2]] - a;
        const double lies = cross2(p, q);
        if (!(lies > 0.0)) {
            strain.flipped = true;
            return strain;
        }
        // Of the map from the plane back to the triangle: the sum of the squared singular values, and their product.
        const dvec2 b = rigid.side[0], c = -rigid.side[2];
        const dvec2 su = (b * q.y - c * p.y) / lies, sv = (c * p.x - b * q.x) / lies;
        const double sum = dot(su, su) + dot(sv, sv), product = twice / lies,
                     root = std::sqrt(max(sum * sum - 4.0 * product * product, 0.0));
        strain.worst = max(strain.worst, std::sqrt((sum + root) / max(sum - root, 1e-12 * sum)));
        area += twice / 2, flat += lies / 2, stretch += sum / 2 * twice / 2;
    }
    if (!(area > 0.0)) return strain;
    strain.stretch = std::sqrt(stretch / area * flat / area);
    const double scale = std::sqrt(area / flat);
    for (dvec2& p : net.points) p *= scale;
    return strain;
}
}
