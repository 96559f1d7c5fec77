# box(name SOURCES a.cpp ... USES lower boxes ... LIBRARIES third parties): one box of the design, one static library.
# USES is public: it is the arrow. LIBRARIES are private: a third party stays behind the file that includes it.
function(box name)
    cmake_parse_arguments(BOX "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
    add_library(${name} STATIC ${BOX_SOURCES})
    target_link_libraries(${name} PUBLIC laws ${BOX_USES} PRIVATE afterglow_warnings ${BOX_LIBRARIES})
endfunction()
