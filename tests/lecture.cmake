# What the lecture says, checked inside the core: with the core's own unrounded colours.
get_target_property(core_sources sheen_core SOURCES)
list(TRANSFORM core_sources PREPEND ${PROJECT_SOURCE_DIR}/core/)
add_library(core_tapped STATIC ${core_sources} test_dither_tap.c)
set_target_properties(core_tapped PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 30)
target_include_directories(core_tapped PUBLIC ${PROJECT_SOURCE_DIR}/core)
target_compile_options(core_tapped PRIVATE -include ${CMAKE_CURRENT_SOURCE_DIR}/test_dither_tap.h)

sheen_test(test_dither accuracy SOURCES test_dither.c LIBRARIES core_picture core_tapped)
sheen_test(test_dither_means accuracy SOURCES test_dither_means.c LIBRARIES core_picture sheen::core)
sheen_test(test_turned accuracy SOURCES test_turned.c LIBRARIES core_picture core_tapped)

# The tapped core must draw what the core draws.
add_executable(frame_sum_tapped frame_sum.c frame_sum_mesh.c)
target_link_libraries(frame_sum_tapped PRIVATE core_tapped m)
sheen_script(frame_sums_tapped accuracy COMMAND tests/golden/compare frame_sums.txt $<TARGET_FILE:frame_sum_tapped>)

# The command: its figures, their numbers, bad folders.
sheen_script(cli_lecture ${many} COMMAND tests/cli/lecture $<TARGET_FILE:sheen> .)

# What a page refuses because it does not fit.
find_package(PkgConfig REQUIRED)
pkg_check_modules(cairo REQUIRED IMPORTED_TARGET cairo fontconfig)
set(lecture_folder ${PROJECT_SOURCE_DIR}/host-sim/lecture)
sheen_test(test_lecture_page unit
  SOURCES test_lecture_page.c ${lecture_folder}/lecture_page.c ${lecture_folder}/lecture_plot.c
    ${lecture_folder}/lecture_text.c
  LIBRARIES sheen::host sheen::core PkgConfig::cairo m)
target_include_directories(test_lecture_page PRIVATE ${lecture_folder})
