suite(laws_test SOURCES
    color_test.cpp spectrum_test.cpp
    frame_test.cpp random_test.cpp sampling_test.cpp sampling_variance_test.cpp
    fresnel_test.cpp microfacet_test.cpp diffuse_test.cpp bsdf_test.cpp
    phase_test.cpp medium_test.cpp medium_walk_test.cpp light_test.cpp formfactor_test.cpp penumbra_test.cpp
    sh_test.cpp camera_test.cpp lightmap_test.cpp probe_test.cpp reflection_test.cpp visibility_test.cpp triangle_test.cpp)
if(TARGET upload)
    suite(trace_test SOURCES trace_test.cpp trace_rounding_test.cpp USES baker upload)
endif()
