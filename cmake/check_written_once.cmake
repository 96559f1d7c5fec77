# What is defined once, and where; and words that have no place in a finished tree (ctest `written_once`).
# cmake -D root=FOLDER -P check_written_once.cmake
cmake_minimum_required(VERSION 3.25)

# pattern of a line                                                                  its one place
set(definitions
    "3[.]14159|6[.]28318|1[.]57079|0[.]31830|M_PI|numbers::(inv_)?pi|(^|[^a-z_])pi<"    "shaders/constants.h"  # pi and its kin
    "0[.]2126|0[.]7152|0[.]0722"                                                        "shaders/color.h"      # luminance of Rec.709
    "12[.]92|0[.]0031308|0[.]04045|1[.]055"                                             "shaders/color.h"      # the sRGB curve
    "float (D_GGX|[a-zA-Z]*[gG]gx[a-zA-Z]*(D|Distribution)|distribution[a-zA-Z]*G[gG][xX])[(]|a(lpha)?2 - 1" "shaders/microfacet.h"
    "0[.]28209|0[.]48860|1[.]09254|0[.]31539|0[.]54627"                                 "shaders/sh.h"         # the basis, order 2
    "747796405|2891336453|277803737"                                         "shaders/random.h")    # hashes

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
            list(GET lines 0 line)
            string(STRIP "${line}" line)
            complain("${file} writes again what ${place} defines: ${line}")
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
