#version 460
// One of two images; the other may be missing.
layout(constant_id = 0) const bool kHasFirst = true;
layout(set = 1, binding = 0) uniform sampler2D first;
layout(set = 1, binding = 1) uniform sampler2D second;
layout(location = 0) out vec4 color;
void main()
{
    const ivec2 at = ivec2(gl_FragCoord.xy);
    if (kHasFirst)
        color = texelFetch(first, at, 0);
    else
        color = texelFetch(second, at, 0);
}
