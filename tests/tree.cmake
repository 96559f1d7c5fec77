# What holds for the tree as a whole: who includes whom, one text for two languages, each formula once, one layout.
function(tree_test name script)
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -D root=${PROJECT_SOURCE_DIR} ${ARGN} -P ${PROJECT_SOURCE_DIR}/${script})
endfunction()

tree_test(arrows cmake/check_arrows.cmake)
tree_test(arrows.the_checker_finds_each_forbidden_kind tests/arrows_test.cmake)
tree_test(readme cmake/check_readme.cmake)
if(TARGET afterglow)
    tree_test(readme.commands_work tests/readme_commands_test.cmake -D program=$<TARGET_FILE:afterglow> -D folder=${CMAKE_CURRENT_BINARY_DIR})
endif()
tree_test(written_once cmake/check_written_once.cmake)
tree_test(written_once.the_checker_finds_a_second_pi tests/written_once_test.cmake)
tree_test(one_definition cmake/check_one_definition.cmake)
tree_test(one_definition.the_checker_finds_a_second_type tests/one_definition_test.cmake)
tree_test(effect.names_the_missing_part tests/effect_test.cmake -D folder=${CMAKE_CURRENT_BINARY_DIR})

# The levels we keep are what their scripts make, byte for byte where the pictures' packing allows; only Python's own library is asked.
find_program(python python3)
if(python)
    file(GLOB levels RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/content/*/*.glb)
    add_test(NAME content.is_valid_gltf COMMAND ${python} content/check.py ${levels} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    add_test(NAME content.is_what_its_scripts_make COMMAND ${python} content/make --check WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(content.is_what_its_scripts_make PROPERTIES LABELS slow)
endif()

# The format is judged by the clang-format that the front door asks for, where there is one.
find_program(clang_format clang-format)
if(clang_format)
    add_test(NAME format COMMAND ${PROJECT_SOURCE_DIR}/run format --check)
endif()

# Every header that both languages read; a new one is met at the next configuration.
find_program(glslang_program NAMES glslangValidator glslang)
file(GLOB dialect RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/shaders/*.h ${PROJECT_SOURCE_DIR}/engine/effects/*.h ${PROJECT_SOURCE_DIR}/engine/effects/*/*.h)
if(glslang_program)
    foreach(header ${dialect})
        string(REGEX REPLACE "^(shaders|engine/effects)/|[.]h$" "" name ${header})
        get_filename_component(header_folder ${CMAKE_BINARY_DIR}/dialect/${name} DIRECTORY)
        tree_test(dialect.${name} cmake/check_dialect.cmake
                  -D header=${header} -D folder=${header_folder} -D glslang=${glslang_program} -D cxx=${CMAKE_CXX_COMPILER}
                  "-D flags=-Wall -Wextra -Werror -Wdouble-promotion")
    endforeach()

    # Every shader, as the program compiles it.
    file(GLOB_RECURSE shaders RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS
         ${PROJECT_SOURCE_DIR}/engine/*.vert ${PROJECT_SOURCE_DIR}/engine/*.frag ${PROJECT_SOURCE_DIR}/engine/*.comp
         ${PROJECT_SOURCE_DIR}/engine/*.rgen ${PROJECT_SOURCE_DIR}/engine/*.rmiss ${PROJECT_SOURCE_DIR}/engine/*.rchit ${PROJECT_SOURCE_DIR}/engine/*.rahit)
    find_program(spirv_val spirv-val)
    foreach(shader ${shaders})
        string(REGEX REPLACE "^engine/(effects/)?" "" name ${shader})
        get_filename_component(shader_folder ${CMAKE_BINARY_DIR}/dialect/${name} DIRECTORY)
        tree_test(shader.${name} cmake/check_shader.cmake
                  -D shader=${shader} -D folder=${shader_folder} -D glslang=${glslang_program} -D spirv_val=${spirv_val})
    endforeach()

    # The structs of the dialect, in one shader and one C++ file.
    set(abi ${CMAKE_CURRENT_BINARY_DIR}/abi)
    list(JOIN dialect "," dialect_argument)
    list(TRANSFORM dialect PREPEND ${PROJECT_SOURCE_DIR}/)
    add_custom_command(
        OUTPUT ${abi}/abi.spv ${abi}/abi_headers.inc ${abi}/abi_members.inc
        COMMAND ${CMAKE_COMMAND} -D root=${PROJECT_SOURCE_DIR} -D headers=${dialect_argument} -D folder=${abi}
                -P ${PROJECT_SOURCE_DIR}/cmake/generate_abi.cmake
        COMMAND ${glslang_program} --quiet --target-env vulkan1.3 -I${PROJECT_SOURCE_DIR} -o ${abi}/abi.spv ${abi}/abi.comp
        DEPENDS ${dialect} ${PROJECT_SOURCE_DIR}/cmake/generate_abi.cmake
        COMMENT "Laying every shared struct out in a shader")
    suite(abi_test SOURCES abi_test.cpp)
    target_sources(abi_test PRIVATE ${abi}/abi_members.inc)
    target_include_directories(abi_test PRIVATE ${abi})
    target_compile_definitions(abi_test PRIVATE AFTERGLOW_ABI_SPIRV="${abi}/abi.spv")
else()
    message(STATUS "The tests `dialect`, `shader` and `abi` are left out: glslang-tools is missing")
endif()
