# The firmware of the boards, built and run in emulators.
set(boards ${CMAKE_BINARY_DIR}/boards)

# board_glass tells what the boards' glasses must show.
add_executable(board_glass boards/glass.c ${PROJECT_SOURCE_DIR}/firmware/demo.c)
target_include_directories(board_glass PRIVATE ${PROJECT_SOURCE_DIR}/firmware)
target_link_libraries(board_glass PRIVATE sheen_sim sheen::hal sheen::core)

sheen_script(boards_build boards COMMAND tests/boards/build ${boards})
set_tests_properties(boards_build PROPERTIES FIXTURES_SETUP boards)
sheen_script(boards_minimal boards COMMAND tests/boards/minimal $<TARGET_FILE:sheen>
  ${boards}/rp2040/firmware/minimal/minimal.elf)
sheen_script(boards_lm3s6965evb boards COMMAND tests/boards/lm3s6965evb $<TARGET_FILE:board_glass>
  ${boards}/lm3s6965evb/firmware/lm3s6965evb/lm3s6965evb.elf)
sheen_script(boards_rp2040 boards COMMAND tests/boards/rp2040 $<TARGET_FILE:board_glass> ${boards})
sheen_script(boards_sizes boards COMMAND tests/boards/sizes ${boards})
set_tests_properties(boards_minimal boards_lm3s6965evb boards_rp2040 boards_sizes PROPERTIES FIXTURES_REQUIRED boards)
sheen_script(boards_stranger boards COMMAND tests/boards/stranger/build)
if(NOT SHEEN_SANITIZED)
  sheen_script(boards_page long COMMAND tests/checks/readme firmware/README.md)
endif()
