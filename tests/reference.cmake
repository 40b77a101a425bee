# The reference: the picture in double precision, and the tests that compare with it.
add_library(reference STATIC
  reference/ref_mesh.c reference/ref_between.c reference/ref_split.c reference/ref_project.c reference/ref_light.c
  reference/ref_raster.c reference/ref_shade.c reference/ref_texture.c reference/ref_pixel.c reference/ref_compare.c
  shapes.c)
target_include_directories(reference PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(reference PUBLIC m)

# Draws scenes of the reference with the core; each program links the core of its choice.
add_library(core_picture STATIC core_picture.c memory_target.c frame_stage.c accuracy.c)
target_include_directories(core_picture PUBLIC ${PROJECT_SOURCE_DIR}/core)
target_link_libraries(core_picture PUBLIC reference)

sheen_test(test_reference unit SOURCES test_reference.c LIBRARIES reference)
sheen_test(test_reference_mesh unit SOURCES test_reference_mesh.c LIBRARIES reference)
sheen_test(test_accuracy accuracy SOURCES test_accuracy.c accuracy_line.c loaded_mesh.c
  LIBRARIES core_picture sheen_host sheen::core)
sheen_test(test_textured accuracy SOURCES test_textured.c textured_scene.c accuracy_line.c
  LIBRARIES core_picture sheen::core)
sheen_test(test_texel_ends accuracy SOURCES test_texel_ends.c textured_scene.c LIBRARIES core_picture sheen::core)
sheen_test(test_matcap accuracy SOURCES test_matcap.c textured_scene.c accuracy_line.c
  LIBRARIES core_picture sheen::core)
if(NOT SHEEN_SANITIZED) # the quick part draws a third of the pictures
  foreach(name test_accuracy test_textured test_matcap)
    add_test(NAME ${name}_all COMMAND ${name} all WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    sheen_part(${name}_all long TARGETS ${name})
  endforeach()
endif()
sheen_test(test_colored accuracy SOURCES test_colored.c LIBRARIES core_picture sheen::core)
sheen_test(test_gltf_picture accuracy SOURCES test_gltf_picture.c LIBRARIES core_picture sheen_host sheen::core)
sheen_test(test_fog accuracy SOURCES test_fog.c textured_scene.c accuracy_line.c
  LIBRARIES core_picture sheen::core)
sheen_test(test_morph accuracy SOURCES test_morph.c textured_scene.c accuracy_line.c
  LIBRARIES core_picture sheen::core)
sheen_test(test_lines frames SOURCES test_lines.c edge_picture.c edge_meshes.c loaded_mesh.c
  LIBRARIES core_picture sheen_host sheen::core)
add_executable(test_smooth test_smooth.c edge_picture.c edge_meshes.c loaded_mesh.c)
target_link_libraries(test_smooth PRIVATE core_picture sheen_host sheen::core)
sheen_script(smooth accuracy COMMAND $<TARGET_FILE:test_smooth>)
if(NOT SHEEN_SANITIZED)
  sheen_script(smooth_samples long COMMAND $<TARGET_FILE:test_smooth> samples)
endif()
add_executable(test_accuracy_random test_accuracy_random.c random_scene.c textured_scene.c)
target_link_libraries(test_accuracy_random PRIVATE core_picture sheen::core)
sheen_script(accuracy_random accuracy COMMAND $<TARGET_FILE:test_accuracy_random> 500)
sheen_script(accuracy_random_deep accuracy COMMAND $<TARGET_FILE:test_accuracy_random> 400 0 270)
foreach(number 10248 23943 27112) # these were once outside their limits
  sheen_script(accuracy_random_${number} accuracy COMMAND $<TARGET_FILE:test_accuracy_random> 1 ${number})
endforeach()
if(NOT SHEEN_SANITIZED)
  sheen_script(accuracy_random_long long COMMAND $<TARGET_FILE:test_accuracy_random> 30000)
endif()
add_executable(test_mixed test_mixed.c random_scene.c textured_scene.c)
target_link_libraries(test_mixed PRIVATE core_picture sheen::core)
sheen_script(mixed accuracy COMMAND $<TARGET_FILE:test_mixed> 768)
sheen_test(test_coverage coverage SOURCES test_coverage.c core_raster.c exact_cover.c
  LIBRARIES core_picture sheen::core)
# Both forms of edge.c, linked instead of the library's.
foreach(form division reciprocal)
  string(COMPARE EQUAL ${form} reciprocal no_divider)
  add_executable(test_edges_${form} test_edges.c ${PROJECT_SOURCE_DIR}/core/triangle/edge.c)
  target_compile_definitions(test_edges_${form} PRIVATE SHEEN_NO_DIVIDER=${no_divider})
  target_link_libraries(test_edges_${form} PRIVATE sheen::core)
  sheen_script(edges_${form} coverage COMMAND $<TARGET_FILE:test_edges_${form}>)
  if(NOT SHEEN_SANITIZED)
    sheen_script(edges_${form}_all long COMMAND $<TARGET_FILE:test_edges_${form}> all)
  endif()
endforeach()
sheen_test(test_depth coverage SOURCES test_depth.c core_raster.c LIBRARIES core_picture sheen::core)
sheen_test(test_snapping coverage SOURCES test_snapping.c LIBRARIES core_picture sheen::core)
sheen_test(test_panel_picture accuracy SOURCES test_panel_picture.c LIBRARIES core_picture sheen_sim sheen::core)
sheen_test(test_grey accuracy SOURCES test_grey.c LIBRARIES core_picture sheen::core)

# Tests test_accuracy: links the core's tables except the root table, which the program defines itself and changes.
add_library(core_tables OBJECT ${PROJECT_SOURCE_DIR}/core/math/tables.c)
target_include_directories(core_tables PRIVATE ${PROJECT_SOURCE_DIR}/core)
target_compile_definitions(core_tables PRIVATE sheen_root_table=shipped_root_table)
sheen_test(test_root_fault accuracy SOURCES test_root_fault.c $<TARGET_OBJECTS:core_tables>
  LIBRARIES core_picture sheen::core)
