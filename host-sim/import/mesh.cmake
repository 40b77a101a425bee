# The readers of mesh files and of their pictures, for the command and for sheen-panel: what they are, link, and need to be found.
set(sheen_mesh_packages assimp EXPAT draco JPEG meshoptimizer nlohmann_json PNG)
set(sheen_mesh_libraries assimp::assimp EXPAT::EXPAT draco::draco JPEG::JPEG meshoptimizer::meshoptimizer PNG::PNG
  PkgConfig::seccomp)
set(sheen_mesh_sources
  confine.c
  gltf_accessor.cpp
  gltf_color.cpp
  gltf_draco.cpp
  gltf_file.cpp
  gltf_json.cpp
  gltf_nodes.cpp
  gltf_shape.cpp
  mesh_assimp.c
  mesh_assimp_io.c
  mesh_bytes.c
  mesh_dae_check.c
  mesh_dae_numbers.c
  mesh_file.c
  mesh_format.c
  mesh_gltf.cpp
  mesh_mtl.c
  mesh_obj.c
  mesh_off.c
  mesh_ply.c
  mesh_ply_header.c
  mesh_ply_number.c
  mesh_sink.c
  mesh_stl.c
  mesh_text.c
  mesh_wire.c
  picture.c
  picture_jpeg.c
  picture_png.c
  simplify.c
  textures.c
)
list(TRANSFORM sheen_mesh_sources PREPEND ${CMAKE_CURRENT_LIST_DIR}/)
