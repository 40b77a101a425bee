# Stands for ESP-IDF's build, first pass: cmake -P with -D COMPONENT=folder. What a component registers ends its file;
# project() and add_library() are errors there.
set(ESP_PLATFORM 1)
macro(idf_component_register)
  message(STATUS "registered with ${ARGC} words")
  set(registered 1)
  return()
endmacro()
include(${COMPONENT}/CMakeLists.txt)
if(NOT registered)
  message(FATAL_ERROR "${COMPONENT}/CMakeLists.txt registers nothing")
endif()
