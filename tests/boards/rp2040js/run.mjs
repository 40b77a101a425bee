/*
 * run.mjs - a Raspberry Pi Pico with nothing but a display: runs a UF2, plays keys and records what leaves SPI0.
 *
 *   node run.mjs FIRMWARE.uf2 KEYS OUT [alone]      alone: the second core does not answer
 *
 * It starts as the boot ROM does: checks boot2's checksum, copies boot2 to RAM and jumps to it. Each key is sent over
 * UART0 once the firmware has answered the previous key with a line that begins with "frame" or "first light". In KEYS
 * these do something else:
 *
 *   !   the bus stops answering until the firmware has logged an error; the next key is played meanwhile
 *   #   a HardFault of core 0
 *   @   a HardFault of core 1 while the next frame is drawn
 *   ~   the firmware hangs until the watchdog restarts it
 *   .   the firmware runs by itself until it reports
 *
 * OUT.wire holds what a panel sees (format: tests/boards/glass.c), OUT.json the measurements, OUT.log the serial line.
 */
import fs from 'node:fs';
import process from 'node:process';
import { ConsoleLogger, LogLevel, Simulator } from 'rp2040js';
import { Cores, enterFault } from './cores.mjs';
import { FlashCache } from './flash.mjs';

const FLASH = 0x10000000, RAM = 0x20000000, RAM_BYTES = 264 << 10, BOOT2_AT = 0x20041f00, VECTORS = FLASH + 0x100;
const PIN = { keys: [12, 13, 14, 15], dc: 16, cs: 17, sck: 18, tx: 19, backlight: 20, reset: 21 };
const WATCHDOG_LOAD = 0x04;
const PATIENCE_S = 5; /* emulated seconds */
const RAMWR = 0x2c; /* the command before a rectangle's pixels */
const GAP_US = 5; /* bytes that are closer than this form one run */

function fail(text) {
    process.stderr.write(`rp2040: ${text}\n`);
    process.exit(1);
}

/* The flash image of a UF2 file. */
function image(path) {
    const file = fs.readFileSync(path), flash = Buffer.alloc(2 << 20, 0xff);
    if (file.length === 0 || file.length % 512) fail(`${path}: not whole blocks of 512 bytes`);
    for (let at = 0; at < file.length; at += 512) {
        const word = (i) => file.readUInt32LE(at + 4 * i);
        if (word(0) !== 0x0a324655 || word(1) !== 0x9e5d5157 || file.readUInt32LE(at + 508) !== 0x0ab16f30)
            fail(`${path}: block ${at / 512}: no UF2 block`);
        if (word(7) !== 0xe48bff56 || word(5) !== at / 512 || word(6) !== file.length / 512)
            fail(`${path}: block ${at / 512}: not a whole file for the RP2040`);
        file.copy(flash, word(3) - FLASH, at + 32, at + 32 + word(4));
    }
    return flash;
}

function crc32(bytes) {
    let crc = 0xffffffff;
    for (const byte of bytes) {
        crc ^= byte << 24;
        for (let i = 0; i < 8; i++) crc = crc & 0x80000000 ? (crc << 1) ^ 0x04c11db7 : crc << 1;
    }
    return crc >>> 0;
}

/* What a panel sees: runs of bytes with their D/C level, reset edges, time. */
class Wire {
    constructor(path) {
        this.file = fs.openSync(path, 'w');
        this.run = [];
        this.kind = null;
        this.us = 0;
        this.last = 0;
    }
    write(kind, bytes) {
        const head = Buffer.alloc(5);
        head.write(kind, 0);
        head.writeUInt32LE(bytes.length, 1);
        fs.writeSync(this.file, Buffer.concat([head, Buffer.from(bytes)]));
    }
    flush() {
        if (this.run.length) this.write(this.kind, this.run);
        this.run = [];
    }
    number(kind, value) {
        const bytes = Buffer.alloc(4);
        bytes.writeUInt32LE(value);
        this.flush();
        this.write(kind, bytes);
    }
    time(us) {
        const whole = Math.floor(us) - this.us;
        if (whole > 0) this.number('T', whole);
        this.us += Math.max(whole, 0);
    }
    byte(dc, value, us) {
        const kind = dc ? 'D' : 'C';
        const gap = us - this.last;
        this.last = us;
        if (kind !== this.kind || this.run.length === 0 || gap >= GAP_US) {
            this.flush();
            this.time(us);
            this.kind = kind;
        }
        this.run.push(value);
    }
    event(kind, value, us) {
        this.flush();
        this.time(us);
        this.number(kind, value);
    }
}

