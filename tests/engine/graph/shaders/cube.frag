#version 460
// Looks along +x, -x, +y, -y, +z, -z: one pixel each.
layout(set = 1, binding = 0) uniform samplerCube cube;
layout(location = 0) out vec4 color;
void main()
{
    const int face = int(gl_FragCoord.x);
    vec3 direction = vec3(0.0);
    direction[face / 2] = (face & 1) == 0 ? 1.0 : -1.0;
    color = textureLod(cube, direction, 0.0);
}
