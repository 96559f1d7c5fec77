# One shader, compiled as the program compiles it and held against Vulkan's rules for SPIR-V (ctest `shader.<name>`).
# cmake -D root=FOLDER -D shader=engine/effects/fog/fog.frag -D folder=SCRATCH -D glslang=PROGRAM -D spirv_val=PROGRAM -P check_shader.cmake
cmake_minimum_required(VERSION 3.25)

# What engine/gpu/shader.cpp switches on for every shader.
set(preamble "")
foreach(extension GL_GOOGLE_include_directive GL_EXT_scalar_block_layout GL_EXT_buffer_reference GL_EXT_nonuniform_qualifier)
    string(APPEND preamble "#extension ${extension} : require\n")
endforeach()

function(passes)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
    if(result OR out MATCHES "WARNING")
        message(FATAL_ERROR "${shader}:\n${out}")
    endif()
endfunction()

file(MAKE_DIRECTORY ${folder})
get_filename_component(name ${shader} NAME)
file(READ ${root}/${shader} text)
string(REGEX REPLACE "(#version [^\n]*\n)" "\\1${preamble}" text "${text}")
file(WRITE ${folder}/${name} "${text}")
passes(${glslang} --quiet --target-env vulkan1.3 -I${root} -o ${folder}/${name}.spv ${folder}/${name})
passes(${spirv_val} --target-env vulkan1.3 --scalar-block-layout ${folder}/${name}.spv)
