#version 460
// The place of each pixel, as its colour.
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() { color = vec4(uv, gl_FragCoord.xy); }
