// Which edges of a mesh may be lines: creases by the angle, no seams, borders, sheets, materials.
#include "engine/upload/edges.hpp"
#include "tests/engine/upload/solids.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
static int countOf(const Scene& scene, uint kind, float creaseDegrees = kCreaseDegrees)
{
    int count = 0;
    for (const MeshEdge& edge : meshEdges(scene, scene.meshes.back(), radians(creaseDegrees))) count += (edge.kinds & kind) != 0;
    return count;
}

// The angles between the faces of the regular solids: acos(1/3) = 70.53, 90, acos(-1/3) = 109.47, acos(-sqrt(5)/3) = 138.19 degrees.
TEST(MeshEdges, ACreaseLiesBelowTheThreshold)
{
    struct Case {
        Object& (*add)(Scene&, uint);
        int edges;
        float angle;
        bool byDefault;
    };
    const auto cube = [](Scene& scene, uint material) -> Object& { return addCube(scene, material); };
    for (const Case& c : {Case{addTetrahedron, 6, 70.5288f, true}, Case{cube, 12, 90.0f, true}, Case{addOctahedron, 12, 109.4712f, true},
                          Case{addIcosahedron, 30, 138.1897f, false}}) {
        Scene scene;
        c.add(scene, addMaterial(scene, matte(vec3(0.5f))));
        EXPECT_EQ(countOf(scene, kEdgeCrease), c.byDefault ? c.edges : 0) << c.angle;
        EXPECT_EQ(countOf(scene, kEdgeCrease, c.angle + 0.01f), c.edges) << c.angle;
        EXPECT_EQ(countOf(scene, kEdgeCrease, c.angle - 0.01f), 0) << c.angle;
        EXPECT_EQ(countOf(scene, kEdgeBorder), 0) << c.angle;
    }
}

// H76: a seam of uv and of normals, where the file had to split vertices, is no edge.
TEST(MeshEdges, SeamsAreNone)
{
    for (const Normals normals : {Normals::smooth, Normals::ofFaces}) {
        Scene scene;
        addCube(scene, addMaterial(scene, matte(vec3(0.5f))), normals);
        EXPECT_EQ(meshEdges(scene, scene.meshes.back(), radians(kCreaseDegrees)).size(), 18u); // 12 edges and 6 diagonals
        EXPECT_EQ(countOf(scene, kEdgeBorder), 0);
    }
    Scene scene;
    addSphere(scene, addMaterial(scene, matte(vec3(0.5f))));
    EXPECT_EQ(countOf(scene, kEdgeBorder), 0);
    EXPECT_EQ(countOf(scene, kEdgeCrease), 0);
    scene.vertices[1].position.x = -0.0f; // the sign of a zero moves no vertex
    EXPECT_EQ(countOf(scene, kEdgeBorder), 0);
}

TEST(MeshEdges, AnOpenMeshHasABorder)
{
    Scene scene;
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, matte(vec3(0.5f))));
    EXPECT_EQ(countOf(scene, kEdgeBorder), 4);
    EXPECT_EQ(countOf(scene, kEdgeSilhouette), 1); // the diagonal: for some eyes, were it not flat
    EXPECT_EQ(countOf(scene, kEdgeCrease), 0);
}

// A sheet with faces on both sides: its outline folds by 360 degrees, and what four faces share within is flat.
TEST(MeshEdges, ASheetOfTwoSidesShowsItsOutlineOnly)
{
    Scene scene;
    addSolid(scene, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {2, 1, 0}, {3, 2, 0}},
             addMaterial(scene, matte(vec3(0.5f))), Normals::ofFaces);
    EXPECT_EQ(countOf(scene, kEdgeCrease), 4);
    EXPECT_EQ(countOf(scene, kEdgeBorder), 0);
}

TEST(MeshEdges, MaterialsMeetInALine)
{
    Scene scene;
    const uint red = addMaterial(scene, matte(vec3(1, 0, 0))), green = addMaterial(scene, matte(vec3(0, 1, 0)));
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), red);
    addQuad(scene, vec3(1, 0, 0), vec3(1, 0, 0), vec3(0, 1, 0), green);
    scene.meshes.push_back({"both", {scene.meshes[0].primitives[0], scene.meshes[1].primitives[0]}});
    EXPECT_EQ(countOf(scene, kEdgeMaterial), 1);
    EXPECT_EQ(countOf(scene, kEdgeBorder), 6);
}

// The shape of a cut-out surface is in its texture.
TEST(MeshEdges, CutOutSurfacesHaveNone)
{
    Scene scene;
    Material leaf = matte(vec3(0.5f));
    leaf.flags |= kMaterialAlphaMask;
    addQuad(scene, vec3(0), vec3(1, 0, 0), vec3(0, 1, 0), addMaterial(scene, leaf));
    EXPECT_TRUE(meshEdges(scene, scene.meshes.back(), radians(kCreaseDegrees)).empty());
}

// The winding of a neighbour plays no part: turned over, it is seen the other way round by its own account, not by the edge's.
TEST(MeshEdges, ASilhouetteAsksTheEdgeNotTheWinding)
{
    const vec3 from(0, 0, 0), to(0, 0, 1), left(-1, -1, 0), right(1, -1, 0); // a roof
    EXPECT_FALSE(isSilhouette(vec3(0, 5, 0), from, to, left, right));
    EXPECT_TRUE(isSilhouette(vec3(5, 0, 0), from, to, left, right));
    EXPECT_TRUE(isSilhouette(vec3(5, 0, 0), to, from, left, right));
    EXPECT_TRUE(isSilhouette(vec3(5, 0, 0), from, to, right, left));
    EXPECT_FALSE(isSilhouette(vec3(0, -5, 0), from, to, left, right));
}
}
