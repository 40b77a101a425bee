/*
 * sketch.mjs - runs a sketch on an RP2040, from a flash image that begins with its vectors, and records what leaves
 * SPI0 until LINES lines have come from UART0.
 *
 *   node sketch.mjs IMAGE.bin DC RESET LINES OUT.wire      DC, RESET: their pins
 *
 * OUT.wire has the format of tests/boards/glass.c. Standard output gets the serial line, and how many reads missed the
 * cache of the flash between its last two lines.
 */
import fs from 'node:fs';
import process from 'node:process';
import { ConsoleLogger, LogLevel, Simulator } from 'rp2040js';
import { FlashCache } from './flash.mjs';

const FLASH = 0x10000000, PATIENCE_S = 30; /* emulated seconds */
const [image, dc, reset, lines, out] = process.argv.slice(2);
const { clock, rp2040: chip } = new Simulator(), [spi] = chip.spi, flash = fs.readFileSync(image);
const cache = new FlashCache(chip), parts = [];
let log = '', us = 0, before = 0, misses = 0;

function record(kind, bytes) {
    const head = Buffer.alloc(5);
    head.write(kind, 0);
    head.writeUInt32LE(bytes.length, 1);
    parts.push(head, Buffer.from(bytes));
}

function number(kind, value) {
    const bytes = Buffer.alloc(4);
    bytes.writeUInt32LE(value);
    record(kind, bytes);
}

/* Records the time since the last byte if it is long enough to matter to the controller. */
function time() {
    const passed = Math.floor(clock.nanos / 1000) - us;
    if (passed < 100) return;
    number('T', passed);
    us += passed;
}

chip.logger = new ConsoleLogger(LogLevel.Error, false);
chip.flash.set(flash);
spi.onTransmit = (value) => {
    time();
    record(chip.gpio[dc].value === 1 ? 'D' : 'C', [value]);
    spi.completeTransmit(0);
};
chip.gpio[reset].addListener((state) => {
    if (state > 1) return;
    time();
    number('R', state);
});
chip.uart[0].onByte = (byte) => {
    log += String.fromCharCode(byte);
    if (!log.endsWith('\n')) return;
    misses = cache.misses - before;
    before = cache.misses;
};
chip.core.VTOR = FLASH;
chip.core.SP = flash.readUInt32LE(0);
chip.core.PC = flash.readUInt32LE(4) & ~1;
while (log.split('\n').length <= Number(lines)) {
    for (let i = 0; i < 1000; i++) clock.tick(chip.core.executeInstruction() * 8);
    if (clock.nanos > PATIENCE_S * 1e9) {
        process.stderr.write(`sketch: ${lines} lines do not come within ${PATIENCE_S} s:\n${log}`);
        process.exit(1);
    }
}
number('F', 0);
fs.writeFileSync(out, Buffer.concat(parts));
process.stdout.write(`${log}${misses} misses\n`);
