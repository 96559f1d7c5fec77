# The checker itself: the tree in tests/one_definition defines Lit twice; its other names lie in other scopes.
execute_process(COMMAND ${CMAKE_COMMAND} -D root=${root}/tests/one_definition -P ${root}/cmake/check_one_definition.cmake
    ERROR_VARIABLE report)
string(REGEX MATCHALL "[^ \n]+ defines [^ ]+, as [^ ]+" found "${report}")
if(NOT found STREQUAL "engine/light.hpp defines Lit, as baker/light.cpp" AND NOT found STREQUAL "baker/light.cpp defines Lit, as engine/light.hpp")
    message(FATAL_ERROR "found ${found} in\n${report}")
endif()
