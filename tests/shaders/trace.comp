#version 460
// Rays in, what they met and what passes them out.
#include "shaders/trace.glsl"

struct TracedAnswer {
    Hit hit;
    vec3 passed;
    vec3 position;
    vec3 geometricNormal;
    vec3 normal;
    vec3 diffuse;
    vec3 emission;
    uint vertex; // the triangle's first
    uint instance;
};
layout(local_size_x = 64) in;
layout(set = 1, binding = 0, scalar) readonly buffer Rays { Ray rays[]; };
layout(set = 1, binding = 1, scalar) writeonly buffer Answers { TracedAnswer answers[]; };

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.length()) return;
    Ray ray = rays[i];
    TracedAnswer a;
    a.hit = closestHit(ray);
    a.passed = transmittance(ray);
    a.position = a.geometricNormal = a.normal = a.diffuse = a.emission = vec3(0.0);
    a.vertex = 0u;
    a.instance = 0u;
    if (a.hit.distance < kRayFar) {
        Surface s = surfaceAt(ray, a.hit);
        a.position = s.position;
        a.geometricNormal = s.geometricNormal;
        a.normal = s.frame.normal;
        a.diffuse = s.bsdf.diffuse;
        a.emission = s.emission;
        a.vertex = rayTriangles[a.hit.triangle].vertex[0];
        a.instance = rayTriangles[a.hit.triangle].instance;
    }
    answers[i] = a;
}
