suite(effects_test
    SOURCES
        view_test.cpp geometry_test.cpp shadow_test.cpp lighting_test.cpp reflection_test.cpp march_test.cpp fog_test.cpp display_test.cpp
    USES effects)
