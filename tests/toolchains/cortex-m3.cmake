# Cortex-M3 with Debian's gcc-arm-none-eabi: cmake --toolchain tests/toolchains/cortex-m3.cmake
set(SHEEN_CPU cortex-m3)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
