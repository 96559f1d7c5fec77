#version 460
// A buffer, word by word.
layout(local_size_x = 1) in;
layout(set = 1, binding = 0, scalar) readonly buffer From { uint from[]; };
layout(set = 1, binding = 1, scalar) writeonly buffer To { uint to[]; };
void main()
{
    for (int i = 0; i < from.length(); ++i) to[i] = from[i];
}
