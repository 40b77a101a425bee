# The library sheen_mesh, compiled once for the command and for sheen-panel, which take its objects. After mesh.cmake, where
# all that it names was found.
if(NOT TARGET sheen_mesh)
  add_library(sheen_mesh OBJECT ${sheen_mesh_sources})
  target_include_directories(sheen_mesh PRIVATE ${CMAKE_CURRENT_LIST_DIR}
    $<TARGET_PROPERTY:sheen_core,INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_definitions(sheen_mesh PRIVATE _GNU_SOURCE)
  # One rounding an operation, so that a mesh becomes the same bits on every machine.
  target_compile_options(sheen_mesh PRIVATE -ffp-contract=off)
  target_link_libraries(sheen_mesh PRIVATE ${sheen_mesh_libraries})
  # Its C++ is one unit: the headers of JSON take longer than all else in it.
  set(c_sources ${sheen_mesh_sources})
  list(FILTER c_sources EXCLUDE REGEX "\\.cpp$")
  set_source_files_properties(${c_sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(sheen_mesh PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
endif()
