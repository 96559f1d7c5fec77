suite(core_test
    SOURCES file_test.cpp scaffold_test.cpp sha256_test.cpp image_test.cpp jobs_test.cpp progress_test.cpp forecast_test.cpp interrupt_test.cpp metrics_test.cpp flip_test.cpp
    USES core)