class Pico {
    constructor(flash, out, alone) {
        this.flash = flash;
        const { clock, rp2040 } = new Simulator();
        this.clock = clock;
        this.chip = rp2040;
        this.chip.logger = new ConsoleLogger(LogLevel.Error, false);
        this.chip.flash.set(flash);
        this.wire = new Wire(`${out}.wire`);
        this.cache = new FlashCache(rp2040);
        this.profile = new Float64Array((flash.length + RAM_BYTES) / 2); /* flash, then RAM */
        this.ran = (pc, cycles) => {
            if (pc >= RAM && pc < RAM + RAM_BYTES) this.profile[(pc - RAM + flash.length) >> 1] += cycles;
            else if (pc >= FLASH && pc < FLASH + flash.length) this.profile[(pc - FLASH) >> 1] += cycles;
        };
        this.log = '';
        this.cycles = 0;
        this.busyNs = 0;
        this.bytes = 0;
        this.feeds = 0;
        this.rectangles = 0;
        this.stalled = false;
        this.restarts = 0;
        this.cores = new Cores(rp2040, fail);
        this.cores.deaf = alone;
        this.watch();
        this.boot();
        for (const pin of PIN.keys) this.chip.gpio[pin].setInputValue(true); /* not pressed: the pads pull up */
    }

    boot() {
        this.cores.reset();
        const { core } = this.chip, sum = this.flash.readUInt32LE(252);
        if (crc32(this.flash.subarray(0, 252)) !== sum) fail('the boot ROM finds a wrong checksum in boot2');
        this.chip.sram.set(this.flash.subarray(0, 256), BOOT2_AT - 0x20000000);
        core.VTOR = 0;
        core.SP = 0x20042000;
        core.LR = 0;
        core.IPSR = 0;
        core.waiting = false;
        core.PC = BOOT2_AT;
    }

    /* {address: cycles} since `before`, a copy of the profile. */
    profileSince(before) {
        const { profile, flash } = this, spent = {};
        for (let i = 0; i < profile.length; i++)
            if (profile[i] > before[i])
                spent[2 * i < flash.length ? FLASH + 2 * i : RAM + 2 * i - flash.length] = profile[i] - before[i];
        return spent;
    }

    level(pin) {
        return this.chip.gpio[pin].value === 1;
    }

    watch() {
        const { chip, clock } = this, [spi] = chip.spi;
        const done = clock.createAlarm(() => spi.completeTransmit(0));
        spi.onTransmit = (value) => {
            for (const pin of [PIN.sck, PIN.tx])
                if (chip.gpio[pin].functionSelect !== 1) fail(`SPI0 sends while pin ${pin} is not its own`);
            if (!spi.clockFrequency || spi.dataBits !== 8) fail('SPI0 sends without a clock, or not bytes');
            const ns = (spi.dataBits * 1e9) / spi.clockFrequency;
            if (this.stalled) {
                this.stuck = true;
                return;
            }
            if (!this.level(PIN.cs)) {
                this.wire.byte(this.level(PIN.dc), value, clock.nanos / 1000);
                this.bytes++;
                if (value === RAMWR && !this.level(PIN.dc)) this.rectangles++;
            }
            this.busyNs += ns;
            done.schedule(ns);
        };
        chip.gpio[PIN.reset].addListener((state) => {
            if (state < 2) this.wire.event('R', state, clock.nanos / 1000);
        });
        /* D/C and CS must not change while a byte is on the wire. */
        for (const pin of [PIN.dc, PIN.cs])
            chip.gpio[pin].addListener(() => {
                if (spi.busy && !this.stuck) fail(`pin ${pin} moves while a byte is on the wire`);
            });
        chip.uart[0].onByte = (byte) => this.heard(String.fromCharCode(byte));
        const watchdog = chip.peripherals[0x40058], write = watchdog.writeUint32.bind(watchdog);
        watchdog.writeUint32 = (offset, value) => {
            if (offset === WATCHDOG_LOAD) this.feeds++;
            write(offset, value);
        };
        watchdog.onWatchdogTrigger = () => {
            this.restarts++;
            watchdog.enable = watchdog.timer.enable = watchdog.alarm.enable = false;
            this.hung = false;
            this.boot();
        };
    }

