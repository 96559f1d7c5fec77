suite(frame_test
    SOURCES plan_test.cpp frame_test.cpp
    USES frame)
