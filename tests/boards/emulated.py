"""What the board tests share: reading and comparing pictures, and a machine in QEMU."""
import array
import json
import os
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zlib

PATIENCE = 20  # s to wait for an answer of the firmware


class Failed(Exception):
    pass


def main(test):
    """Runs test(arguments); if it raises Failed, prints one line and exits with status 1."""
    try:
        test(sys.argv[1:])
    except Failed as failed:
        sys.exit(f"{os.path.basename(sys.argv[0])}: {failed}")


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise Failed(f"{' '.join(command)}: {done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


# ---- pictures: width x height values of 16 bits ----

def read_pictures(path, pixels):
    values = array.array("H")
    with open(path, "rb") as f:
        values.frombytes(f.read())
    if sys.byteorder == "big":
        values.byteswap()
    if not values or len(values) % pixels:
        raise Failed(f"{path}: {len(values)} values are not whole pictures of {pixels}")
    return [values[i:i + pixels] for i in range(0, len(values), pixels)]


def read_png(path):
    """The levels of a 128 x 64 picture with 8 bits and RGB, as png_file.c writes it."""
    with open(path, "rb") as f:
        data = f.read()
    width, height, depth, colour = struct.unpack(">IIBB", data[16:26])
    if (width, height, depth, colour) != (128, 64, 8, 2):
        raise Failed(f"{path}: {width} x {height}, depth {depth}, colour {colour}")
    packed, at = b"", 8
    while at < len(data):
        (length,) = struct.unpack(">I", data[at:at + 4])
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += length + 12
    return unfilter(zlib.decompress(packed), 3 * width, height)


def unfilter(raw, row_bytes, height):
    """Undoes PNG's row filters (PNG specification, chapter 9); returns the levels 0..15 of the red bytes."""
    above, levels = bytearray(row_bytes), array.array("H")
    for y in range(height):
        kind, row = raw[y * (row_bytes + 1)], bytearray(raw[y * (row_bytes + 1) + 1:(y + 1) * (row_bytes + 1)])
        for i in range(row_bytes):
            left, up, corner = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
            near = min((abs(up - corner), 0, left), (abs(left - corner), 1, up),
                       (abs(left + up - 2 * corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, near)[kind]) & 255
        levels.extend((value * 15 + 127) // 255 for value in row[::3])
        above = row
    return levels


def different(got, want):
    """How many pixels differ."""
    if len(got) != len(want):
        raise Failed(f"{len(got)} pixels instead of {len(want)}")
    return sum(a != b for a, b in zip(got, want))


def demo_pictures(glass, panel, keys, pixels):
    """What the simulator shows for these keys."""
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "pictures")
        run(glass, "demo", panel, keys, out)
        return read_pictures(out, pixels)


def compare(keys, got, want):
    """Compares the pictures, one for each key, and prints how many pixels differ; raises Failed if any do."""
    if len(got) != len(want):
        raise Failed(f"{len(got)} pictures instead of {len(want)}")
    counts = [different(a, b) for a, b in zip(got, want)]
    blank = [i for i, picture in enumerate(got) if len(set(picture)) < 3]
    print(f"{len(got)} pictures, keys {keys}: {sum(counts)} different pixels")
    if any(counts):
        raise Failed(f"pixels that differ from the simulator's, picture by picture: {counts}")
    if blank:
        raise Failed(f"pictures {blank} show next to nothing")


def corner(picture, width, x0, y0, columns, rows, dark=0):
    """A part of a picture as text, with # for each lit pixel."""
    return ["".join(".#"[picture[(y0 + y) * width + x0 + x] != dark] for x in range(columns)) for y in range(rows)]


# ---- QEMU ----

class Machine:
    """QEMU's lm3s6965evb: its serial line, its screen (by QMP), its memory and registers (by gdb's protocol)."""

    def __init__(self, firmware):
        self.folder = tempfile.TemporaryDirectory()
        qmp, gdb = (os.path.join(self.folder.name, name) for name in ("qmp", "gdb"))
        self.process = subprocess.Popen(
            ["qemu-system-arm", "-M", "lm3s6965evb", "-kernel", firmware, "-display", "none", "-monitor", "none",
             "-serial", "stdio", "-qmp", f"unix:{qmp},server=on,wait=off",
             "-chardev", f"socket,id=gdb,path={gdb},server=on,wait=off", "-gdb", "chardev:gdb"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.log = ""
        self.seen = 0
        self.qmp_stream = self._connect(qmp).makefile("rw")
        self.qmp_stream.readline()
        self.qmp("qmp_capabilities")
        self.gdb_path = gdb

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        for stream in (self.process.stdin, self.process.stdout, self.process.stderr):
            stream.close()
        self.folder.cleanup()

    def _connect(self, path):
        end = time.monotonic() + PATIENCE
        while True:
            try:
                sock = socket.socket(socket.AF_UNIX)
                sock.connect(path)
                return sock
            except OSError:
                if self.process.poll() is not None or time.monotonic() > end:
                    raise Failed(f"QEMU does not start: {self.process.stderr.read().decode()}")
                time.sleep(0.05)

    def qmp(self, command, **arguments):
        self.qmp_stream.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self.qmp_stream.flush()
        while line := self.qmp_stream.readline():
            answer = json.loads(line)
            if "error" in answer:
                raise Failed(f"QMP {command}: {answer['error']['desc']}")
            if "return" in answer:
                return answer["return"]
        raise Failed(f"QEMU ended during {command}")

    def key(self, c):
        self.process.stdin.write(c.encode())
        self.process.stdin.flush()

    def expect(self, text):
        """Waits until the log after the last expected line contains text; returns the rest of that line."""
        end = time.monotonic() + PATIENCE
        while True:
            chunk = self.process.stdout.read()
            self.log += chunk.decode(errors="replace").replace("\r", "") if chunk else ""
            at = self.log.find(text, self.seen)
            newline = self.log.find("\n", at) if at >= 0 else -1
            if newline >= 0:
                self.seen = newline
                return self.log[at + len(text):newline]
            if time.monotonic() > end or self.process.poll() is not None:
                raise Failed(f"'{text}' was not logged; the log since: {self.log[self.seen:][-600:]!r}")
            time.sleep(0.01)

    def screen(self):
        """The OLED's 128 x 64 grey levels. QEMU shows a pixel as 4 x 4, level n as n / 15 of white."""
        path = os.path.join(self.folder.name, "screen.ppm")
        self.qmp("screendump", filename=path)
        with open(path, "rb") as f:
            head, size, depth, data = f.read().split(b"\n", 3)
        if (head, size, depth) != (b"P6", b"512 256", b"255"):
            raise Failed(f"a screen dump that begins {head} {size} {depth}")
        picture = array.array("H")
        for y in range(64):
            for x in range(128):
                at = ((4 * y) * 512 + 4 * x) * 3
                picture.append((data[at] * 15 + 127) // 255)
        return picture

    def gdb(self, *packets):
        """
        Stops the machine, sends packets of gdb's protocol and lets the machine go on. Each packet must be answered with
        OK unless it is a query (q).
        """
        with self._connect(self.gdb_path) as sock:
            sock.settimeout(PATIENCE)
            stream = sock.makefile("rb")
            bad = [p for p in (*packets, "D") if self._ask(sock, stream, p) != "OK" and p[0] != "q"]
        if bad:
            raise Failed(f"gdb's stub refuses {bad}")

    @staticmethod
    def _ask(sock, stream, text):
        """The answer to a packet; reports that the machine has stopped (T...) are skipped."""
        sock.sendall(f"${text}#{sum(text.encode()) % 256:02x}".encode())
        answer = "T"
        while answer.startswith("T"):
            while stream.read(1) not in (b"$", b""):
                pass
            answer = b"".join(iter(lambda: stream.read(1), b"#")).decode()
            stream.read(2)
            sock.sendall(b"+")
        return answer
