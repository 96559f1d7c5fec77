# One header of the dialect, alone, by both compilers and without a warning (ctest `dialect.<name>`).
# cmake -D root=FOLDER -D header=shaders/bsdf.h -D folder=SCRATCH -D glslang=PROGRAM -D cxx=COMPILER -D flags=... -P check_dialect.cmake
# A header that calls what its includer defines (shaders/transport.h) finds that in tests/dialect/<name>.h.
cmake_minimum_required(VERSION 3.25)

get_filename_component(name ${header} NAME_WE)
set(text "")
if(EXISTS ${root}/tests/dialect/${name}.h)
    string(APPEND text "#include \"tests/dialect/${name}.h\"\n")
endif()
string(APPEND text "#include \"${header}\"\n")

function(compiles language)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE out)
    if(result OR out MATCHES "WARNING")
        message(FATAL_ERROR "${header} alone, as ${language}:\n${out}")
    endif()
endfunction()

file(MAKE_DIRECTORY ${folder})
set(shader ${folder}/${name}.comp)
file(WRITE ${shader} "#version 460\n#extension GL_GOOGLE_include_directive : require\n#extension GL_EXT_scalar_block_layout : require\n"
                     "${text}layout(local_size_x = 1) in;\nvoid main() {}\n")
compiles(GLSL ${glslang} --target-env vulkan1.3 -I${root} -o ${folder}/${name}.spv ${shader})

set(source ${folder}/${name}.cpp)
file(WRITE ${source} "${text}int main() {}\n")
separate_arguments(flags)
compiles("C++" ${cxx} -std=c++20 -fsyntax-only -I${root} ${flags} ${source})
