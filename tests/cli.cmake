# Mesh files, pictures, and the command sheen.
sheen_test(test_import unit SOURCES test_import.c test_import_files.c LIBRARIES sheen::host sheen::core m)
sheen_test(test_import_reference unit SOURCES test_import_reference.c LIBRARIES sheen::host sheen::core reference m)
sheen_test(test_reduce unit SOURCES test_reduce.c LIBRARIES sheen::host sheen::core m)
find_package(GIF REQUIRED)
sheen_test(test_gif unit SOURCES test_gif.c LIBRARIES sheen::host sheen::core GIF::GIF)
sheen_test(test_problem unit SOURCES test_problem.c LIBRARIES sheen::host sheen::core)
sheen_test(test_png unit SOURCES test_png.c LIBRARIES sheen::host sheen::core)

# Tests with many files, frames or figures are in the long part if they run with sanitizers.
set(many cli)
if(SHEEN_SANITIZED)
  set(many long)
endif()
sheen_script(cli_usage cli COMMAND tests/cli/usage $<TARGET_FILE:sheen>)
sheen_script(cli_render ${many} COMMAND tests/cli/render $<TARGET_FILE:sheen> tests/data/egg.obj)
sheen_script(cli_plan ${many} COMMAND tests/cli/plan $<TARGET_FILE:sheen>)
sheen_script(cli_plan_table cli COMMAND host-sim/pages/plan.py $<TARGET_FILE:sheen> --readme README.md)
sheen_script(cli_hero cli COMMAND tests/cli/hero $<TARGET_FILE:sheen> .)
sheen_script(cli_man cli COMMAND tests/cli/man $<TARGET_FILE:sheen>)
sheen_test(test_import_confined unit SOURCES test_import_confined.c test_import_files.c LIBRARIES sheen::host sheen::core)
sheen_script(cli_bad_input cli COMMAND tests/cli/bad_input $<TARGET_FILE:sheen>)
sheen_test(test_import_hostile unit SOURCES test_import_hostile.c test_import_files.c LIBRARIES sheen::host sheen::core m)
sheen_script(cli_morph ${many} COMMAND tests/cli/morph $<TARGET_FILE:sheen> .)
sheen_script(cli_bake cli COMMAND tests/cli/bake $<TARGET_FILE:sheen> .)
sheen_script(cli_mesh_files ${many} COMMAND tests/cli/mesh_files $<TARGET_FILE:sheen>)
find_package(draco REQUIRED)
find_package(meshoptimizer REQUIRED)
add_executable(gltf_pack tools/gltf_pack.cpp)
target_link_libraries(gltf_pack PRIVATE draco::draco meshoptimizer::meshoptimizer)
sheen_script(cli_gltf ${many} COMMAND tests/cli/gltf $<TARGET_FILE:sheen> $<TARGET_FILE:gltf_pack>)
# All models that assimp brings.
sheen_script(cli_models long COMMAND tests/cli/models $<TARGET_FILE:sheen> /usr/share/assimp/models
  $<$<BOOL:${SHEEN_SANITIZED}>:sanitized>)
sheen_script(cli_textures long COMMAND tests/cli/textures $<TARGET_FILE:sheen> /usr/share/assimp/models
  $<$<BOOL:${SHEEN_SANITIZED}>:sanitized>)
sheen_script(cli_colors cli COMMAND tests/cli/colors $<TARGET_FILE:sheen>)

# Headers baked during the build, for a program that draws from them.
set(baked ${CMAKE_CURRENT_BINARY_DIR}/baked)
file(MAKE_DIRECTORY ${baked})
function(sheen_baked header mesh)
  add_custom_command(OUTPUT ${baked}/${header} COMMAND sheen bake ${mesh} -o ${baked}/${header} ${ARGN}
    DEPENDS sheen WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
endfunction()
sheen_baked(baked_teapot.h builtin:teapot)
sheen_baked(baked_egg.h data/egg.obj)
sheen_baked(baked_egg_crease.h data/egg.obj --normals average --crease 12.5 --weights equal --no-flat --name smooth)
sheen_baked(baked_box.h data/box.obj --groups)
sheen_baked(baked_crate.h data/crate.obj --palette 16 --filter bilinear)
sheen_baked(baked_crate_565.h data/crate.obj --texture-size 32 --name crate_565)
set(shines "")
foreach(n 1 7 24 127)
  sheen_baked(baked_shine_${n}.h shine:${n})
  list(APPEND shines ${baked}/baked_shine_${n}.h)
endforeach()
sheen_baked(baked_ramp.h ramp:gamma --ambient 0.1 --diffuse 0.7)
sheen_baked(baked_ramp_near.h ramp:gamma:2.2000001 --ambient 1.5 --diffuse 0.25)
sheen_test(test_bake unit SOURCES test_bake.c ${shines} ${baked}/baked_ramp.h ${baked}/baked_ramp_near.h ${baked}/baked_teapot.h ${baked}/baked_egg.h ${baked}/baked_egg_crease.h
  ${baked}/baked_box.h ${baked}/baked_crate.h ${baked}/baked_crate_565.h LIBRARIES sheen::host sheen::core m)
target_include_directories(test_bake PRIVATE ${baked})

# The baker without assimp, on other processors, except machines without an operating system: the baker is a program for
# hosts, and rv32imc has another libm.
sheen_script(same_bake cross COMMAND tests/checks/cross tests/cli/same_bake
  gcc-O0 gcc-O2 gcc-O3 clang-O2 tcc sanitizers armhf riscv64 powerpc)

# The viewer: with SDL's driver that needs no screen, in a terminal, in a pseudo-terminal.
sheen_test(test_view unit SOURCES test_view.c LIBRARIES sheen::view)
sheen_test(test_view_keys unit SOURCES test_view_keys.c LIBRARIES sheen::view)
sheen_script(cli_view cli COMMAND tests/cli/view $<TARGET_FILE:sheen>)
