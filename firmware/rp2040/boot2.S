/*
 * boot2.S - the second boot stage: switches the flash chip to fast reads, then starts the program.
 *
 * The boot ROM copies these 256 bytes to RAM, verifies the checksum in the last
 * four and jumps to the first (data sheet, 2.8.1.3). Until then flash is read
 * slowly, over one wire. This code sets the SSI (4.10) to quad reads without the
 * command byte ("continuous read"), which the Pico's W25Q16JV and similar chips
 * support.
 */
    .syntax unified
    .cpu cortex-m0plus
    .thumb

    .equ PADS_QSPI, 0x40020000
    .equ SCLK, 0x04
    .equ SD0, 0x08
    .equ XIP_SSI, 0x18000000
    .equ CTRLR0, 0x00
    .equ CTRLR1, 0x04
    .equ SSIENR, 0x08
    .equ BAUDR, 0x14
    .equ SR, 0x28
    .equ DR0, 0x60
    .equ RX_SAMPLE_DLY, 0xF0   /* too far for the offset of str, like SPI_CTRLR0 */
    .equ SPI_CTRLR0, 0xF4
    .equ VTOR, 0xE000ED08
    .equ VECTORS, 0x10000100

    .equ FRAME_BYTES, 7 << 16                       /* 8 bits, one wire, both directions */
    .equ FRAME_QUAD_READ, 2 << 21 | 31 << 16 | 3 << 8 /* 32 bits, four wires, read after address */
    .equ FIRST_READ, 4 << 11 | 2 << 8 | 8 << 2 | 1  /* 4 wait cycles, 8-bit command on 1 wire, address and mode on 4 */
    .equ NEXT_READS, 0xA0 << 24 | 4 << 11 | 8 << 2 | 2 /* no command: mode bits A0 announce the next address */
    .equ QUAD_ENABLE, 2                             /* in the flash's status register 2 */

    .section .boot2, "ax"
    .global boot2
boot2:
    ldr r0, =PADS_QSPI
    movs r1, #0x21             /* clock: 8 mA, fast slew */
    str r1, [r0, #SCLK]
    ldr r1, [r0, #SD0]
    movs r2, #2
    bics r1, r2                /* data: no Schmitt trigger, because it adds a delay */
    str r1, [r0, #SD0]
    str r1, [r0, #SD0 + 4]
    str r1, [r0, #SD0 + 8]
    str r1, [r0, #SD0 + 12]

    ldr r4, =XIP_SSI
    movs r5, #0
    movs r6, #1
    str r5, [r4, #SSIENR]
    movs r1, #2                /* system clock / 2 */
    str r1, [r4, #BAUDR]
    movs r2, #RX_SAMPLE_DLY
    str r6, [r4, r2]           /* sample one clock later */

    /* Let the flash use four wires: set bit QE of status register 2. */
    ldr r1, =FRAME_BYTES
    str r1, [r4, #CTRLR0]
    str r6, [r4, #SSIENR]
    movs r0, #0x35             /* read status register 2 */
    bl read_status
    cmp r0, #QUAD_ENABLE
    beq 2f
    movs r0, #0x06             /* write enable */
    bl exchange
    movs r0, #0x01             /* write status registers 1 and 2 */
    str r0, [r4, #DR0]
    str r5, [r4, #DR0]
    movs r0, #QUAD_ENABLE
    bl exchange
    ldr r0, [r4, #DR0]
    ldr r0, [r4, #DR0]
1:  movs r0, #0x05             /* read status register 1 until the flash is not busy */
    bl read_status
    tst r0, r6
    bne 1b
2:  str r5, [r4, #SSIENR]

    /* Read address 0 once with the command; all later reads leave it out. */
    ldr r1, =FRAME_QUAD_READ
    str r1, [r4, #CTRLR0]
    str r5, [r4, #CTRLR1]
    ldr r1, =FIRST_READ
    movs r2, #SPI_CTRLR0
    str r1, [r4, r2]
    str r6, [r4, #SSIENR]
    movs r0, #0xEB             /* fast read, quad */
    str r0, [r4, #DR0]
    movs r0, #0xA0             /* address 0, mode A0 */
    str r0, [r4, #DR0]
    bl ready
    str r5, [r4, #SSIENR]
    ldr r1, =NEXT_READS
    movs r2, #SPI_CTRLR0
    str r1, [r4, r2]
    str r6, [r4, #SSIENR]

    ldr r0, =VECTORS
    ldr r1, =VTOR
    str r0, [r1]
    ldmia r0, {r0, r1}
    msr msp, r0
    bx r1

/* Waits until all is sent: SR's bit 2 (transmit FIFO empty) set, bit 0 (busy) clear. Uses r2, r3. */
ready:
    movs r3, #5
3:  ldr r2, [r4, #SR]
    ands r2, r3
    cmp r2, #4
    bne 3b
    bx lr

/* Sends the byte in r0; r0 = the first byte received. Uses r2, r3, r7. */
exchange:
    mov r7, lr
    str r0, [r4, #DR0]
    bl ready
    ldr r0, [r4, #DR0]
    bx r7

/* Sends the command in r0 and reads one byte into r0. Uses r2, r3, r7. */
read_status:
    mov r7, lr
    str r0, [r4, #DR0]
    str r5, [r4, #DR0]
    bl ready
    ldr r0, [r4, #DR0]
    ldr r0, [r4, #DR0]
    bx r7

    .ltorg

    /* CRC-32 of the 252 bytes before (polynomial 04C11DB7, initial value all ones, not reflected, not inverted). */
    .org boot2 + 252, 0
    .word 0x328cd902
