suite(laws_test SOURCES
    color_test.cpp spectrum_test.cpp
    frame_test.cpp random_test.cpp sampling_test.cpp
    fresnel_test.cpp microfacet_test.cpp diffuse_test.cpp bsdf_test.cpp)
