#version 460
// The number of the triangle, from 1, times what is pushed.
layout(location = 0) flat in uint triangle;
layout(push_constant, scalar) uniform Push { float factor; } push;
layout(location = 0) out vec4 color;
void main() { color = vec4(float(triangle + 1) * push.factor); }
