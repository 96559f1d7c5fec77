#version 460
// The image times a factor, plus a constant.
layout(constant_id = 0) const float kAdd = 0.0;
layout(set = 1, binding = 0) uniform sampler2D image;
layout(push_constant, scalar) uniform Push { float factor; } push;
layout(location = 0) out vec4 color;
void main() { color = texelFetch(image, ivec2(gl_FragCoord.xy), 0) * push.factor + kAdd; }
