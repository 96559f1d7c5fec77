suite(gpu_test
    SOURCES device_test.cpp format_test.cpp memory_test.cpp shader_test.cpp pipeline_test.cpp readback_test.cpp
    USES gpu)

# The window on a display of its own.
find_program(xvfb_run xvfb-run)
if(xvfb_run)
    add_executable(window_test ${CMAKE_CURRENT_LIST_DIR}/window_test.cpp)
    target_link_libraries(window_test PRIVATE gpu afterglow_warnings GTest::gtest_main)
    set_target_properties(window_test PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    # Without -noreset the server starts anew whenever a test closes its last window, and the next finds no display for a moment.
    add_test(NAME window COMMAND ${xvfb_run} -a -s "-screen 0 1280x1024x24 -noreset" $<TARGET_FILE:window_test>
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(window PROPERTIES RESOURCE_LOCK display) # two servers that start at once may pick one number
else()
    message(STATUS "The test `window` is left out: xvfb is missing")
endif()
