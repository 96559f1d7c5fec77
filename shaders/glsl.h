// The shared dialect: every shaders/*.h compiles as GLSL (Vulkan 1.3) and as C++ (GLM), from the same text.
// C++ is the strict side: no swizzles (vec2(v), not v.xy), f suffixes, no array constructors, functions before use.
// The six macros: SHARED_BEGIN and SHARED_END open and close the namespace, FN marks a function, IN(T) a parameter too large to copy,
// OUT(T) and INOUT(T) its output parameters.
#ifndef AFTERGLOW_GLSL_H
#define AFTERGLOW_GLSL_H

#ifdef __cplusplus
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>

namespace shared
{
using namespace glm;
using uint = glm::uint;
}
#define SHARED_BEGIN                                                                                                                       \
    namespace shared                                                                                                                       \
    {
#define SHARED_END }
#define FN inline
#define IN(T) const T&
#define OUT(T) T&
#define INOUT(T) T&
#else
#define SHARED_BEGIN
#define SHARED_END
#define FN
#define IN(T) in T
#define OUT(T) out T
#define INOUT(T) inout T
#endif

#endif
