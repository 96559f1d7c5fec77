#version 460
// What is pushed.
layout(push_constant, scalar) uniform Push { float value; } push;
layout(location = 0) out vec4 color;
void main() { color = vec4(push.value); }
