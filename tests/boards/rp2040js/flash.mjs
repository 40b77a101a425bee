/*
 * flash.mjs - counts the reads of external flash that miss the RP2040's cache, which rp2040js does not have: 16 KB, two
 * ways, lines of 8 bytes (data sheet, 2.6.3). Assumed: of two lines, the one that was used longer ago is replaced.
 */
const FLASH_PAGE = 0x10, LINE_LOG2 = 3, SETS = 1024;

export class FlashCache {
    constructor(chip) {
        this.lines = new Int32Array(2 * SETS).fill(-1);
        this.older = new Uint8Array(SETS); /* which of a set's two ways */
        this.misses = 0;
        for (const name of ['readUint8', 'readUint16', 'readUint32']) {
            const read = chip[name].bind(chip);
            chip[name] = (at) => {
                if (at >>> 24 === FLASH_PAGE) this.touch(at & 0xffffff);
                return read(at);
            };
        }
    }

    touch(at) {
        const line = at >>> LINE_LOG2, set = line % SETS;
        let way = this.lines[2 * set] === line ? 0 : 1;
        if (this.lines[2 * set + way] !== line) {
            way = this.older[set];
            this.lines[2 * set + way] = line;
            this.misses++;
        }
        this.older[set] = 1 - way;
    }
}
