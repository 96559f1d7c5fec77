#version 460
// Horizons in the depth buffer: in each slice through the line of sight the highest surface within the range to either side; what lies
// between them is open, and its weight is a closed form.
#include "engine/effects/occlusion/seen.glsl"

// How many pixels lie between `from` and the border of the picture along a direction in which one step is one pixel of the longer axis.
float pixelsWithin(vec2 from, vec2 direction)
{
    vec2 to = vec2(direction.x > 0.0 ? float(frame.size.x - 1) - from.x : from.x, direction.y > 0.0 ? float(frame.size.y - 1) - from.y : from.y);
    vec2 each = to / max(abs(direction), vec2(1e-6));
    return min(each.x, each.y);
}

// The cosine between the line of sight and what the picture shows `away` pixels from the point, where that stands above its surface and
// within the range; -1 elsewhere.
float cosineAt(SeenPoint p, vec2 away)
{
    ivec2 at = ivec2(round(vec2(p.pixel) + away));
    float depth = depthAt(at);
    vec3 d = positionAt(vec2(at), depth) - p.position; // of the sky: infinitely far
    float squared = dot(d, d);
    if (!(depth > 0.0) || !(squared <= frame.p.range * frame.p.range)) return -1.0;
    float inverse = inversesqrt(max(squared, 1e-20));
    return dot(d, p.face) * inverse > kLeastSine ? dot(d, p.toEye) * inverse : -1.0;
}

const int kClimbs = 2; // by halves of a step from the highest surface on: a third halves nothing any more (README)

// The cosine between the line of sight and the highest surface on the side of `side`, a unit vector across the line of sight.
float horizonCosine(SeenPoint p, vec3 side, float within)
{
    // The widest angle at which the sphere of the range is seen from the eye
    const float kWidest = 0.95; // sine: a sphere around the eye itself is cut here
    vec4 here = frame.eyeToClip * vec4(p.position, 1.0), there;
    if (frame.eye.w > 0.0) {
        float sine = min(frame.p.range / length(p.position), kWidest);
        there = frame.eyeToClip * vec4(side * sine - p.toEye * sqrt(1.0 - sine * sine), 0.0);
    } else {
        there = here + frame.eyeToClip * vec4(side * frame.p.range, 0.0);
    }
    // Beyond the plane of the eye it is as far as the picture goes
    float w = there.w > 1e-6 ? there.w : 1e-6;
    vec2 way = (there.xy - here.xy * (w / here.w)) * 0.5 * vec2(frame.size);
    float longer = max(abs(way.x), abs(way.y));
    if (!(longer > 0.0)) return -1.0;
    vec2 direction = way / longer;
    float reach = min(longer / w, pixelsWithin(vec2(p.pixel), direction));
    float highest = -1.0;
    if (reach < 1.0) return highest;
    float found = 0.0, apart = 1.0 / float(frame.p.steps);
    for (uint k = 0u; k < frame.p.steps; ++k) {
        float t = (float(k) + within) * apart, cosine = cosineAt(p, direction * mix(1.0, reach, t));
        if (cosine > highest) highest = cosine, found = t;
    }
    // What is highest mostly goes on rising for a part of a step: a rim
    for (int k = 0; k < kClimbs && highest > -1.0; ++k) {
        apart *= 0.5;
        float t = min(found + apart, 1.0), cosine = cosineAt(p, direction * mix(1.0, reach, t));
        if (cosine > highest) highest = cosine, found = t;
    }
    return highest;
}

void main()
{
    SeenPoint p;
    if (!seenPoint(p)) return;
    Frame eyed = makeFrame(p.toEye);
    float turn = turnOf(ivec2(gl_FragCoord.xy), 0), within = turnOf(ivec2(gl_FragCoord.xy), 2);
    float lit = 0.0, whole = 0.0;
    for (uint k = 0u; k < frame.p.slices; ++k) {
        float angle = (float(k) + turn) * kPi / float(frame.p.slices);
        vec3 side = eyed.tangent * cos(angle) + eyed.bitangent * sin(angle);
        // The normal as the slice sees it: its length in the slice is the slice's weight
        vec2 flat_ = vec2(dot(p.normal, side), dot(p.normal, p.toEye));
        float weight = length(flat_);
        if (!(weight > 1e-6)) continue;
        float n = clamp(atan(flat_.x, flat_.y), -kHalfPi, kHalfPi);
        float right = min(acos(clamp(horizonCosine(p, side, within), -1.0, 1.0)), n + kHalfPi);
        float left = max(-acos(clamp(horizonCosine(p, -side, within), -1.0, 1.0)), n - kHalfPi);
        lit += weight * (horizonArc(right, n) + horizonArc(left, n));
        whole += weight * openArc(n);
    }
    if (whole > 0.0) seen.x = clamp(lit / whole, 0.0, 1.0);
}
