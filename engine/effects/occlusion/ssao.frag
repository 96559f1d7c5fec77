#version 460
// Points of the hemisphere over the surface, against the depth buffer: one that lies behind what the eye sees there is hidden.
#include "engine/effects/occlusion/seen.glsl"

void main()
{
    SeenPoint p;
    if (!seenPoint(p)) return;
    Frame local = makeFrame(p.normal);
    float turn = turnOf(ivec2(gl_FragCoord.xy), 0), within = turnOf(ivec2(gl_FragCoord.xy), 2);
    float open = 0.0, known = 0.0;
    for (uint k = 0u; k < frame.p.samples; ++k) {
        // Cosine by cosine, around by the golden section; how far out by the roots of a third sequence
        float u = (float(k) + within) / float(frame.p.samples), angle = kTwoPi * fract(float(k) * 0.6180340 + turn);
        float far_ = fract(float(k) * 0.7548777 + turn);
        vec3 way = toWorld(local, vec3(sqrt(u) * cos(angle), sqrt(u) * sin(angle), sqrt(1.0 - u)));
        vec3 point = p.position + way * (frame.p.range * sqrt(far_));
        vec4 clip = frame.eyeToClip * vec4(point, 1.0);
        vec2 at = (clip.xy / clip.w * 0.5 + 0.5) * vec2(frame.size);
        if (!(clip.w > 0.0) || any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(frame.size)))) continue; // not known
        known += 1.0;
        if (ivec2(at) == p.pixel) { // nothing hides itself, however its place rounds
            open += 1.0;
            continue;
        }
        float depth = depthAt(ivec2(at));
        vec3 d = positionAt(floor(at), depth) - p.position;
        float squared = dot(d, d);
        bool hidden = depth > clip.z / clip.w && squared <= frame.p.range * frame.p.range && dot(d, p.face) > kLeastSine * sqrt(squared);
        if (!hidden) open += 1.0;
    }
    if (known > 0.0) seen.x = open / known;
}
