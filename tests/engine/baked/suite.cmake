suite(baked_test SOURCES ktx2_test.cpp lightmap_test.cpp probes_test.cpp reflections_test.cpp scene_glb_test.cpp baked_test.cpp USES baked
          LIBRARIES nlohmann_json::nlohmann_json)
