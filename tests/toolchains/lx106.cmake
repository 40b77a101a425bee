# The processor of an ESP8266: Debian's gcc-xtensa-lx106, which comes without a C library; run by QEMU's machine `sim`.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR xtensa)
set(CMAKE_C_COMPILER xtensa-lx106-elf-gcc)
set(lx106 ${CMAKE_CURRENT_LIST_DIR}/lx106)
# Not in CMAKE_C_FLAGS_INIT, which flags of the command line would replace.
add_compile_options(-ffreestanding -mlongcalls -mtext-section-literals -I${lx106}/include)
add_link_options(-ffreestanding -mlongcalls -mtext-section-literals -I${lx106}/include)
set(CMAKE_EXE_LINKER_FLAGS_INIT "-nostdlib -T${lx106}/link.ld ${lx106}/start.S ${lx106}/support.c")
set(CMAKE_C_STANDARD_LIBRARIES_INIT -lgcc)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
