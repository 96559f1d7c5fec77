# The levels in content/ are valid glTF, and are what their scripts make.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND)
    file(GLOB levels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/content/*/*.glb)
    add_test(NAME content_valid COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/content/check.py ${levels})
    add_test(NAME content_made_by_scripts COMMAND ${Python3_EXECUTABLE} -B ${PROJECT_SOURCE_DIR}/content/make --check)
endif()
