#include "baker/mirror_rays.hpp"
#include "baker/area.hpp"
#include "engine/scene/material.hpp"
#include "shaders/reflection.h"
#include "shaders/sampling.h"
#include <algorithm>

namespace afterglow
{
// Share of the light that it mirrors at most, looked at from the front; 0: it is not glossy. Textures only take from what its factors say:
// where one says what is metal, all may be clear, or metal as far as the factor goes.
static float strengthOf(const Scene& scene, const Material& material)
{
    if (!isGlossy(scene, material)) return 0.0f;
    const float clear = min(dielectricF0(max(material.ior, 1.0f)) * material.specular * largestOf(material.specularColor), 1.0f);
    const float mixed = mix(clear, largestOf(vec3(material.baseColor)), material.metallic);
    return material.metallicRoughnessTexture.texture < 0 ? mixed : max(clear, mixed);
}

// The same at a point, less what its roughness blurs.
static float mirrored(const Bsdf& b)
{
    const float alpha = max(b.alpha.x, b.alpha.y);
    if (b.metallic == 0.0f && alpha > kGlossyRoughness * kGlossyRoughness) return 0.0f;
    return meanOf(interfaceReflectance(b, 1.0f)) * (1.0f - alpha);
}

static float endOf(const World& world, const MirrorRay& ray) { return world.closestHit({ray.from, ray.direction, kRayFar}).distance; }

static std::vector<MirrorRay> fromSurfaces(const World& world, const Solids& solids, std::size_t count, uint seed)
{
    const Scene& scene = world.scene();
    std::vector<float> strengths;
    for (const Material& material : scene.materials) strengths.push_back(strengthOf(scene, material));
    const Area area(world, strengths);
    std::vector<MirrorRay> rays;
    if (!(area.whole() > 0.0)) return rays;
    std::vector<SurfacePlace> places;
    for (std::size_t i = 0; i < count; i++) {
        Sampler random = makeSampler(seed, uint(i));
        const AreaPoint point = area.point(random);
        const vec3 front = normalize(world.front(point.triangle));
        const bool turned = next1(random) < 0.5f && (world.materialOf(point.triangle).flags & kMaterialDoubleSided) != 0;
        const vec3 side = turned ? -front : front;
        const Surface surface =
            world.surfaceAt({point.position + side, -side, kRayFar}, {1.0f, point.triangle, vec2(point.corners.y, point.corners.z)});
        const float weight = mirrored(surface.bsdf) / strengths[world.triangles()[point.triangle].material];
        if (!(weight > 0.0f)) continue;
        const vec3 direction = toWorld(makeFrame(side), sampleCosineHemisphere(next2(random)));
        rays.push_back({leaving(surface, side), side, direction, 0.0f, weight});
        places.push_back({point.position, side});
    }
    const std::vector<Stand> stands = solids.standsOf(places);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rays.size(); i++)
        if (stands[i] == Stand::open) rays[kept++] = rays[i];
    rays.resize(kept);
    return rays;
}

static bool glossyMoves(const Scene& scene)
{
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const Object& object) {
        const std::vector<Primitive>& parts = scene.meshes[object.mesh].primitives;
        return !object.isStatic && std::any_of(parts.begin(), parts.end(),
                                               [&](const Primitive& part) { return isGlossy(scene, scene.materials[part.material]); });
    });
}

// Of what moves nobody knows where it will be.
static std::vector<MirrorRay> fromSpace(const World& world, const Solids& solids, std::size_t count, uint seed)
{
    const Scene& scene = world.scene();
    std::vector<MirrorRay> rays;
    for (std::size_t i = 0; i < count; i++) {
        Sampler random = makeSampler(hash1(seed), uint(i));
        const vec2 xy = next2(random);
        const vec3 from = mix(scene.lower, scene.upper, vec3(xy, next1(random)));
        const vec3 direction = sampleUniformSphere(next2(random));
        if (!solids.hold(from)) rays.push_back({from, direction, direction, 0.0f, 1.0f});
    }
    return rays;
}

std::vector<MirrorRay> mirrorRays(const World& world, const Solids& solids, std::size_t count, uint seed)
{
    std::vector<MirrorRay> rays = fromSurfaces(world, solids, count, seed);
    if (glossyMoves(world.scene())) {
        const std::vector<MirrorRay> more = fromSpace(world, solids, count / 4, seed);
        rays.insert(rays.end(), more.begin(), more.end());
    }
    for (MirrorRay& ray : rays) ray.distance = endOf(world, ray);
    return rays;
}
}
