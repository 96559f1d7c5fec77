#version 460
// The image sampled across the target.
layout(set = 1, binding = 0) uniform sampler2D image;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() { color = textureLod(image, uv, 0.0); }
