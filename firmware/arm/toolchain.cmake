# What the boards' toolchain files share; SHEEN_CPU names the processor.
# Debian's gcc-arm-none-eabi; of its C library (newlib, or picolibc by -DSHEEN_LIBC=picolibc) memcpy and memset are used.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_ASM_COMPILER arm-none-eabi-gcc)
set(CMAKE_C_FLAGS_INIT "-mcpu=${SHEEN_CPU} -mthumb -ffunction-sections -fdata-sections")
if(SHEEN_LIBC STREQUAL "picolibc")
  string(APPEND CMAKE_C_FLAGS_INIT " --specs=picolibc.specs")
else()
  string(APPEND CMAKE_C_FLAGS_INIT " --specs=nano.specs")
endif()
set(CMAKE_ASM_FLAGS_INIT "-mcpu=${SHEEN_CPU} -mthumb")
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
# Start-up code is a board's: CMake tries the compiler on a library.
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
