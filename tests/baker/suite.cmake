suite(baker_geometry_test
    SOURCES weld_test.cpp atlas_test.cpp lod_test.cpp
    USES baker)
suite(baker_light_test
    SOURCES transport_test.cpp waves_test.cpp gather_test.cpp wavelengths_test.cpp air_test.cpp solids_test.cpp reference_test.cpp world_surface_test.cpp sky_test.cpp emitters_test.cpp visibility_test.cpp probes_test.cpp reflections_test.cpp denoise_test.cpp dilate_test.cpp directional_test.cpp bake_test.cpp journal_test.cpp reckon_test.cpp pace_test.cpp rounds_test.cpp lookup_test.cpp leaks_test.cpp
    USES baker
    LIBRARIES nlohmann_json::nlohmann_json)
