suite(laws_test SOURCES bsdf_test.cpp)
