// Irradiance at a point of a surface by path tracing: the estimator that lightmap texels and `afterglow probe --truth` share.
#pragma once
#include "baker/tracer.hpp"

namespace afterglow
{
// A white Lambertian surface: the radiance that leaves it is irradiance / pi. `rounding`: of Surface, where the point lies on a triangle.
Surface whiteSurface(vec3 position, vec3 normal, vec3 geometricNormal, float meetingError = 0.0f);

// One cosine-distributed direction about a white surface, as a ray that leaves it, from a point of the unit square.
Ray cosineRay(const Surface& white, vec2 u);

// One sample of irradiance / pi, given the first hit of a cosineRay. `here` asks the lights whose direct part counts at the point itself,
// `beyond` those that light the surfaces it sees.
vec3 irradianceSample(Tracer here, Tracer beyond, const Surface& white, const Ray& ray, const Hit& hit, Sampler& random);
}
