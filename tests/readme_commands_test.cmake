# Every command that README.md prints for a level of one's own works as printed, one after the other, on a level of ours.
# cmake -D root=FOLDER -D program=PATH -D folder=SCRATCH -P readme_commands_test.cmake
cmake_minimum_required(VERSION 3.25)

file(REMOVE_RECURSE ${folder}/readme)
file(MAKE_DIRECTORY ${folder}/readme)
configure_file(${root}/content/cornell/cornell.glb ${folder}/readme/level.glb COPYONLY)
file(STRINGS ${root}/README.md commands REGEX "^    build/afterglow ")
list(LENGTH commands count)
if(count LESS 5)
    message(FATAL_ERROR "README.md prints ${count} commands: this test no longer finds them")
endif()
foreach(command ${commands})
    # Sizes as printed, since pictures are compared; only the work per texel and pixel is less.
    string(REGEX REPLACE " *#.*" "" command "${command}")
    string(REGEX REPLACE "--samples [0-9]+" "--samples 1" command "${command}")
    string(REPLACE "--quality medium" "--quality draft --samples 1 --texels-per-metre 8" command "${command}")
    string(REPLACE "build/afterglow" ${program} command "${command}")
    separate_arguments(words UNIX_COMMAND "${command}")
    execute_process(COMMAND ${words} WORKING_DIRECTORY ${folder}/readme RESULT_VARIABLE code OUTPUT_VARIABLE said ERROR_VARIABLE said)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "README.md's command fails with ${code}: ${command}\n${said}")
    endif()
endforeach()
