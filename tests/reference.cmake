# The picture in double precision, and the shapes that tests draw.
add_library(reference STATIC
  reference/ref_mesh.c reference/ref_split.c reference/ref_project.c reference/ref_light.c
  reference/ref_raster.c reference/ref_shade.c reference/ref_pixel.c reference/ref_compare.c
  shapes.c)
target_include_directories(reference PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(reference PUBLIC m)

sheen_test(test_reference unit SOURCES test_reference.c LIBRARIES reference)
