# The README routes; a route must lead somewhere: every path that it names in backquotes exists (ctest `readme`).
# cmake -D root=FOLDER -P check_readme.cmake
cmake_minimum_required(VERSION 3.25)

file(READ ${root}/README.md text)
string(REGEX MATCHALL "`[A-Za-z_./]+/[A-Za-z_./]*`|`[A-Z]+`" routes "${text}")
list(REMOVE_DUPLICATES routes)
set(lost "")
foreach(route ${routes})
    string(REGEX REPLACE "`" "" path "${route}")
    if(NOT path MATCHES "^(build|out)/|^[.]/run" AND NOT EXISTS ${root}/${path})
        list(APPEND lost ${path})
    endif()
endforeach()
if(lost)
    list(JOIN lost ", " lost)
    message(FATAL_ERROR "README.md leads to what is not there: ${lost}")
endif()
