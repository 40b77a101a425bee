# Cortex-M0+ with Debian's gcc-arm-none-eabi: cmake --toolchain tests/toolchains/cortex-m0plus.cmake
set(SHEEN_CPU cortex-m0plus)
include(${CMAKE_CURRENT_LIST_DIR}/arm-none-eabi.cmake)
