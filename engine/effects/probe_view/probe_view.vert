#version 460
// A square before the eye that holds the sphere of one probe.
#include "engine/effects/probe_view/probe_view.h"

layout(set = 1, binding = 0, scalar) readonly buffer Shown { ProbeViewFrame frame; };
layout(set = 1, binding = 1, scalar) readonly buffer Marks { ProbeMark marks[]; };

layout(location = 0) flat out uint probe;
layout(location = 1) flat out vec4 sphere; // centre, radius

void main()
{
    probe = uint(gl_VertexIndex) / 6u;
    ProbeMark mark = marks[probe];
    vec3 toEye = frame.eye.w > 0.0 ? frame.eye.xyz - mark.position : frame.eye.xyz;
    float away = frame.eye.w > 0.0 ? length(toEye) : 1.0;
    float least = kSmallestSphere * frame.pixel * away;
    sphere = vec4(mark.position, frame.eye.w > 0.0 ? clamp(mark.radius, least, max(least, kLargestSphere * away)) : max(mark.radius, least));
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // six times the same point: nothing
    if (!(away > 0.0)) return;

    // Of a perspective the outline is that of a cone: wider than the sphere at its centre
    float wide = frame.eye.w > 0.0 ? sphere.w * inversesqrt(1.0 - sphere.w * sphere.w / (away * away)) : sphere.w;
    vec3 right = normalize(cross(toEye, abs(toEye.y) < 0.9 * away ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    vec3 up = cross(toEye / away, right);
    int corner = gl_VertexIndex % 6;
    vec2 at = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5) * 2.0 - 1.0;
    gl_Position = frame.worldToClip * vec4(mark.position + wide * (at.x * right + at.y * up), 1.0);
}
