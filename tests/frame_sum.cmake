# Prints a checksum per picture (frame_sum.c). It needs only the core, so it is built for other processors too.
add_executable(frame_sum frame_sum.c frame_sum_mesh.c)
target_link_libraries(frame_sum PRIVATE sheen::core)
