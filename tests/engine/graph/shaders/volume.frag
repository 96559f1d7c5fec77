#version 460
// The volume halfway between its first and its second slice.
layout(set = 1, binding = 0) uniform sampler3D volume;
layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;
void main() { color = vec4(textureLod(volume, vec3(uv, 1.0 / float(textureSize(volume, 0).z)), 0.0).r); }
