suite(frame_test
    SOURCES plan_test.cpp frame_test.cpp moving_test.cpp methods_test.cpp layers_test.cpp layers_surface_test.cpp meetings_test.cpp
            mirrors_test.cpp water_test.cpp portals_test.cpp
    USES frame)
