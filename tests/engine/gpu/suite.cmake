suite(gpu_test
    SOURCES device_test.cpp format_test.cpp memory_test.cpp shader_test.cpp pipeline_test.cpp readback_test.cpp
    USES gpu)
