# The verbs that need neither the baker nor a device, built from their files.
suite(reports_test
    SOURCES compare_test.cpp ../../../engine/app/compare.cpp
            inspect_test.cpp ../../../engine/app/inspect.cpp
    USES baked
    LIBRARIES nlohmann_json::nlohmann_json)
