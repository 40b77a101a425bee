# Stands for the first pass of ESP-IDF's build: cmake -P with -D COMPONENT=folder. The component's file ends at its
# idf_component_register(); project() and add_library() before it are errors.
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
