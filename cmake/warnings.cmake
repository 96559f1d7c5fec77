# Warnings are errors in every target of ours; the laws are compiled with -Wdouble-promotion, which keeps GLSL and C++ one text.
add_library(afterglow_warnings INTERFACE)
target_compile_options(afterglow_warnings INTERFACE -Wall -Wextra -Werror -Wdouble-promotion -Wno-missing-field-initializers)
