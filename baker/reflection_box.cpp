#include "baker/reflection_box.hpp"
#include <cmath>

namespace afterglow
{
static constexpr float kFirstStep = 1.5f, kLastStep = 1.01f; // factors by which a wall's distance is tried

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

static ReflectionBox wallsAbout(const World& world, vec3 position)
{
    ReflectionBox box{position, 1.0f, position, position};
    for (int axis = 0; axis < 3; axis++) {
        // Where no wall is met, the level's own bounds
        const float below = wallDistance(world, position, axis, -1.0f), above = wallDistance(world, position, axis, 1.0f);
        box.lower[axis] = below > 0.0f ? position[axis] - below : min(world.scene().lower[axis], position[axis] - 1.0f);
        box.upper[axis] = above > 0.0f ? position[axis] + above : max(world.scene().upper[axis], position[axis] + 1.0f);
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
    ReflectionBox box = wallsAbout(world, position);
    double error = errorOf(box, rays, seen);
    for (float step = kFirstStep; step > kLastStep;) {
        bool better = false;
        for (int wall = 0; wall < 6; wall++)
            for (const float factor : {step, 1.0f / step}) {
                ReflectionBox tried = box;
                float& at = wall < 3 ? tried.lower[wall] : tried.upper[wall - 3];
                at = position[wall % 3] + factor * (at - position[wall % 3]);
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
