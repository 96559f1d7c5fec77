suite(reports_test
    SOURCES compare_test.cpp inspect_test.cpp
    USES app baked
    LIBRARIES nlohmann_json::nlohmann_json)
