#version 460
// The comparison of a reference depth with the stored one.
layout(set = 1, binding = 0) uniform sampler2DShadow depth;
layout(push_constant, scalar) uniform Push { float reference; } push;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() { color = vec4(textureLod(depth, vec3(uv, push.reference), 0.0)); }
