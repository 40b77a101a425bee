# The RP2040's Cortex-M0+.
set(SHEEN_CPU cortex-m0plus)
include(${CMAKE_CURRENT_LIST_DIR}/../arm/toolchain.cmake)
