# The checker itself: the tree in tests/one_definition defines Lit and Mirror twice; its other names lie in other scopes.
execute_process(COMMAND ${CMAKE_COMMAND} -D root=${root}/tests/one_definition -P ${root}/cmake/check_one_definition.cmake
    ERROR_VARIABLE report)
string(REGEX MATCHALL "defines [^ ,\n]+|closes nothing" found "${report}")
list(SORT found)
if(NOT found STREQUAL "defines Lit;defines Mirror")
    message(FATAL_ERROR "found ${found} in\n${report}")
endif()
