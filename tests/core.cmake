# Each stage of the core alone, against double precision or exact integers.
set(stages fixed newton vectors arcs averages edges pose transform light ramp colour fog weights bin flight garbage errors)
foreach(name IN LISTS stages)
  sheen_test(test_core_${name} unit SOURCES test_core_${name}.c LIBRARIES core_picture sheen::core)
endforeach()

sheen_test(test_core_polygons unit SOURCES test_core_polygons.c simple_polygon.c LIBRARIES core_picture sheen::core)
sheen_test(test_core_angles unit SOURCES test_core_angles.c simple_polygon.c LIBRARIES core_picture sheen::core)

# Set-up of triangles that were never drawn.
sheen_test(test_core_gradient unit SOURCES test_core_gradient.c core_raster.c LIBRARIES core_picture sheen::core)
sheen_test(test_core_rooms unit SOURCES test_core_rooms.c core_raster.c LIBRARIES core_picture sheen::core)
sheen_test(test_core_slivers unit SOURCES test_core_slivers.c LIBRARIES core_picture sheen::core)
sheen_test(test_core_facing unit SOURCES test_core_facing.c LIBRARIES core_picture sheen::core)
sheen_test(test_core_clip unit SOURCES test_core_clip.c exact_cover.c LIBRARIES core_picture sheen::core)

# Tests every argument instead of every 4099th.
if(NOT SHEEN_SANITIZED)
  sheen_script(test_core_newton_all long COMMAND $<TARGET_FILE:test_core_newton> all)
endif()

# The tables are data, and the script is their definition. No compiled program runs, so sanitizers make no difference.
if(NOT SHEEN_SANITIZED)
  sheen_script(core_tables unit COMMAND python3 tests/tools/make_tables.py --check core/math/tables.c)
  sheen_script(core_matcaps unit COMMAND python3 tests/tools/make_matcaps.py --check core/pixel)
endif()

# 2D drawing under and over the triangles.
sheen_test(test_canvas unit SOURCES test_canvas.c memory_target.c LIBRARIES sheen::core)
