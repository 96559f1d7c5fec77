suite(baker_geometry_test
    SOURCES weld_test.cpp atlas_test.cpp lod_test.cpp
    USES baker)
