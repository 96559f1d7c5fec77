// How many rays of which kind: each costs something else. And of how many of their paths light is missing.
#pragma once
#include <cstdint>

namespace afterglow
{
struct RayCount {
    std::uint64_t closest = 0, closestPacked = 0; // for the nearest hit: one by one, in packets of kPacket
    std::uint64_t shadow = 0, shadowPacked = 0;   // for any hit
    std::uint64_t cut = 0;                        // paths that the cap of bounces ended
    std::uint64_t notFinite = 0;                  // paths of which something was no number: that is left out

    std::uint64_t all() const { return closest + closestPacked + shadow + shadowPacked; }
    RayCount& operator+=(const RayCount& other)
    {
        closest += other.closest, closestPacked += other.closestPacked;
        shadow += other.shadow, shadowPacked += other.shadowPacked;
        cut += other.cut, notFinite += other.notFinite;
        return *this;
    }
    bool operator==(const RayCount&) const = default;
};
}
