/*
 * host.js - the WebAssembly module's operating system: gives it a few files and collects what it prints. For the page,
 * its worker and the tests alike.
 */
'use strict';

/*
 * Makes an instance of the compiled module. files: a Map of names to bytes, which may change later. The instance has
 * the module's exports `x`; `output`, all bytes that went to standard output, and `errors`, the text of standard error,
 * which the caller empties.
 */
async function sheenHost(code, files) {
    const OK = 0, BAD = 8, MISSING = 44, NO_SEEK = 70; // WASI's errno
    const FOLDER = 3, DIRECTORY = 3, FILE = 4, DEVICE = 2;
    const host = { files, output: [], errors: '', opened: new Map() };
    const memory = () => host.x.memory.buffer;
    const view = () => new DataView(memory());
    const bytes = (at, count) => new Uint8Array(memory(), at, count);
    const decode = (at, count) => new TextDecoder().decode(bytes(at, count));
    const find = (at, count) => host.files.get(decode(at, count).replace(/^(\.?\/)+/, ''));

    function stat(at, type, size) {
        bytes(at, 64).fill(0);
        view().setUint8(at + 16, type);
        view().setBigUint64(at + 32, BigInt(size), true);
        return OK;
    }
    // Calls act(address, count) for the parts of a list; the sum of what it returns goes to `out`.
    function each(list, count, out, act) {
        let sum = 0;
        for (let i = 0; i < count; i++)
            sum += act(view().getUint32(list + 8 * i, true), view().getUint32(list + 8 * i + 4, true));
        view().setUint32(out, sum, true);
        return OK;
    }
    const wasi = {
        fd_prestat_get: (fd, at) => {
            if (fd !== FOLDER)
                return BAD;
            view().setUint32(at, 0, true);
            view().setUint32(at + 4, 1, true);
            return OK;
        },
        fd_prestat_dir_name: (fd, at) => {
            bytes(at, 1)[0] = 47; // '/'
            return OK;
        },
        fd_fdstat_get: (fd, at) => {
            bytes(at, 24).fill(0);
            view().setUint8(at, fd < FOLDER ? DEVICE : fd === FOLDER ? DIRECTORY : FILE);
            bytes(at + 8, 16).fill(255); // rights
            return fd <= FOLDER || host.opened.has(fd) ? OK : BAD;
        },
        fd_filestat_get: (fd, at) => host.opened.has(fd) ? stat(at, FILE, host.opened.get(fd).bytes.length) : BAD,
        path_filestat_get: (fd, flags, path, count, at) => {
            const file = find(path, count);
            return file ? stat(at, FILE, file.length) : MISSING;
        },
        path_open: (folder, flags, path, count, how, rights, inherited, modes, at) => {
            const file = find(path, count);
            let fd = FOLDER + 1;
            if (!file)
                return MISSING;
            while (host.opened.has(fd))
                fd++;
            host.opened.set(fd, { bytes: file, at: 0 });
            view().setUint32(at, fd, true);
            return OK;
        },
        fd_close: fd => host.opened.delete(fd) ? OK : BAD,
        fd_read: (fd, list, count, out) => {
            const file = host.opened.get(fd);
            return !file ? BAD : each(list, count, out, (at, room) => {
                const part = file.bytes.subarray(file.at, file.at + room);
                bytes(at, room).set(part);
                file.at += part.length;
                return part.length;
            });
        },
        fd_write: (fd, list, count, out) => each(list, count, out, (at, size) => {
            if (fd === 1)
                host.output.push(bytes(at, size).slice());
            else
                host.errors += decode(at, size);
            return size;
        }),
        fd_seek: () => NO_SEEK,
        proc_exit: status => { throw new SheenEnd(status); },
    };
    host.x = (await WebAssembly.instantiate(code, { wasi_snapshot_preview1: wasi })).exports;
    host.x._initialize();

    // text: the string at an address, null at 0. words: writes a list of words into the module; returns their number.
    host.text = at => {
        const all = new Uint8Array(memory());
        return at ? new TextDecoder().decode(all.subarray(at, all.indexOf(0, at))) : null;
    };
    host.words = list => {
        const encoded = new TextEncoder().encode(list.join('\0') + '\0');
        bytes(host.x.web_words(encoded.length), encoded.length).set(encoded);
        return list.length;
    };
    host.bytes = (at, count) => new Uint8ClampedArray(memory(), at, count);
    return host;
}

/* What the module's exit() throws. */
function SheenEnd(status) {
    this.status = status;
}

/*
 * Reads a mesh file, and the pictures that it shows, as the words of a command line ask, in an instance of its own, so
 * that whatever happens there is no harm to another. Returns the answer, which the instance that draws has to find
 * under the mesh's name. Throws if there is none.
 */
async function sheenRead(code, files, name, words) {
    const host = await sheenHost(code, files);
    const path = new TextEncoder().encode(name);
    new Uint8Array(host.x.memory.buffer, host.x.web_path(path.length), path.length).set(path);
    try {
        host.x.web_read(host.words(words));
    } catch (end) {
        if (!(end instanceof SheenEnd))
            throw end;
    }
    const answer = new Uint8Array(host.output.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of host.output) {
        answer.set(part, at);
        at += part.length;
    }
    return answer;
}
