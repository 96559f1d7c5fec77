#include "baker/irradiance.hpp"

namespace afterglow
{
Surface whiteSurface(vec3 position, vec3 normal, vec3 geometricNormal, float meetingError)
{
    Surface white;
    white.position = position;
    white.meetingError = meetingError;
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
    return Ray{leaving(white, white.geometricNormal), direction, kRayFar};
}

vec3 irradianceSample(Tracer here, Tracer beyond, const Surface& white, const Ray& ray, const Hit& hit, Sampler& random)
{
    vec3 sum = directAtSurface(here, vec3(1.0f), white, viewBsdf(white.bsdf, vec3(0.0f, 0.0f, 1.0f)), random);
    // The cosine and the 1/pi of the white surface cancel the pdf. Directions behind the geometric surface see only the surface itself.
    float cosine = dot(ray.direction, white.frame.normal);
    if (!(cosine > 0.0f) || !(dot(ray.direction, white.geometricNormal) > 0.0f)) return sum;
    return sum + radianceAlong(here, beyond, ray, hit, cosine * kInvPi, random);
}
}
