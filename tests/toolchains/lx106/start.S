/* From reset into support.c, with the stack at the end of RAM; and QEMU's call for what a program asks its host. */
        .section .reset, "ax"
        .align 4
        .global start
start:  j begin
        .align 4
top:    .word 0x3ffffff0
main_:  .word support_main
begin:  l32r a1, top
        l32r a0, main_
        callx0 a0

        .text
        .align 4
        .global simcall
simcall:
        simcall
        ret
