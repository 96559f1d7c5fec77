#version 460
// One number less, once all of the groups have been counted.
layout(local_size_x = 8) in;
layout(set = 1, binding = 0, scalar) buffer Countdown { uint left; uint groups[3]; uint steps; uint invocations; uint arrived; };
void main()
{
    atomicAdd(invocations, 1);
    if (atomicAdd(arrived, 1) + 1 < gl_NumWorkGroups.x * gl_WorkGroupSize.x) return; // not the last one
    arrived = 0;
    left -= 1;
    groups[0] = left;
    steps += 1;
}
