# What is defined once, and where; and words that have no place in a finished tree (ctest `written_once`).
# cmake -D root=FOLDER -P check_written_once.cmake
cmake_minimum_required(VERSION 3.25)

# pattern (of one line)                                                              its one place
set(definitions
    "3[.]14159|6[.]28318|1[.]57079|0[.]31830|M_PI|numbers::(inv_)?pi|(^|[^a-z_])pi<"    "shaders/constants.h" # pi, 2 pi, pi / 2, 1 / pi
    "0[.]2126|0[.]7152|0[.]0722"                                                        "shaders/color.h"     # luminance of Rec.709
    "12[.]92|0[.]0031308|0[.]04045|1[.]055"                                             "shaders/color.h"     # the sRGB curve
    "FN float [a-zA-Z]*[gG]gx[a-zA-Z]*D[(]|FN float (ggx[a-zA-Z]*Distribution|distribution[a-zA-Z]*Ggx|D_GGX)" "shaders/microfacet.h")

set(wrong 0)
function(complain sentence)
    message("${sentence}")
    math(EXPR wrong "${wrong} + 1")
    set(wrong ${wrong} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE sources RELATIVE ${root} ${root}/shaders/* ${root}/engine/* ${root}/baker/* ${root}/bench/*)
list(FILTER sources INCLUDE REGEX "[.](h|hpp|cpp|glsl|comp|vert|frag)$")
set(rest ${definitions})
while(rest)
    list(POP_FRONT rest pattern place)
    foreach(file ${sources})
        file(STRINGS ${root}/${file} lines REGEX "${pattern}")
        if(lines AND NOT file STREQUAL place)
            complain("${file} writes ${pattern} again: use ${place}")
        endif()
    endforeach()
endwhile()

file(GLOB_RECURSE texts RELATIVE ${root} ${root}/tests/* ${root}/cmake/* ${root}/content/*.py ${root}/content/*.md ${root}/README.md ${root}/run)
foreach(file ${sources} ${texts})
    file(STRINGS ${root}/${file} lines REGEX "(TO[D]O|FIX[M]E|X[X]X)")
    if(lines)
        complain("${file} leaves something undone: ${lines}")
    endif()
endforeach()
if(wrong)
    message(FATAL_ERROR "${wrong} lines to remove")
endif()
