suite(upload_test
    SOURCES gpu_scene_test.cpp edges_test.cpp gpu_baked_test.cpp probe_grid_test.cpp split_sum_test.cpp
    USES upload)
