#version 460
// Before each step: the queues that it fills are empty.
#include "engine/effects/truth/truth.h"

layout(local_size_x = 1) in;
layout(push_constant, scalar) uniform Push { WavePush push; };
layout(set = 1, binding = 0, scalar) writeonly buffer Queues { WaveQueue queues[]; };

void main()
{
    for (uint i = 0u; i <= kShadowQueue; ++i)
        if (i != push.from) queues[i] = WaveQueue(uint[](0u, 1u, 1u), 0u);
}
