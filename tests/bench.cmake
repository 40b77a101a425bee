# The measured scenes (bench/scenes.h), as C data that boards can use.
add_executable(bench_export bench/export.c)
target_link_libraries(bench_export PRIVATE sheen::core m)
set(bench_data ${CMAKE_CURRENT_BINARY_DIR}/bench_data.c)
add_custom_command(OUTPUT ${bench_data} COMMAND bench_export > ${bench_data} DEPENDS bench_export VERBATIM)
add_library(bench_scenes STATIC bench/scenes.c ${bench_data})
target_include_directories(bench_scenes PUBLIC ${CMAKE_CURRENT_SOURCE_DIR}/bench)
target_link_libraries(bench_scenes PUBLIC sheen::core)

add_executable(bench_host bench/host.c)
target_link_libraries(bench_host PRIVATE bench_scenes)
sheen_script(bench bench COMMAND tests/bench/report --build ${CMAKE_BINARY_DIR})
set_tests_properties(bench PROPERTIES FIXTURES_REQUIRED boards)
sheen_script(bench_profile bench COMMAND tests/bench/profile --build ${CMAKE_BINARY_DIR} M3 S1 gouraud)
sheen_script(bench_hot bench COMMAND tests/bench/hot --build ${CMAKE_BINARY_DIR})
sheen_script(bench_short freestanding COMMAND tests/bench/report --build ${CMAKE_BINARY_DIR} M3 M0+)

# What `sheen plan` predicts, against emulated processors: arenas must be the same, flash and times nearly.
add_executable(planned_export bench/planned_export.c bench/planned_bench.c)
target_link_libraries(planned_export PRIVATE sheen::view)
target_include_directories(planned_export PRIVATE bench)
target_sources(planned_export PRIVATE bench/scenes.c ${bench_data})
sheen_script(bench_costs bench COMMAND tests/bench/costs --build ${CMAKE_BINARY_DIR} TIMEOUT 7200)
set_tests_properties(bench_costs PROPERTIES FIXTURES_REQUIRED boards)
