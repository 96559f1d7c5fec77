#include "baker/partition.hpp"
#include "baker/planes.hpp"
#include "baker/sphere_sums.hpp"
#include "engine/core/interrupt.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace afterglow
{
// By eye. Of them kInSight was tried: with 0.8 content/gallery has 4155 cells in draft, with 0.4 it has 3677.
static constexpr double kCovers = 0.5;         // share of a region's section that a wall takes to part it
static constexpr double kInSight = 0.4;        // share of its pairs of points that see each other in a cell that needs no cut
static constexpr double kParted = 0.7;         // share of either side's points that a plane must tell apart
static constexpr uint kPoints = 20;            // tried in a region with something in it
static constexpr int kFinestDepth = 4;         // cuts by planes below the finest size
static constexpr double kLong = 0.7;           // of the longest axis: axes that are cut with it
static constexpr double kParallel = 0.999;     // cosine: walls that stand in a cut's way, 2.5 degrees
static constexpr double kBeside = 0.15;        // of the extent: cuts so near a wall are made along it
static constexpr double kRounded = 1.0 + 1e-3; // a cut in the middle may leave more than half by rounding

bool Partition::sees(dvec3 from, dvec3 to) const
{
    const dvec3 way = to - from;
    const double far = length(way);
    if (!(far > 0.0)) return true;
    return world.unoccluded(Ray{vec3(from), vec3(way / far), float(far)});
}

namespace
{
struct Cut {
    dvec3 normal;
    double offset;
    bool wall;
};
}
static int split(Partition& partition, const Region& region, const std::vector<uint>& triangles, const Cut& cut, const Spacing& spacing,
                 int depth);

// Free points of a region, told apart by what they see: group[i] is the first of the points that it sees, over others maybe.
struct Outlook {
    std::vector<dvec3> points;
    std::vector<std::size_t> group;
    std::vector<int> seen; // others that a point sees
    double share = 1.0;    // of the pairs that see each other

    std::size_t largest() const { return std::size_t(std::max_element(seen.begin(), seen.end()) - seen.begin()); }
};

static Outlook lookAround(const Partition& partition, const Region& region)
{
    Outlook outlook;
    const dvec3 lower = region.lower(), extent = region.upper() - lower;
    for (uint i = 0; i < 4 * kPoints && outlook.points.size() < kPoints; i++) {
        Sampler random = makeSampler(0x70617274u, i);
        const vec2 across = next2(random);
        const dvec3 point = lower + extent * dvec3(double(across.x), double(across.y), double(next1(random)));
        if (region.holds(point) && !partition.solids.hold(vec3(point))) outlook.points.push_back(point);
    }
    const std::size_t count = outlook.points.size();
    outlook.group.resize(count);
    std::iota(outlook.group.begin(), outlook.group.end(), std::size_t(0));
    outlook.seen.assign(count, 0);
    int pairs = 0, visible = 0;
    for (std::size_t i = 0; i < count; i++)
        for (std::size_t j = 0; j < i; j++) {
            pairs++;
            if (!partition.sees(outlook.points[i], outlook.points[j])) continue;
            visible++, outlook.seen[i]++, outlook.seen[j]++;
            const std::size_t from = std::max(outlook.group[i], outlook.group[j]), to = std::min(outlook.group[i], outlook.group[j]);
            for (std::size_t& group : outlook.group)
                if (group == from) group = to;
        }
    if (pairs > 0) outlook.share = double(visible) / pairs;
    return outlook;
}

// How well a plane tells the largest group of points from the others.
static double partedBy(const Outlook& outlook, const Plane& plane)
{
    const std::size_t own = outlook.group[outlook.largest()];
    double above[2] = {0.0, 0.0}, all[2] = {0.0, 0.0};
    for (std::size_t i = 0; i < outlook.points.size(); i++) {
        const int side = outlook.group[i] == own ? 1 : 0;
        all[side]++;
        if (dot(plane.normal, outlook.points[i]) > plane.offset) above[side]++;
    }
    if (!(all[0] > 0.0 && all[1] > 0.0)) return 0.0;
    const double a = above[0] / all[0], b = above[1] / all[1];
    return std::max(std::min(a, 1.0 - b), std::min(1.0 - a, b));
}

static int keepCell(Partition& partition, Region region, std::vector<uint> triangles, dvec3 anchor)
{
    triangles.shrink_to_fit(); // they were its parents', of which it has few
    for (Region::Face& face : region.faces) face.corners.shrink_to_fit();
    partition.cells.push_back({std::move(region), std::move(triangles), anchor});
    return ~int(partition.cells.size() - 1);
}

// Halves the longest axis.
static Cut middleCut(const Region& region, const std::vector<Plane>& planes)
{
    const dvec3 lower = region.lower(), extent = region.upper() - lower;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    dvec3 normal(0.0);
    normal[axis] = 1.0;
    double middle = lower[axis] + 0.5 * extent[axis];
    // Beside a wall it would leave a sliver
    const dvec3 centre = region.middle();
    for (const Plane& plane : planes)
        if (plane.normal[axis] > kParallel && std::abs(dot(plane.normal, centre) - plane.offset) < kBeside * extent[axis])
            return {plane.normal, plane.offset, true};
    return {normal, middle, false};
}

static int partFrom(Partition& partition, Region region, std::vector<uint> triangles, const Spacing& spacing, int depth)
{
    stopIfInterrupted();
    if (region.empty()) return kNowhere;
    const dvec3 lower = region.lower(), upper = region.upper(), extent = upper - lower;
    const double size = std::max({extent.x, extent.y, extent.z});
    if (any(lessThan(upper, partition.lower + 2.0 * partition.thin)) || any(greaterThan(lower, partition.upper - 2.0 * partition.thin)))
        return kNowhere;
    std::vector<Plane> planes = partition.walls ? planesIn(partition.world, region, partition.thin, triangles) : std::vector<Plane>{};
    if (!partition.walls) triangles.clear();

    const auto cutBy = [&](Cut cut, int next) {
        std::vector<Plane>().swap(planes); // as many as there are triangles, at every depth
        return split(partition, region, triangles, cut, spacing, next);
    };

    // Walls first: those that part it all, then cuts until it is small enough
    const Plane* best = nullptr;
    double covered = kCovers;
    for (const Plane& plane : planes) {
        if (!(plane.area > covered * plane.leastSection)) continue;
        const double section = area(sectionOf(region, plane.normal, plane.offset));
        if (section > 0.0 && plane.area > covered * section) covered = plane.area / section, best = &plane;
    }
    if (best) return cutBy({best->normal, best->offset, true}, depth);
    if (size > spacing(lower, upper) * kRounded) return cutBy(middleCut(region, planes), depth);

    if (triangles.empty()) {
        dvec3 middle(0.0);
        double corners = 0.0;
        for (const Region::Face& face : region.faces)
            for (dvec3 corner : face.corners) middle += corner, corners++;
        middle /= corners;
        if (partition.walls && partition.solids.hold(vec3(middle))) return kNowhere;
        return keepCell(partition, std::move(region), {}, middle);
    }
    const Outlook outlook = lookAround(partition, region);
    if (outlook.points.empty()) return kNowhere;
    const bool small = size <= partition.finest(lower, upper) || partition.cells.size() >= partition.most;
    const bool whole = std::all_of(outlook.group.begin(), outlook.group.end(), [](std::size_t group) { return group == 0; });
    const dvec3 anchor = outlook.points[outlook.largest()];
    if (whole && (outlook.share >= kInSight || small)) return keepCell(partition, std::move(region), triangles, anchor);
    if (!small) return cutBy(middleCut(region, planes), depth);
    double parted = kParted;
    for (const Plane& plane : planes)
        if (const double by = partedBy(outlook, plane); by > parted) parted = by, best = &plane;
    if (best && depth < kFinestDepth) return cutBy({best->normal, best->offset, true}, depth + 1);
    return keepCell(partition, std::move(region), triangles, anchor);
}

static int split(Partition& partition, const Region& region, const std::vector<uint>& triangles, const Cut& cut, const Spacing& spacing,
                 int depth)
{
    const auto side = [&](double sign) { return clipped(region, sign * cut.normal, sign * cut.offset, cut.wall, partition.thin); };
    const int below = partFrom(partition, side(1.0), triangles, spacing, depth),
              above = partFrom(partition, side(-1.0), triangles, spacing, depth);
    if (below == kNowhere) return above;
    if (above == kNowhere) return below;
    partition.nodes.push_back({vec3(cut.normal), float(cut.offset), below, above});
    return int(partition.nodes.size() - 1);
}

int part(Partition& partition, Region region, std::vector<uint> triangles, const Spacing& spacing)
{
    return partFrom(partition, std::move(region), std::move(triangles), spacing, 0);
}

void cutCell(Partition& partition, std::size_t cell)
{
    const Partition::Cell old = partition.cells[cell];
    const dvec3 lower = old.region.lower(), extent = old.region.upper() - lower;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const Spacing half = [&](dvec3, dvec3) { return kLong * longest; };
    const int made = partFrom(partition, old.region, old.triangles, half, 0);
    if (made != kNowhere) partition.cells[cell] = {{}, {}, old.anchor, made};
}
}
