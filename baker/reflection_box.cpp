#include "baker/reflection_box.hpp"
#include <algorithm>
#include <cmath>
#include <optional>

namespace afterglow
{
static constexpr float kFirstStep = 1.5f, kLastStep = 1.01f; // factors by which a wall's distance is tried
// Diagonals of the level: from a diagonal beside the probe a wall as far off is looked up 0.01 radians beside the sky, less than a texel.
static constexpr float kSky = 100.0f;

float lookupError(const ReflectionBox& box, const MirrorRay& ray, bool isSeen)
{
    if (!isSeen) return kBeside;
    const vec3 looked = reflectionDirection(box, ray.from, ray.direction);
    const vec3 end = ray.from + ray.direction * ray.distance - box.position;
    const vec3 right = ray.distance < kRayFar ? safeNormalize(end, ray.direction) : ray.direction;
    return min(distance(looked, right), kBeside);
}

// How far the walls are along each axis: the farthest of a small fan of rays, so that a table does not become the room; 0: none is met.
static float wallDistance(const World& world, vec3 position, int axis, float sign)
{
    float farthest = 0.0f;
    for (int i = -2; i <= 2; i++)
        for (int j = -2; j <= 2; j++) {
            vec3 d(0.0f);
            d[axis] = sign;
            d[(axis + 1) % 3] = 0.15f * float(i);
            d[(axis + 2) % 3] = 0.15f * float(j);
            d = normalize(d);
            const Hit hit = world.closestHit(Ray{position, d, kRayFar});
            if (hit.distance < kRayFar) farthest = max(farthest, hit.distance * abs(d[axis]));
        }
    return farthest;
}

// `sky`: m, how far off it is taken to be; absent, the level's own bounds stand where no wall is met.
static ReflectionBox wallsAbout(const World& world, vec3 position, std::optional<float> sky)
{
    ReflectionBox box{position, 1.0f, position, position};
    const vec3 lower = world.scene().lower, upper = world.scene().upper;
    for (int axis = 0; axis < 3; axis++) {
        const float below = wallDistance(world, position, axis, -1.0f), above = wallDistance(world, position, axis, 1.0f);
        const float least = sky ? position[axis] - *sky : min(lower[axis], position[axis] - 1.0f);
        const float most = sky ? position[axis] + *sky : max(upper[axis], position[axis] + 1.0f);
        box.lower[axis] = below > 0.0f ? position[axis] - below : least;
        box.upper[axis] = above > 0.0f ? position[axis] + above : most;
    }
    return box;
}

static double errorOf(const ReflectionBox& box, std::span<const MirrorRay> rays, const std::vector<bool>& seen)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < rays.size(); i++) {
        const float share = reflectionInfluence(box, rays[i].from).x;
        if (share > 0.0f) sum += double(rays[i].weight * share * (lookupError(box, rays[i], seen[i]) - kUncovered));
    }
    return sum; // over that without the box
}

ReflectionBox fitBox(const World& world, vec3 position, std::span<const MirrorRay> rays, const std::vector<bool>& seen)
{
    const float farthest = kSky * distance(world.scene().lower, world.scene().upper);
    // Near walls mirror the sky so wrongly that a box would rather cover nothing than grow step by step
    const bool onlySky = std::all_of(rays.begin(), rays.end(), [](const MirrorRay& ray) { return ray.distance >= kRayFar; });
    ReflectionBox box = wallsAbout(world, position, onlySky ? std::optional(farthest) : std::nullopt);
    double error = errorOf(box, rays, seen);
    for (float step = kFirstStep; step > kLastStep;) {
        bool better = false;
        for (int wall = 0; wall < 6; wall++)
            for (const float factor : {step, 1.0f / step}) {
                ReflectionBox tried = box;
                float& at = wall < 3 ? tried.lower[wall] : tried.upper[wall - 3];
                at = position[wall % 3] + clamp(factor * (at - position[wall % 3]), -farthest, farthest);
                const double found = errorOf(tried, rays, seen);
                if (found < error) box = tried, error = found, better = true;
            }
        if (!better) step = std::sqrt(step);
    }
    return box;
}

std::vector<bool> seenFrom(const World& world, vec3 position, std::span<const MirrorRay> rays)
{
    constexpr float kShort = 0.999f; // of the way: what is met is not in its own way
    std::vector<bool> seen;
    for (const MirrorRay& ray : rays) {
        const vec3 way = ray.from + ray.direction * ray.distance - position;
        const float far = length(way);
        const Ray sight =
            ray.distance < kRayFar ? Ray{position, way / max(far, 1e-6f), kShort * far} : Ray{position, ray.direction, kRayFar};
        seen.push_back(world.unoccluded(sight));
    }
    return seen;
}
}
