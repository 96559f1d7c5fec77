# Which file may include which: the rows of the design as data, and every #include held against them (ctest `arrows`).
# cmake -D root=FOLDER -P check_arrows.cmake: one line per forbidden include on stderr, and failure when there is one.
cmake_minimum_required(VERSION 3.25)

# A file includes its own box and lower rows, never a neighbour in its row, never the other column.
# folder          row column
set(boxes
    shaders         0 shared
    engine/core     1 shared
    engine/scene    2 shared
    engine/baked    3 shared
    baker           6 offline
    engine/gpu      2 runtime
    engine/graph    3 runtime
    engine/upload   4 runtime
    engine/effects  5 runtime
    engine/frame    6 runtime
    engine/app      7 shared
    bench           8 shared)

# One dependency, one place: who may include what (regular expressions, over the header and over the including file).
set(runtime "^engine/(gpu|graph|upload|effects|frame)/")
set(third_parties
    "^tiny_gltf"                  "^engine/scene/gltf.*[.]cpp$"
    "^embree[34]/"                "^baker/world_embree[.]hpp"
    "^OpenMesh/"                  "^baker/(half_edges|lod|atlas)[a-z_]*[.](cpp|hpp)$"
    "^Eigen/"                     "^baker/(atlas_(rigid|unroll)|local_fit|agreement)[.]cpp$"
    "^(glslang|SPIRV)/"           "^engine/gpu/shader.*[.]cpp$"
    "^(GLFW/|imgui)"              "^engine/gpu/window.*[.]cpp$"
    "^vulkan/"                    "${runtime}"
    "^(Imf|Imath|OpenEXR|half)"   "^engine/core/exr[.]cpp$"
    "^stb"                        "^engine/core/stb[.]cpp$"
    "^zstd"                       "^engine/baked/.*[.]cpp$"
    "^CLI/"                       "^(engine/app/.*|bench/main)[.]cpp$"
    "^spdlog/"                    "^engine/core/log[.]cpp$"
    "^fmt/"                       "[.]cpp$"
    "^nlohmann/json_fwd[.]hpp$"   "."
    "^nlohmann/"                  "[.]cpp$"
    "^glm/"                       "."
    # The standard library, and what of the system a file may ask for.
    "^[a-z_0-9]+$"                "."
    "^([xpei]mmintrin|unistd|fcntl|signal|dlfcn|link|termios)[.]h$|^sys/" "^engine/(core|app|gpu)/.*[.]cpp$|^baker/[a-z_]*[.]cpp$|^bench/[a-z_]*[.]cpp$")

# The box that a path lies in, its row and column; box is empty outside every box.
function(box_of path)
    set(rest ${boxes})
    while(rest)
        list(POP_FRONT rest folder row column)
        if(path MATCHES "^${folder}/")
            set(box ${folder} PARENT_SCOPE)
            set(row ${row} PARENT_SCOPE)
            set(column ${column} PARENT_SCOPE)
            return()
        endif()
    endwhile()
    set(box "" PARENT_SCOPE)
endfunction()

# Why `file` may not include the project's `header`; empty when it may.
function(project_arrow file header)
    set(why "" PARENT_SCOPE)
    box_of(${file})
    set(from_box ${box})
    set(from_row ${row})
    set(from_column ${column})
    box_of(${header})
    if(NOT EXISTS ${root}/${header})
        set(why "there is no such file: a project header is named from the root" PARENT_SCOPE)
    elseif(NOT box)
        set(why "it lies outside every box" PARENT_SCOPE)
    elseif(box STREQUAL from_box)
        # One effect, one folder: effects share what lies beside their folders, never each other.
        string(REGEX MATCH "^engine/effects/[^/]+/" theirs ${header})
        if(theirs AND NOT file MATCHES "^${theirs}")
            set(why "an effect never includes another" PARENT_SCOPE)
        endif()
    elseif(NOT row LESS from_row)
        set(why "row ${from_row} includes only lower rows, and ${box} is row ${row}" PARENT_SCOPE)
    elseif(NOT column STREQUAL "shared" AND NOT from_column STREQUAL "shared" AND NOT column STREQUAL from_column)
        set(why "the ${from_column} column never sees the ${column} one" PARENT_SCOPE)
    elseif(from_column STREQUAL "shared" AND NOT column STREQUAL "shared" AND from_row LESS 7)
        set(why "only engine/app and bench see both columns" PARENT_SCOPE)
    endif()
endfunction()

# Why `file` may not include <header>; empty when it may.
function(third_party_arrow file header)
    set(why "no place in the table of third parties" PARENT_SCOPE)
    set(rest ${third_parties})
    while(rest)
        list(POP_FRONT rest pattern place)
        if(header MATCHES "${pattern}")
            set(why "" PARENT_SCOPE)
            if(NOT file MATCHES "${place}")
                set(why "it has one place, ${place}" PARENT_SCOPE)
            endif()
            return()
        endif()
    endwhile()
endfunction()

set(forbidden 0)
file(GLOB_RECURSE files RELATIVE ${root} ${root}/shaders/* ${root}/engine/* ${root}/baker/* ${root}/bench/*)
foreach(file ${files})
    if(NOT file MATCHES "[.](h|hpp|cpp|glsl|comp|vert|frag)$")
        continue()
    endif()
    file(STRINGS ${root}/${file} includes REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
    foreach(include ${includes})
        string(REGEX MATCH "([<\"])([^>\"]+)" ignored "${include}")
        set(header ${CMAKE_MATCH_2})
        if(CMAKE_MATCH_1 STREQUAL "<")
            third_party_arrow(${file} ${header})
        else()
            project_arrow(${file} ${header})
        endif()
        if(why)
            message("${file} includes ${header}: ${why}")
            math(EXPR forbidden "${forbidden} + 1")
        endif()
    endforeach()
endforeach()
if(forbidden)
    message(FATAL_ERROR "${forbidden} forbidden includes")
endif()
