/*
 * rp2040.mjs - runs an image for a Cortex-M0+ in rp2040js: answers the calls of cortex.c and counts cycles between
 * them.
 *
 *   node rp2040.mjs IMAGE RP2040JS    IMAGE: the contents of flash, vectors first; RP2040JS: the package's folder
 */
import fs from 'node:fs';
import { createRequire } from 'node:module';
import process from 'node:process';

const FLASH = 0x10000000, SYS_WRITE0 = 4, SYS_EXIT_EXTENDED = 0x20, COUNT = 0x100, COUNTED = 0x101;
const MOST = 60e9; /* cycles after which a program that does not end is stopped */
const [path, library] = process.argv.slice(2);
const { RP2040, ConsoleLogger, LogLevel } = createRequire(import.meta.url)(library);
const chip = new RP2040(), { core } = chip, image = fs.readFileSync(path);
let since = 0, status = null, cycles = 0;

chip.logger = new ConsoleLogger(LogLevel.Error, false);
chip.flash.set(image);
core.VTOR = FLASH;
core.SP = image.readUInt32LE(0);
core.PC = image.readUInt32LE(4) & ~1;
core.LR = 0;
core.IPSR = 0;

/* The text at an address, up to its terminating 0. */
function text(at) {
    let found = '';
    for (let c; (c = chip.readUint8(at)) !== 0; at++) found += String.fromCharCode(c);
    return found;
}

chip.onBreak = () => {
    const [operation, argument] = core.registers;
    if (operation === SYS_WRITE0) process.stdout.write(text(argument));
    else if (operation === SYS_EXIT_EXTENDED) status = chip.readUint32(argument + 4);
    else if (operation === COUNT) since = cycles;
    else if (operation === COUNTED) core.registers[0] = cycles - since;
    else status = 99;
};
while (status === null && cycles < MOST) cycles += core.executeInstruction();
process.exitCode = status ?? 98;