    heard(c) {
        if (this.log.endsWith('\n') || this.log === '') this.lineStart = this.cycles;
        if (c !== '\r') this.log += c;
    }

    step() {
        const { core } = this.chip, { PC: pc } = core, still = this.hung || core.waiting;
        const cycles = still ? 1 : core.executeInstruction();
        this.cycles += cycles;
        if (!still) this.ran(pc, cycles);
        if (!this.hung) this.cores.follow(cycles, this.ran);
        this.clock.tick((cycles * 1e9) / this.chip.clkSys);
    }

    /* Runs until the log matches, searched from `from` on. Returns the match. */
    until(pattern, from) {
        let length = -1;
        const end = this.clock.nanos + PATIENCE_S * 1e9;
        for (;;) {
            if (this.log.length !== length) {
                length = this.log.length;
                const found = this.log.endsWith('\n') && this.log.slice(from).match(pattern);
                if (found) return found;
            }
            for (let i = 0; i < 1000; i++) this.step();
            if (this.clock.nanos > end) fail(`no ${pattern} within ${PATIENCE_S} s:\n${this.log}`);
        }
    }

    /* Runs until the key has been read. */
    untilRead() {
        const end = this.clock.nanos + PATIENCE_S * 1e9;
        while (this.chip.uart[0].rxFIFO.itemCount) {
            this.step();
            if (this.clock.nanos > end) fail(`a key is not read within ${PATIENCE_S} s:\n${this.log}`);
        }
    }

    resume() {
        this.stalled = false;
        if (this.stuck) this.chip.spi[0].completeTransmit(0);
        this.stuck = false;
    }
}

const [firmware, keys, out, alone] = process.argv.slice(2);
if (!out) fail('usage: node run.mjs FIRMWARE.uf2 KEYS OUT [alone]');
const pico = new Pico(image(firmware), out, alone !== undefined), frames = [];
pico.until(/arena .*\n/, 0);
if (pico.chip.clkSys !== 125e6 || pico.chip.clkPeri !== 125e6) fail(`clocks at ${pico.chip.clkSys}, ${pico.chip.clkPeri} Hz`);
for (const key of keys) {
    const from = pico.log.length;
    if (key === '!') {
        pico.stalled = true;
        continue;
    }
    if (key === '.') {
        pico.until(/^\w+, light .*\n/m, from);
        continue;
    }
    if (key === '#' || key === '~') {
        if (key === '#') enterFault(pico.chip.core);
        else pico.hung = true;
        pico.until(/arena .*\n/, from);
        continue;
    }
    if (key === '@') {
        pico.cores.faulty = true;
        pico.chip.uart[0].feedByte('n'.charCodeAt(0));
        pico.until(/arena .*\n/, from);
        continue;
    }
    const before = { ...pico, profile: pico.profile.slice(), misses: pico.cache.misses };
    pico.chip.uart[0].feedByte(key.charCodeAt(0));
    if (key === 'h') {
        pico.untilRead();
        continue;
    }
    if (pico.stalled) {
        pico.until(/\(-\d+\)\n/, from);
        pico.resume();
    }
    const [line] = pico.until(/^(frame \d+ |first light).*\n/m, from);
    pico.wire.event('F', frames.length, pico.clock.nanos / 1000);
    frames.push({
        key,
        line: line.trim(),
        cycles: pico.lineStart - before.cycles,
        busy: (pico.busyNs - before.busyNs) * 0.125,
        bytes: pico.bytes - before.bytes,
        feeds: pico.feeds - before.feeds,
        rectangles: pico.rectangles - before.rectangles,
        misses: pico.cache.misses - before.misses,
        profile: pico.profileSince(before.profile),
    });
}
pico.wire.flush();
fs.writeFileSync(`${out}.log`, pico.log);
fs.writeFileSync(`${out}.json`, JSON.stringify({ frames, restarts: pico.restarts, spiHz: pico.chip.spi[0].clockFrequency }));
