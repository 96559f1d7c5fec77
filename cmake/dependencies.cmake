# Every third party, found once. Names are Debian 12's; what Debian 13 and Ubuntu 24.04 call or lay out otherwise ends here:
# embree, OpenMesh, glslang, imgui, stb, tinygltf and zstd are the same target on all three.
find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(spdlog REQUIRED)
find_package(fmt REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(Vulkan REQUIRED)
find_package(glfw3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(GTest QUIET) # for the tests
find_package(nlohmann_json REQUIRED)

# third_party(name targets...): one name for what the distributions split or name differently; targets that are not there are left out.
function(third_party name)
    add_library(${name} INTERFACE)
    foreach(target ${ARGN})
        if(TARGET ${target})
            target_link_libraries(${name} INTERFACE ${target})
        endif()
    endforeach()
endfunction()

# Embree 4 (Debian 13, Ubuntu 24.04) or 3: world.cpp and world_rays.cpp speak both, told by AFTERGLOW_EMBREE which.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
    find_package(embree 3 REQUIRED)
endif()
string(REGEX MATCH "^[0-9]+" embree_major ${embree_VERSION})
set_property(TARGET embree APPEND PROPERTY INTERFACE_COMPILE_DEFINITIONS AFTERGLOW_EMBREE=${embree_major})

find_package(Eigen3 REQUIRED)
find_package(OpenMesh REQUIRED)
third_party(OpenMesh OpenMeshCore OpenMeshTools)

# SPIRV-Tools first: glslang's targets name its libraries.
find_package(SPIRV-Tools QUIET)
find_package(SPIRV-Tools-opt QUIET)
find_package(SPIRV-Tools-link QUIET)
find_package(glslang REQUIRED)
third_party(glslang glslang::glslang glslang::SPIRV glslang::glslang-default-resource-limits)

find_package(TinyGLTF REQUIRED)
third_party(tinygltf TinyGLTF::TinyGLTF)

pkg_check_modules(imgui_package REQUIRED IMPORTED_TARGET imgui)
third_party(imgui PkgConfig::imgui_package)
target_include_directories(imgui SYSTEM INTERFACE ${imgui_package_INCLUDEDIR}/backends)

pkg_check_modules(stb_package REQUIRED IMPORTED_TARGET stb)
third_party(stb PkgConfig::stb_package)

pkg_check_modules(zstd_package REQUIRED IMPORTED_TARGET libzstd)
third_party(zstd PkgConfig::zstd_package)
