#include "baker/irradiance.hpp"
#include "shaders/lightmap.h"

namespace afterglow
{
Surface whiteSurface(vec3 position, vec3 normal, vec3 geometricNormal)
{
    Surface white;
    white.position = position;
    white.geometricNormal = geometricNormal;
    white.frame = makeFrame(normal);
    white.emission = vec3(0.0f);
    white.unlit = vec3(0.0f);
    white.frontFacing = 1.0f;
    white.absorption = vec3(0.0f);
    white.bsdf = lambertBsdf(vec3(1.0f));
    return white;
}

Ray cosineRay(const Surface& white, vec2 u)
{
    vec3 direction = toWorld(white.frame, sampleCosineHemisphere(u));
    return Ray{offsetRay(white.position, white.geometricNormal), direction, kRayFar};
}

vec3 irradianceSample(Tracer here, Tracer beyond, const Surface& white, const Ray& ray, const Hit& hit, Sampler& random, dvec3* turn)
{
    const vec3 normal = white.frame.normal;
    const auto turned = [&](vec3 direction, vec3 value) { return double(luminance(value)) * dvec3(directionOf(direction, normal)); };
    Arrivals arrivals;
    Tracer asked = here;
    if (turn) asked.arrivals = &arrivals;
    vec3 sum = directAtSurface(asked, vec3(1.0f), white, viewBsdf(white.bsdf, vec3(0.0f, 0.0f, 1.0f)), random);
    if (turn) {
        *turn = dvec3(0.0);
        for (uint i = 0; i < arrivals.count; i++) *turn += turned(arrivals.of[i].direction, arrivals.of[i].value);
    }
    // The cosine and the 1/pi of the white surface cancel the pdf. Directions behind the geometric surface see only the surface itself.
    float cosine = dot(ray.direction, normal);
    if (!(cosine > 0.0f) || !(dot(ray.direction, white.geometricNormal) > 0.0f)) return sum;
    const vec3 along = radianceAlong(here, beyond, ray, hit, cosine * kInvPi, random);
    if (turn) *turn += turned(ray.direction, along);
    return sum + along;
}
}
