#version 460
// An edge of a mesh that is a line for this eye, as a quad of constant width on the picture; all others vanish.
#include "engine/effects/outline/outline.h"
#include "shaders/camera.h"
#include "shaders/bindings.glsl"

layout(push_constant, scalar) uniform Push { EdgePush push; };
layout(set = 1, binding = 0, scalar) readonly buffer Outline { OutlineFrame frame; };
layout(set = 1, binding = 1, scalar) readonly buffer Edges { MeshEdge edges[]; };

layout(location = 0) flat out vec4 segment; // px: its ends
layout(location = 1) flat out vec2 depths;  // at them

bool isLine(MeshEdge edge, vec3 from, vec3 to)
{
    uint kinds = edge.kinds & frame.kinds;
    if ((kinds & ~kEdgeSilhouette) != 0u) return true;
    if (kinds == 0u) return false;
    return isSilhouette(push.eye.xyz - from * push.eye.w, from, to, vertices[edge.left].position, vertices[edge.right].position);
}

// Which part of a segment lies before the near plane and, generously, within the picture: x to y of 0..1; none where x > y.
vec2 partInside(vec4 p, vec4 q)
{
    const float kMargin = 1.5; // of the picture's half extent
    vec2 part = vec2(0.0, 1.0);
    for (int plane = 0; plane < 5; ++plane) {
        int axis = plane >> 1;
        float side = (plane & 1) == 0 ? 1.0 : -1.0;
        float atP = plane == 4 ? p.w - p.z : kMargin * p.w - side * p[axis];
        float atQ = plane == 4 ? q.w - q.z : kMargin * q.w - side * q[axis];
        if (atP < 0.0 && atQ < 0.0) return vec2(1.0, 0.0);
        float crossing = atP / (atP - atQ);
        if (atP < 0.0) part.x = max(part.x, crossing);
        if (atQ < 0.0) part.y = min(part.y, crossing);
    }
    return part;
}

void main()
{
    gl_Position = vec4(0.0, 0.0, 0.0, 1.0); // six times the same point: nothing
    segment = vec4(0.0);
    depths = vec2(0.0);
    MeshEdge edge = edges[gl_VertexIndex / 6];
    vec3 from = vertices[edge.from].position, to = vertices[edge.to].position;
    if (!isLine(edge, from, to)) return;
    vec4 p = push.objectToClip * vec4(from, 1.0), q = push.objectToClip * vec4(to, 1.0);
    vec2 part = partInside(p, q);
    if (!(part.x <= part.y)) return;
    vec4 a = mix(p, q, part.x), b = mix(p, q, part.y);
    vec2 size = vec2(frame.size);
    segment = vec4(ndcToUv(a.xy / a.w) * size, ndcToUv(b.xy / b.w) * size);
    depths = vec2(a.z / a.w, b.z / b.w);

    // The corners of the quad, with room for round ends and the last shade of grey
    int corner = gl_VertexIndex % 6;
    bool atEnd = corner == 1 || corner == 2 || corner == 4, above = corner == 2 || corner == 4 || corner == 5;
    vec2 along = segment.zw - segment.xy;
    float reach = length(along);
    along = reach > 1e-6 ? along / reach : vec2(1.0, 0.0);
    float room = 0.5 * max(frame.width, 1.0) + 1.0;
    vec2 at = (atEnd ? segment.zw + along * room : segment.xy - along * room) + vec2(-along.y, along.x) * (above ? room : -room);
    gl_Position = vec4(uvToNdc(at / size), 0.0, 1.0);
}
