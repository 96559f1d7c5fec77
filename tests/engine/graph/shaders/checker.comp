#version 460
// 1 where x + y is odd.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 1, binding = 0, rgba32f) writeonly uniform image2D target;
void main()
{
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(target)))) return;
    imageStore(target, at, vec4((at.x + at.y) & 1));
}
