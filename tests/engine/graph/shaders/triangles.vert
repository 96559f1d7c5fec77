#version 460
// Triangles pulled from a list: position and depth.
layout(set = 1, binding = 0, scalar) readonly buffer Vertices { vec3 vertices[]; };
layout(location = 0) flat out uint triangle;
void main()
{
    gl_Position = vec4(vertices[gl_VertexIndex], 1.0);
    triangle = gl_VertexIndex / 3;
}
