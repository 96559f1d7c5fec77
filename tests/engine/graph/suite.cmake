suite(graph_test
    SOURCES live_test.cpp place_test.cpp barriers_test.cpp describe_test.cpp executor_test.cpp raster_test.cpp ray_programs_test.cpp repeat_test.cpp kept_test.cpp shapes_test.cpp
    USES graph)
# GCC 12 takes "a" + std::to_string(i) for an overlapping copy (its bug 105651).
target_compile_options(graph_test PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
