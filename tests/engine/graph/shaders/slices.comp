#version 460
// Each texel of a volume is its own slice number.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(set = 1, binding = 0, r32f) writeonly uniform image3D target;
void main()
{
    const ivec3 at = ivec3(gl_GlobalInvocationID);
    if (all(lessThan(at, imageSize(target)))) imageStore(target, at, vec4(at.z));
}
