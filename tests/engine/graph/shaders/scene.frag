#version 460
// A number and a texture of the scene, set 0.
layout(set = 0, binding = 0, scalar) readonly buffer Numbers { float numbers[]; };
layout(set = 0, binding = 1) uniform sampler2D textures[];
layout(push_constant, scalar) uniform Push { uint index; } push;
layout(location = 0) out vec4 color;
void main() { color = numbers[push.index] + texelFetch(textures[nonuniformEXT(push.index)], ivec2(0), 0); }
