# The Linux board: the pin watcher, and what of hal/linux and sheen-panel needs no GPIO.
sheen_test(test_pin_watcher sim SOURCES test_pin_watcher.c LIBRARIES sheen::sim)
sheen_test(test_panel_off panel SOURCES test_panel_off.c LIBRARIES sheen::sim)

# A stock Debian kernel in an emulator (tests/kernel/common.sh). 
add_executable(kernel_replay kernel/replay.c)
target_link_libraries(kernel_replay PRIVATE sheen::sim sheen::host)
sheen_script(kernel kernel COMMAND tests/kernel/run ${PROJECT_BINARY_DIR} TIMEOUT 300)
