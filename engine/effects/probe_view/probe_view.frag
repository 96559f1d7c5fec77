#version 460
// The sphere of a probe: by its own light, or coloured by how it came to stand where it does.
#include "engine/effects/probe_view/probe_view.h"
#include "engine/effects/view_ray.h"
#include "shaders/probes.glsl"

layout(set = 1, binding = 0, scalar) readonly buffer Shown { ProbeViewFrame frame; };
layout(set = 1, binding = 1, scalar) readonly buffer Marks { ProbeMark marks[]; };

layout(location = 0) flat in uint probe;
layout(location = 1) flat in vec4 sphere;
layout(location = 0) out vec4 radiance;

void main()
{
    ViewRay ray = viewRay(gl_FragCoord.xy / frame.size, 0.0, frame.clipToWorld, frame.eye);
    vec3 apart = sphere.xyz - ray.origin;
    float along = dot(apart, ray.direction);
    vec3 aside = apart - along * ray.direction;
    float within = sphere.w * sphere.w - dot(aside, aside);
    if (within < 0.0) discard;
    vec3 position = ray.origin + (along - sqrt(within)) * ray.direction;
    vec3 normal = (position - sphere.xyz) / sphere.w;
    vec4 clip = frame.worldToClip * vec4(position, 1.0);
    gl_FragDepth = clip.z / clip.w;
    float facing = dot(normal, -ray.direction);
    // A dark rim: on a wall in the same light the sphere is seen all the same
    vec3 light = max(probeIrradiance(probeAt(ProbeSet(1u), probe), normal), vec3(0.0)) * smoothstep(0.0, 0.4, facing);
    radiance = vec4(frame.shown == kShowProbes ? min(light, vec3(kHalfMax)) : colorOfMove(marks[probe].moved) * formOf(facing), 1.0);
}
