suite(frame_test
    SOURCES plan_test.cpp frame_test.cpp layers_test.cpp layers_surface_test.cpp meetings_test.cpp windows_test.cpp
    USES frame)
