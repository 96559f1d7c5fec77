#include "baker/probe_corners.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
static constexpr double kBucket = 4.0;    // insets
static constexpr double kRounding = 1e-6; // of a cell's diagonal
static constexpr double kSameShare = 0.1; // of a cell's least extent: probes nearer than that are one, if they see each other

static bool nearLamp(const Partition& partition, dvec3 position)
{
    const double finest = partition.finest(position - partition.thin, position + partition.thin);
    const auto near = [&](vec3 lamp) { return distance(position, dvec3(lamp)) < finest; };
    return std::any_of(partition.lamps.begin(), partition.lamps.end(), near);
}

// Nothing within `clear` m along the axes and diagonals, and no lamp within the size of the finest cell.
static bool isClear(const Partition& partition, dvec3 position, double clear)
{
    if (nearLamp(partition, position)) return false;
    for (int x = -1; x <= 1; x++)
        for (int y = -1; y <= 1; y++)
            for (int z = -1; z <= 1; z++) {
                const int axes = x * x + y * y + z * z;
                if (axes != 1 && axes != 3) continue;
                const Ray ray{vec3(position), normalize(vec3(x, y, z)), float(clear)};
                if (!partition.world.unoccluded(ray)) return false;
            }
    return true;
}

dvec3 freePoint(const Partition& partition, const Partition::Cell& cell, dvec3 wanted, double clear)
{
    if (!partition.walls) return wanted;
    for (const double share : {0.0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85}) {
        const dvec3 point = mix(wanted, cell.anchor, share);
        if (isClear(partition, point, clear) && partition.sees(cell.anchor, point)) return point;
    }
    return cell.anchor;
}

// Why a probe does not stand at a corner, where nothing else is near that could take its place.
static ProbeStand standOf(const Partition& partition, const Partition::Cell& cell, dvec3 at, dvec3 reachable, dvec3 free)
{
    if (distance(free, at) < kRounding * length(cell.region.upper() - cell.region.lower())) return ProbeStand::corner;
    if (free == reachable) return ProbeStand::slanted;
    if (partition.solids.hold(vec3(reachable))) return ProbeStand::buried;
    if (!partition.sees(cell.anchor, reachable)) return ProbeStand::hidden;
    return nearLamp(partition, reachable) ? ProbeStand::lamp : ProbeStand::near;
}

// The region, off its walls.
static Region shrunk(const Region& region, double inset)
{
    Region left = region;
    for (const Region::Face& face : region.faces)
        if (face.wall && !left.empty()) left = clipped(left, face.normal, face.offset - inset, true, 0.0);
    return left;
}

static dvec3 nearestCorner(const Region& region, dvec3 wanted)
{
    dvec3 nearest = wanted;
    double least = -1.0;
    for (const Region::Face& face : region.faces)
        for (dvec3 corner : face.corners)
            if (const double away = dot(corner - wanted, corner - wanted); least < 0.0 || away < least) least = away, nearest = corner;
    return nearest;
}

static uint probeAtPoint(const Partition& partition, ProbeCorners& corners, dvec3 position, double same, ProbeStand stand)
{
    const double bucket = kBucket * corners.inset;
    std::array<long long, 3> key;
    for (int axis = 0; axis < 3; axis++) key[std::size_t(axis)] = std::llround(position[axis] / bucket);
    for (long long i = 0; i < 27; i++) {
        const auto found = corners.known.find({key[0] + i % 3 - 1, key[1] + i / 3 % 3 - 1, key[2] + i / 9 - 1});
        if (found == corners.known.end()) continue;
        for (uint probe : found->second)
            if (distance(corners.positions[probe], position) < same && partition.sees(corners.positions[probe], position)) return probe;
    }
    const uint probe = uint(corners.positions.size());
    corners.positions.push_back(position);
    corners.stands.push_back(stand);
    corners.known[key].push_back(probe);
    return probe;
}

CellBox placeCorners(const Partition& partition, const Partition::Cell& cell, ProbeCorners& corners)
{
    const dvec3 extent = cell.region.upper() - cell.region.lower();
    const double inset = std::min(corners.inset, 0.2 * std::min({extent.x, extent.y, extent.z}));
    Region inner = shrunk(cell.region, inset);
    if (inner.empty()) inner = cell.region;
    const double same = std::min(kBucket * corners.inset, kSameShare * std::min({extent.x, extent.y, extent.z}));
    CellBox box{inner.lower(), inner.upper(), {}};
    for (int corner = 0; corner < 8; corner++) {
        const dvec3 at(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                       corner & 4 ? box.upper.z : box.lower.z);
        const dvec3 reachable = nearestCorner(inner, at), free = freePoint(partition, cell, reachable, 0.5 * inset);
        box.probe[std::size_t(corner)] = probeAtPoint(partition, corners, free, same, standOf(partition, cell, at, reachable, free));
    }
    return box;
}
}
