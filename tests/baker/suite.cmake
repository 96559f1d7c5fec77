suite(baker_geometry_test
    SOURCES weld_test.cpp atlas_test.cpp atlas_borders_test.cpp atlas_pages_test.cpp atlas_footprint_test.cpp atlas_press_test.cpp distance_test.cpp lod_test.cpp
    USES baker)
suite(baker_light_test
    SOURCES area_test.cpp transport_test.cpp glass_test.cpp film_test.cpp waves_test.cpp gather_test.cpp wavelengths_test.cpp air_test.cpp solids_test.cpp reference_test.cpp world_surface_test.cpp sky_test.cpp emitters_test.cpp visibility_test.cpp region_test.cpp planes_test.cpp probes_test.cpp probe_places_test.cpp probe_noise_test.cpp reflections_test.cpp reflection_places_test.cpp denoise_test.cpp fireflies_test.cpp local_fit_test.cpp dilate_test.cpp stitch_test.cpp agreement_test.cpp directional_test.cpp oidn_test.cpp bake_test.cpp journal_test.cpp key_test.cpp resume_test.cpp light_layers_test.cpp reach_test.cpp reckon_test.cpp pace_test.cpp rounds_test.cpp light_cache_test.cpp lookup_test.cpp leaks_test.cpp extremes_test.cpp memory_test.cpp
    USES baker
    LIBRARIES nlohmann_json::nlohmann_json)
# The third use of the project: what probes are off by in every level.
suite(probe_accuracy_test
    SOURCES probe_accuracy_test.cpp
    USES baker
    LIBRARIES nlohmann_json::nlohmann_json
    LABEL probe-accuracy)
# What tests open in the place of Open Image Denoise
add_library(oidn_stub MODULE ${CMAKE_CURRENT_LIST_DIR}/oidn_stub.cpp)
target_link_libraries(oidn_stub PRIVATE afterglow_warnings)
add_dependencies(baker_light_test oidn_stub)
target_compile_definitions(baker_light_test PRIVATE AFTERGLOW_OIDN_STUB="$<TARGET_FILE:oidn_stub>")
