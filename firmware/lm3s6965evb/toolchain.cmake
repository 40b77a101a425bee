# The LM3S6965's Cortex-M3.
set(SHEEN_CPU cortex-m3)
include(${CMAKE_CURRENT_LIST_DIR}/../arm/toolchain.cmake)
