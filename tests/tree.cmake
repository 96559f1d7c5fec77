# What holds for the tree as a whole: who includes whom, one text for two languages, each formula once, one layout.
function(tree_test name script)
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -D root=${PROJECT_SOURCE_DIR} ${ARGN} -P ${PROJECT_SOURCE_DIR}/${script})
endfunction()

tree_test(arrows cmake/check_arrows.cmake)
tree_test(arrows.the_checker_finds_each_forbidden_kind tests/arrows_test.cmake)
tree_test(written_once cmake/check_written_once.cmake)

# The format is judged by the clang-format that the front door asks for, where there is one.
find_program(clang_format clang-format)
if(clang_format)
    add_test(NAME format COMMAND ${PROJECT_SOURCE_DIR}/run format --check)
endif()

# Every header that both languages read; a new one is met at the next configuration.
find_program(glslang_program NAMES glslangValidator glslang)
if(glslang_program)
    file(GLOB dialect RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
         ${PROJECT_SOURCE_DIR}/shaders/*.h ${PROJECT_SOURCE_DIR}/engine/effects/*.h ${PROJECT_SOURCE_DIR}/engine/effects/*/*.h)
    foreach(header ${dialect})
        get_filename_component(name ${header} NAME_WE)
        tree_test(dialect.${name} cmake/check_dialect.cmake
                  -D header=${header} -D folder=${CMAKE_BINARY_DIR}/dialect -D glslang=${glslang_program} -D cxx=${CMAKE_CXX_COMPILER}
                  "-D flags=-Wall -Wextra -Werror -Wdouble-promotion")
    endforeach()
else()
    message(STATUS "The tests `dialect` and `abi` are left out: glslang-tools is missing")
endif()
