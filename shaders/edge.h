// Edges of a mesh as the lines of a drawing: which of them may be one, and which are one for an eye. The terms are Freestyle's.
// This work is based on: Grabli, Turquin, Durand, Sillion 2010, "Programmable rendering of line drawing from 3D scenes".
#ifndef AFTERGLOW_EDGE_H
#define AFTERGLOW_EDGE_H
#include "shaders/constants.h"
SHARED_BEGIN

const uint kEdgeSilhouette = 1u; // one of its two faces is seen from the front, the other from behind
const uint kEdgeBorder = 2u;     // it has one face
const uint kEdgeCrease = 4u;     // its faces meet at less than the crease's angle
const uint kEdgeMaterial = 8u;   // its faces are of two materials
const uint kEdgeObject = 16u;    // where two objects pass through each other: no mesh has that edge
const uint kEveryEdge = 31u;

struct MeshEdge {
    uint from; // vertices of the level
    uint to;
    uint left; // the third vertices of its faces; the same twice: one face
    uint right;
    uint kinds; // kEdge...: a silhouette only for some eyes, the others for all
};

// The crease's default, an angle between two faces as measured within the body: Freestyle's. A cube has creases (90 degrees), an
// icosahedron (138.19) is round.
const float kCreaseDegrees = 134.43f;

// Cosine of the angle between two faces: -1: flat, 0: a cube's, 1: folded onto itself. Between the altitudes on the edge, so that the
// winding of the faces plays no part. NaN where a face has no area.
FN float facesCosine(vec3 from, vec3 to, vec3 left, vec3 right)
{
    vec3 along = normalize(to - from), a = left - from, b = right - from;
    return dot(normalize(a - along * dot(a, along)), normalize(b - along * dot(b, along)));
}
FN bool isCrease(float cosine, float creaseCosine) { return cosine > creaseCosine; }

// toEye: from `from` to the eye, of any length. The faces are wound as the edge has them, left and right, whatever the mesh says.
FN bool isSilhouette(vec3 toEye, vec3 from, vec3 to, vec3 left, vec3 right)
{
    vec3 along = to - from;
    return (dot(cross(along, left - from), toEye) > 0.0f) != (dot(cross(right - from, along), toEye) > 0.0f);
}

SHARED_END
#endif
