# The peers of the benchmark, by stand-ins.
suite(cycles_test
    SOURCES cycles_test.cpp
    USES baker
    LIBRARIES nlohmann_json::nlohmann_json fmt::fmt)
target_sources(cycles_test PRIVATE ${PROJECT_SOURCE_DIR}/bench/cycles.cpp)
