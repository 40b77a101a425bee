# The Linux board: the pin watcher, and those parts of hal/linux and sheen-panel that need no GPIO.
sheen_test(test_pin_watcher sim SOURCES test_pin_watcher.c LIBRARIES sheen::sim)
sheen_test(test_i2c_watcher sim SOURCES test_i2c_watcher.c LIBRARIES sheen::sim)
sheen_test(test_panel_off panel SOURCES test_panel_off.c LIBRARIES sheen::sim)
# The buses of hal/linux without libgpiod and without a kernel: the test replaces both (see its head comment).
set(linux ${PROJECT_SOURCE_DIR}/hal/linux)
sheen_test(test_linux_bus panel SOURCES test_linux_bus.c test_panel_canvas.c ${linux}/failure.c ${linux}/linux_bus.c
  ${linux}/bus_bitbang.c ${linux}/bus_i2cdev.c ${linux}/bus_spidev.c ${linux}/sender.c LIBRARIES sheen::sim Threads::Threads)
target_include_directories(test_linux_bus PRIVATE ${linux})
target_compile_definitions(test_linux_bus PRIVATE _GNU_SOURCE)
target_link_options(test_linux_bus PRIVATE -Wl,--wrap=open,--wrap=close,--wrap=ioctl,--wrap=clock_nanosleep)
set(program ${PROJECT_SOURCE_DIR}/firmware/linux)
sheen_test(test_linux_options cli SOURCES test_linux_options.c ${program}/options.c ${program}/options_file.c
  ${program}/options_module.c ${program}/options_table.c ${program}/stop.c ${linux}/failure.c
  LIBRARIES sheen::view)
target_include_directories(test_linux_options PRIVATE ${linux} ${PROJECT_SOURCE_DIR}/host-sim/command)
target_compile_definitions(test_linux_options PRIVATE _GNU_SOURCE)
if(TARGET sheen_linux)
  sheen_test(test_sender threads SOURCES test_sender.c LIBRARIES sheen::linux)
endif()

# A stock Debian kernel in an emulator (tests/kernel/common.sh). These tests all build in BUILD/kernel, so they run one
# at a time.
add_executable(kernel_replay kernel/replay.c)
target_link_libraries(kernel_replay PRIVATE sheen::sim sheen::host)
sheen_script(kernel kernel COMMAND tests/kernel/run ${PROJECT_BINARY_DIR})
sheen_script(linux_builds kernel COMMAND tests/kernel/builds ${PROJECT_BINARY_DIR})
if(NOT SHEEN_SANITIZED)
  sheen_script(linux_page long COMMAND tests/checks/readme firmware/linux/README.md)
endif()
sheen_script(faults_linux faults-linux COMMAND tests/kernel/faults ${PROJECT_BINARY_DIR})
sheen_script(linux_options faults-linux COMMAND tests/kernel/options ${PROJECT_BINARY_DIR}/firmware/linux/sheen-panel)
if(NOT SHEEN_SANITIZED)
  sheen_script(faults_linux_every long COMMAND tests/kernel/faults ${PROJECT_BINARY_DIR} every)
  set(every faults_linux_every)
endif()
set_tests_properties(kernel linux_builds faults_linux ${every} PROPERTIES RESOURCE_LOCK guest)
