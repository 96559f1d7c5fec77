suite(scene_test
    SOURCES gltf_test.cpp accessor_test.cpp geometry_test.cpp normals_test.cpp placement_test.cpp origin_test.cpp convex_test.cpp
            material_test.cpp texture_test.cpp light_test.cpp camera_test.cpp extras_test.cpp level_test.cpp needs_test.cpp voxels_test.cpp flats_test.cpp closed_test.cpp
    USES scene core
    LIBRARIES nlohmann_json::nlohmann_json)
