#version 460
// What is pushed, and twice it.
layout(location = 0) flat in uint triangle;
layout(push_constant, scalar) uniform Push { float factor; } push;
layout(location = 0) out vec4 once;
layout(location = 1) out vec4 twice;
void main()
{
    once = vec4(push.factor);
    twice = 2.0 * once;
}
