# A Linux program with a Cortex-M's instructions, run by qemu-user-static; the command line chooses the processor
# (-mcpu). It needs Debian's gcc-arm-none-eabi and newlib.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
# Not in CMAKE_C_FLAGS_INIT, which flags of the command line would replace.
add_compile_options(-mthumb)
add_link_options(-mthumb)
set(CMAKE_EXE_LINKER_FLAGS_INIT "--specs=nosys.specs -nostartfiles ${CMAKE_CURRENT_LIST_DIR}/cortex-m-linux.c")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
