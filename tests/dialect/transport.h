// The smallest level that shaders/transport.h can be compiled with: nothing is met, nothing shines.
#ifndef AFTERGLOW_TEST_DIALECT_TRANSPORT_H
#define AFTERGLOW_TEST_DIALECT_TRANSPORT_H
#include "shaders/light.h"
#include "shaders/path.h"
#include "shaders/ray.h"
#include "shaders/scene.h"
#include "tests/dialect/media.h"
SHARED_BEGIN

struct Tracer {
    uint rays;
};

FN Hit closestHit(Tracer, Ray) { return Hit(kRayFar, 0u, vec2(0.0f)); }
FN Surface surfaceAt(Tracer, Ray, Hit)
{
    Surface nothing;
    return nothing;
}
FN vec3 unshadowed(Tracer, Ray, vec3 carried) { return carried; }
FN uint lightCount(Tracer) { return 0u; }
FN Light lightAt(Tracer, uint)
{
    Light nothing;
    return nothing;
}
FN bool hasDirect(Tracer, uint) { return false; }
FN LightSample sampleEmitter(Tracer, vec3, float, vec2) { return noLight(); }
FN float emitterPdf(Tracer, Ray, Hit, Surface) { return 0.0f; }
FN vec3 skyRadiance(Tracer, vec3) { return vec3(0.0f); }
FN LightSample sampleSky(Tracer, vec2) { return noLight(); }
FN float skyPdf(Tracer, vec3) { return 0.0f; }
FN Air airOf(Tracer)
{
    Air nothing;
    return nothing;
}
FN bool knownBase(Tracer, Hit, IN(Surface), OUT(vec3) light)
{
    light = vec3(0.0f, 0.0f, 0.0f);
    return false;
}
FN void cutShort(Tracer) {}
FN PathSettings settings(Tracer) { return PathSettings(1u, 1u, 1u, 1u, 0u); }

SHARED_END
#endif
