# The checker itself: the tree in tests/written_once writes pi and the luminance a second time.
execute_process(COMMAND ${CMAKE_COMMAND} -D root=${root}/tests/written_once -P ${root}/cmake/check_written_once.cmake ERROR_VARIABLE report)
string(REGEX MATCHALL "engine/light.cpp writes again what [^ ]+" found "${report}")
list(TRANSFORM found REPLACE ".* " "")
if(NOT found STREQUAL "shaders/constants.h;shaders/color.h")
    message(FATAL_ERROR "found ${found} in\n${report}")
endif()
