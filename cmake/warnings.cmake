# Warnings are errors in every target of ours; the laws are compiled with -Wdouble-promotion, which keeps GLSL and C++ one text.
add_library(afterglow_warnings INTERFACE)
target_compile_options(afterglow_warnings INTERFACE -Wall -Wextra -Werror -Wdouble-promotion -Wno-missing-field-initializers)

# Both sanitizers end the program at the first finding, so that a test cannot pass over one.
if(AFTERGLOW_SANITIZE)
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # The checks they weave in make GCC see paths that are none.
    target_compile_options(afterglow_warnings INTERFACE ${sanitizers} -Wno-maybe-uninitialized)
    target_link_options(afterglow_warnings INTERFACE ${sanitizers})
endif()
