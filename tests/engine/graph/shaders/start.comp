#version 460
// A countdown begins: as many groups as numbers that are left.
layout(local_size_x = 1) in;
layout(set = 1, binding = 0, scalar) writeonly buffer Countdown { uint left; uint groups[3]; uint steps; uint invocations; uint arrived; };
layout(push_constant, scalar) uniform Push { uint from; };
void main()
{
    left = from;
    groups = uint[](from, 1u, 1u);
    steps = invocations = arrived = 0;
}
