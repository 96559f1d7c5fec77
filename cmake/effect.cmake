# effect(fog): one effect is one folder and five parts; names the missing part, and the missing heading of its study.
# engine/effects/CMakeLists.txt calls it once for each effect; the sources come back in <name>_sources.
set(study_headings Question Model Approximation Truth Error Cost "Tried and lost")

function(effect name)
    set(folder engine/effects/${name})
    set(missing "")
    foreach(part
            ${folder}/${name}.h     # parameters and maths, both languages
            ${folder}/${name}.cpp   # the pass
            ${folder}/README.md     # the study
            tests/${folder}_test.cpp)
        if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${part})
            list(APPEND missing ${part})
        endif()
    endforeach()
    file(GLOB shaders ${PROJECT_SOURCE_DIR}/${folder}/*.comp ${PROJECT_SOURCE_DIR}/${folder}/*.vert ${PROJECT_SOURCE_DIR}/${folder}/*.frag)
    if(NOT shaders)
        list(APPEND missing "${folder}/${name}.frag (or .comp, .vert)")
    endif()
    if(EXISTS ${PROJECT_SOURCE_DIR}/${folder}/README.md)
        file(READ ${PROJECT_SOURCE_DIR}/${folder}/README.md study)
        foreach(heading ${study_headings})
            if(NOT study MATCHES "\n#+ ${heading}[ \t]*\n")
                list(APPEND missing "the heading '${heading}' in ${folder}/README.md")
            endif()
        endforeach()
    endif()
    if(missing)
        list(JOIN missing ", " missing)
        message(FATAL_ERROR "The effect '${name}' is not whole; it lacks ${missing}")
    endif()
    set(${name}_sources ${name}/${name}.cpp PARENT_SCOPE)
endfunction()
