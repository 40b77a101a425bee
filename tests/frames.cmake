# Whole frames.
foreach(name equal limits locate draws order api stipple bias morph quads far apron)
  sheen_test(test_frame_${name} frames SOURCES test_frame_${name}.c LIBRARIES core_picture sheen::core)
endforeach()
sheen_test(test_frame_changed frames SOURCES test_frame_changed.c frame_show.c LIBRARIES core_picture sheen::core)
sheen_test(test_frame_threads threads SOURCES test_frame_threads.c
  LIBRARIES core_picture sheen::core Threads::Threads)
# Random sequences of calls: a sample here, and 10^6 of them in the long part with the sanitizers.
sheen_test(test_frame_calls frames SOURCES test_frame_calls.c call_player.c call_model.c call_glass.c
  LIBRARIES core_picture sheen::core)
if(SHEEN_SANITIZED)
  sheen_script(test_frame_calls_all long COMMAND $<TARGET_FILE:test_frame_calls> all)
endif()
# Random mixes of everything that can be drawn, with several workers: a sample and a long run, likewise.
sheen_test(test_frame_mixes threads SOURCES test_frame_mixes.c frame_mix.c
  LIBRARIES core_picture sheen::core Threads::Threads)
if(SHEEN_SANITIZED)
  sheen_script(test_frame_mixes_all long COMMAND $<TARGET_FILE:test_frame_mixes> all)
endif()
# 2D that changes under and over objects that move, on panels too, with all that can fail in between; likewise.
sheen_test(test_frame_canvas threads SOURCES test_frame_canvas.c canvas_items.c frame_mix.c
  LIBRARIES core_picture sheen_sim sheen_hal sheen::core Threads::Threads)
if(SHEEN_SANITIZED)
  sheen_script(test_frame_canvas_all long COMMAND $<TARGET_FILE:test_frame_canvas> all)
endif()
sheen_test(test_flythrough frames SOURCES test_flythrough.c loaded_mesh.c
  LIBRARIES core_picture sheen_host sheen::core)
if(NOT SHEEN_SANITIZED) # tests/checks/cross runs it under sanitizers
  sheen_script(frame_sums frames COMMAND tests/golden/compare frame_sums.txt $<TARGET_FILE:frame_sum>)
endif()
sheen_test(test_demo frames SOURCES test_demo.c ${PROJECT_SOURCE_DIR}/firmware/demo.c
  LIBRARIES core_picture sheen::core)
target_include_directories(test_demo PRIVATE ${PROJECT_SOURCE_DIR}/firmware)
# The scenes come from bench.cmake.
sheen_test(test_frame_ram frames SOURCES test_frame_ram.c LIBRARIES bench_scenes)
