#version 460
// The number of texels above one half, and the largest of a list.
layout(local_size_x = 8, local_size_y = 8) in;
struct Item { vec3 a; float b; };
layout(set = 1, binding = 0) uniform sampler2D image;
layout(set = 1, binding = 1, scalar) readonly buffer Items { Item items[]; };
layout(set = 1, binding = 2, scalar) buffer Sum { uint sum; uint largest; };
void main()
{
    const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, textureSize(image, 0)))) return;
    if (texelFetch(image, at, 0).r > 0.5) atomicAdd(sum, 1);
    if (at == ivec2(0))
        for (int i = 0; i < items.length(); ++i) atomicMax(largest, uint(items[i].b));
}
