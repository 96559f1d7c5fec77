#include "engine/app/study/clutter.hpp"
#include "engine/scene/material.hpp"
#include "shaders/frame.h"
#include "shaders/random.h"
#include <cmath>

namespace afterglow
{
namespace
{
constexpr ivec3 kBodies{4, 2, 5}; // across the room
constexpr int kBodyCount = kBodies.x * kBodies.y * kBodies.z;
const vec3 kRoom{5.0f, 2.5f, 5.0f}; // half its extents, m

// A cube that is rounded and bent: closed, however finely it is tessellated.
struct Blob {
    vec3 middle{0.0f}, halfExtents = kRoom; // m
    float round = 0.0f;                     // 0: a cube, 1: a ball
    vec3 phase{0.0f};                       // radians, of its bumps
    bool inside = false;                    // its fronts look inwards
};

vec3 placed(const Blob& blob, vec3 onCube)
{
    const float kBump = 0.05f; // of its size
    const vec3 wave = sin(vec3(9.0f, 11.0f, 7.0f) * onCube + blob.phase);
    return blob.middle + blob.halfExtents * mix(onCube, normalize(onCube), blob.round) * (1.0f + kBump * wave.x * wave.y * wave.z);
}

// -1 .. 1, the same number whichever face asks, so that neighbours share their edges to the bit.
float along(uint i, uint edges) { return float(int(2 * i) - int(edges)) / float(edges); }

// One of the six faces, in edges x edges squares.
void addFace(Scene& scene, const Blob& blob, uint face, uint edges, uint firstVertex)
{
    const int axis = int(face / 2);
    const float side = face % 2 == 0 ? -1.0f : 1.0f;
    const uint first = uint(scene.vertices.size());
    for (uint j = 0; j <= edges; ++j)
        for (uint i = 0; i <= edges; ++i) {
            vec3 onCube;
            onCube[axis] = side;
            onCube[(axis + 1) % 3] = along(i, edges);
            onCube[(axis + 2) % 3] = side * along(j, edges);
            const vec2 uv = vec2(float(i), float(j)) / float(edges);
            scene.vertices.push_back({placed(blob, onCube), vec3(0.0f), vec4(0.0f), uv, uv, 0xffffffffu});
        }
    for (uint j = 0; j < edges; ++j)
        for (uint i = 0; i < edges; ++i) {
            const uint a = first + j * (edges + 1) + i, b = a + 1, c = a + edges + 1, d = c + 1;
            for (const uvec3 corners : {uvec3(a, b, d), uvec3(a, d, c)}) {
                const uvec3 turned = blob.inside ? uvec3(corners.x, corners.z, corners.y) : corners;
                Vertex* v[3];
                for (int k = 0; k < 3; ++k) {
                    v[k] = &scene.vertices[turned[k]];
                    scene.indices.push_back(turned[k] - firstVertex);
                }
                const vec3 front = cross(v[1]->position - v[0]->position, v[2]->position - v[0]->position);
                for (Vertex* corner : v) corner->normal += front;
            }
        }
    for (std::size_t i = first; i < scene.vertices.size(); ++i) {
        Vertex& vertex = scene.vertices[i];
        vertex.normal = safeNormalize(vertex.normal, vec3(0.0f, 1.0f, 0.0f));
        vertex.tangent = vec4(makeFrame(vertex.normal).tangent, 1.0f);
    }
}

void addBlob(Scene& scene, const Blob& blob, uint edges)
{
    Primitive primitive{uint(scene.vertices.size()), 0, uint(scene.indices.size()), 0, 0};
    for (uint face = 0; face < 6; ++face) addFace(scene, blob, face, edges, primitive.firstVertex);
    primitive.vertexCount = uint(scene.vertices.size()) - primitive.firstVertex;
    primitive.indexCount = uint(scene.indices.size()) - primitive.firstIndex;
    Object object;
    object.mesh = uint(scene.meshes.size());
    scene.meshes.push_back({blob.inside ? "room" : "body", {primitive}});
    scene.objects.push_back(object);
}

// Each in a cell of its own, so that none meets another or a wall.
Blob bodyIn(ivec3 cell)
{
    const float kTightest = 0.5f, kWidest = 0.7f; // of the cell
    shared::Sampler random = makeSampler(uint(cell.x + kBodies.x * (cell.y + kBodies.y * cell.z)), 0u);
    const vec2 xy = next2(random), more = next2(random);
    const vec3 cellSize = 0.9f * kRoom / vec3(kBodies); // half its extents: the walls bend, too
    Blob body;
    body.middle = cellSize * (2.0f * vec3(cell) + 1.0f - vec3(kBodies));
    body.halfExtents = cellSize * mix(vec3(kTightest), vec3(kWidest), vec3(xy, more.x));
    body.round = more.y;
    body.phase = kTwoPi * vec3(xy, more.y);
    return body;
}

// Along each edge of so many cubes.
uint edgesFor(double triangles, int cubes)
{
    return uint(std::lround(std::sqrt(std::max(triangles, 0.0) / (12.0 * cubes)))); // six faces, two triangles a square
}
}

Scene clutter(std::size_t triangles)
{
    Scene scene;
    scene.materials = {plaster()};
    scene.materialNames = {"plaster"};
    const uint bodyEdges = std::max(edgesFor(0.5 * double(triangles), kBodyCount), 1u);
    const double ofBodies = 12.0 * kBodyCount * bodyEdges * bodyEdges;
    addBlob(scene, {.inside = true}, std::max(edgesFor(double(triangles) - ofBodies, 1), 1u));
    for (int z = 0; z < kBodies.z; ++z)
        for (int y = 0; y < kBodies.y; ++y)
            for (int x = 0; x < kBodies.x; ++x) addBlob(scene, bodyIn({x, y, z}), bodyEdges);
    scene.upper = 1.05f * kRoom, scene.lower = -scene.upper;

    const vec3 eye = vec3(-0.92f, 0.1f, -0.92f) * kRoom; // in a corner, looking across the room
    Camera camera;
    const vec3 back = normalize(eye), right = normalize(cross(vec3(0.0f, 1.0f, 0.0f), back));
    camera.toWorld = mat4(vec4(right, 0.0f), vec4(cross(back, right), 0.0f), vec4(back, 0.0f), vec4(eye, 1.0f));
    camera.fovY = 1.2f;
    scene.cameras = {camera};
    return scene;
}
}
