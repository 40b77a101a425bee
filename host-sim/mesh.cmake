# The readers of mesh files, for the command and for sheen-panel.
set(sheen_mesh_sources
  confine.c
  mesh_assimp.c
  mesh_file.c
  mesh_format.c
  mesh_wire.c
  obj_check.c
  ply_check.c
)
list(TRANSFORM sheen_mesh_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
