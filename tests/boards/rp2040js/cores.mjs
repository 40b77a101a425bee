/*
 * cores.mjs - the RP2040's second core, which rp2040js does not have. It runs beside the first; both have FIFOs, events
 * and their own CPU number (data sheet, 2.3.1 and 2.8.2). Any use of the second core that the firmware does not need is
 * refused.
 */
const CPUID = 0x00, FIFO_ST = 0x50, FIFO_WR = 0x54, FIFO_RD = 0x58, OWN_FROM = 0x60, OWN_TO = 0x100;
const FRCE_OFF = 0x04, PROC1 = 1 << 16, PPB_FROM = 0xe000e000, FIFO_DEPTH = 8;
const LAUNCH = [0, 0, 1]; /* then VTOR, stack, entry point */

/* Enters the handler as hardware would on a fault; the emulator has no faults. */
export function enterFault(core) {
    core.exceptionEntry(3);
    core.PC &= ~1;
}

export class Cores {
    constructor(chip, fail) {
        const { sio } = chip, read = sio.readUint32.bind(sio), write = sio.writeUint32.bind(sio);
        const psm = chip.peripherals[0x40010], power = psm.writeUint32.bind(psm);
        this.chip = chip;
        this.fail = fail;
        this.running = 0; /* the core that is executing */
        this.deaf = this.faulty = false; /* core 1 never answers; core 1 faults at its next instruction */
        this.reset();
        sio.readUint32 = (offset) => {
            if (offset === CPUID) return this.running;
            if (offset === FIFO_ST) return this.status();
            if (offset === FIFO_RD) return this.fifos[this.running].shift() ?? 0;
            return this.own(offset) ?? read(offset);
        };
        sio.writeUint32 = (offset, value) => {
            if (offset === FIFO_WR) this.send(value >>> 0);
            else this.own(offset) ?? write(offset, value);
        };
        psm.writeUint32 = (offset, value) => {
            const before = psm.readUint32(FRCE_OFF);
            power(offset, value);
            if (offset === FRCE_OFF && (before & ~value & PROC1) !== 0) this.boot();
            if (offset !== FRCE_OFF || (value & PROC1) === 0) return;
            this.off();
            sio.spinLock |= 1; /* as if core 1 had just acquired it: the worst case */
        };
        const info = chip.logger.info.bind(chip.logger);
        chip.logger.info = (name, text) => (text === 'SEV' ? this.wake() : info(name, text));
    }

    /* Dividers and interpolators: rp2040js has only one set, so core 1 must not use them. */
    own(offset) {
        if (this.running === 1 && offset >= OWN_FROM && offset < OWN_TO)
            this.fail(`core 1 reads or writes 0xd0000${offset.toString(16).padStart(3, '0')}`);
    }

    status() {
        const { fifos, running } = this;
        return (fifos[running].length > 0 ? 1 : 0) | (fifos[1 - running].length < FIFO_DEPTH ? 2 : 0);
    }

    send(word) {
        const to = this.fifos[1 - this.running];
        if (to.length >= FIFO_DEPTH) this.fail('a word for a FIFO that is full');
        to.push(word);
        if (this.running === 0 && this.waits) this.launch();
    }

    wake() {
        const other = this.running === 0 ? this.core : this.chip.core;
        if (other === null) return;
        other.eventRegistered = !other.waiting;
        other.waiting = false;
    }

    /* Resets both cores. A word stays in core 0's FIFO, as if a debugger had restarted core 0 alone. */
    reset() {
        this.fifos = [[1], []]; /* what core 0 and core 1 can read */
        this.off();
    }

    off() {
        this.core = null;
        this.waits = false;
        this.heard = [];
    }

    /* Core 1 starts in the boot ROM. */
    boot() {
        this.off();
        if (this.deaf) return;
        this.waits = true;
        this.fifos[1].length = 0;
        this.fifos[0].push(0);
    }

    /* Does what the boot ROM does with a word: it answers with the same word, and starts the core after the sixth. */
    launch() {
        const word = this.fifos[1].shift(), at = this.heard.length;
        this.heard = at < LAUNCH.length && word !== LAUNCH[at] ? [] : [...this.heard, word];
        this.fifos[0].push(word);
        if (this.heard.length < 6) return;
        const [, , , vtor, stack, entry] = this.heard;
        if ((entry & 1) === 0 || stack % 8 !== 0) this.fail(`core 1 starts at ${entry.toString(16)}, stack ${stack.toString(16)}`);
        this.waits = false;
        this.core = new this.chip.core.constructor(this.chip);
        this.core.VTOR = vtor;
        this.core.SP = stack;
        this.core.PC = entry & ~1;
        for (const size of [8, 16, 32]) {
            const read = this.core[`readUint${size}`].bind(this.core);
            this.core[`readUint${size}`] = (at) => (at >= PPB_FROM ? this.fail('core 1 reads its private bus') : read(at));
        }
        this.behind = 0;
    }

    /*
     * Runs core 1 until it has caught up with core 0, which has gone on by `cycles`. ran(pc, cycles) is called for each
     * of its instructions.
     */
    follow(cycles, ran) {
        if (this.core === null) return;
        this.behind += cycles;
        this.running = 1;
        while (this.core !== null && this.behind > 0) {
            if (this.core.waiting) {
                this.behind = 0;
                break;
            }
            if (this.faulty) {
                this.faulty = false;
                enterFault(this.core);
            }
            const { PC: pc } = this.core, took = this.core.executeInstruction();
            this.behind -= took;
            ran(pc, took);
        }
        this.running = 0;
    }
}
