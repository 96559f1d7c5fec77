suite(reports_test
    SOURCES cli_test.cpp cli_pictures_test.cpp compare_test.cpp inspect_test.cpp fly_test.cpp
    USES app baked
    LIBRARIES nlohmann_json::nlohmann_json)
target_compile_definitions(reports_test PRIVATE AFTERGLOW_VERSION="${PROJECT_VERSION}")

# The program, killed, and kept small.
suite(program_test
    SOURCES kill_test.cpp memory_test.cpp machine_test.cpp
    USES core
    LIBRARIES nlohmann_json::nlohmann_json)
add_dependencies(program_test afterglow)
target_compile_definitions(program_test PRIVATE AFTERGLOW_PROGRAM="$<TARGET_FILE:afterglow>")

# From the file to the picture; needs a device, as the viewer does.
suite(far_level_test
    SOURCES far_level_test.cpp
    USES app baker baked
    LIBRARIES nlohmann_json::nlohmann_json)

# Needs a device, too.
suite(render_layers_test
    SOURCES render_layers_test.cpp
    USES app frame)

# What a study says of numbers, and its files; the verb itself needs a device.
suite(study_test
    SOURCES study/law_test.cpp study/judge_test.cpp study/advice_test.cpp study/files_test.cpp study/page_test.cpp study/clutter_test.cpp study/triangles_test.cpp study/readme_test.cpp study/foreseen_test.cpp study/choice_test.cpp study/study_test.cpp
    USES app
    LIBRARIES nlohmann_json::nlohmann_json fmt::fmt)

# What fits a time; the verbs themselves need a device.
suite(budget_test
    SOURCES budget/knapsack_test.cpp budget/options_test.cpp budget/queue_test.cpp budget/search_test.cpp budget/budget_test.cpp
    USES app
    LIBRARIES nlohmann_json::nlohmann_json)

# The viewer on a display of its own.
find_program(xvfb_run xvfb-run)
if(xvfb_run)
    add_executable(view_test ${CMAKE_CURRENT_LIST_DIR}/view_test.cpp)
    target_link_libraries(view_test PRIVATE app afterglow_warnings GTest::gtest_main)
    set_target_properties(view_test PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    # Without -noreset the server starts anew whenever a test closes its last window, and the next finds no display for a moment.
    add_test(NAME view COMMAND ${xvfb_run} -a -s "-screen 0 1280x1024x24 -noreset" $<TARGET_FILE:view_test>
             WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(view PROPERTIES RESOURCE_LOCK display) # two servers that start at once may pick one number
else()
    message(STATUS "The test `view` is left out: xvfb is missing")
endif()

# Fog in both columns; needs a device too.
suite(fog_truth_test
    SOURCES fog_truth_test.cpp
    USES frame baker)

# Path tracing in both columns; needs a device with ray queries.
suite(two_tracers_test
    SOURCES two_tracers_test.cpp organisations_test.cpp stated_truth_test.cpp path_variance_test.cpp
    USES frame baker
    LIBRARIES nlohmann_json::nlohmann_json)
