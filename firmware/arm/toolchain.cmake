# What the boards' toolchain files share; SHEEN_CPU names the processor.
# Debian's gcc-arm-none-eabi, with newlib's small variant or else picolibc: of
# the C library the firmware needs memcpy and memset.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "-mcpu=${SHEEN_CPU} -mthumb -ffunction-sections -fdata-sections")
execute_process(COMMAND arm-none-eabi-gcc -print-file-name=nano.specs
  OUTPUT_VARIABLE specs OUTPUT_STRIP_TRAILING_WHITESPACE)
if(specs STREQUAL "nano.specs") # not found: its name comes back as it was
  set(specs picolibc.specs)
endif()
string(APPEND CMAKE_C_FLAGS_INIT " --specs=${specs}")
set(CMAKE_ASM_FLAGS_INIT "-mcpu=${SHEEN_CPU} -mthumb")
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
# Start-up code is a board's: CMake tries the compiler on a library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
