# A small RISC-V: Debian's gcc-riscv64-unknown-elf and picolibc, printing by semihosting; run by QEMU's machine `virt`.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR riscv32)
set(CMAKE_C_COMPILER riscv64-unknown-elf-gcc)
# Not in CMAKE_C_FLAGS_INIT, which flags of the command line would replace.
add_compile_options(-march=rv32imc -mabi=ilp32 --specs=picolibc.specs)
add_link_options(-march=rv32imc -mabi=ilp32 --specs=picolibc.specs)
set(CMAKE_EXE_LINKER_FLAGS_INIT "--crt0=semihost --oslib=semihost -Wl,--defsym=__flash=0x80000000 \
-Wl,--defsym=__flash_size=4M -Wl,--defsym=__ram=0x80400000 -Wl,--defsym=__ram_size=4M")
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
