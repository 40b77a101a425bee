"""picture_make.py - pictures written by hand: PNG of every sort, a JPEG of grey blocks; what a texture of them must be."""
import struct
import zlib

CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}
PASSES = ((0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2))


def chunk(kind, body):
    return struct.pack(">I4s", len(body), kind) + body + struct.pack(">I", zlib.crc32(kind + body))


def pack_row(samples, depth):
    """Samples of a row in 1 to 16 bits each, the first one high; with the filter none."""
    if depth == 16:
        return b"\0" + struct.pack(f">{len(samples)}H", *samples)
    bits = "".join(f"{s:0{depth}b}" for s in samples)
    bits += "0" * (-len(bits) % 8)
    return b"\0" + bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))


def png(rows, kind=6, depth=8, interlaced=False, palette=None, transparent=None, size=None, more=b""):
    """rows[y][x]: a tuple of samples. size: what the header says instead; more: chunks before the pixels."""
    width, height = len(rows[0]), len(rows)
    lines = b""
    for x0, y0, dx, dy in PASSES if interlaced else ((0, 0, 1, 1),):
        if x0 < width:
            lines += b"".join(pack_row([s for pixel in row[x0::dx] for s in pixel], depth) for row in rows[y0::dy])
    head = struct.pack(">IIBBBBB", *(size or (width, height)), depth, kind, 0, 0, int(interlaced))
    out = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + more
    if palette:
        out += chunk(b"PLTE", b"".join(bytes(c) for c in palette))
    if transparent is not None:
        out += chunk(b"tRNS", transparent)
    return out + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def flat_png(width, height):
    """White, of one bit a pixel, whatever its size: rows are not held in memory twice."""
    packer, row = zlib.compressobj(1), b"\0" + b"\xff" * ((width + 7) // 8)
    body = b"".join(packer.compress(row) for _ in range(height)) + packer.flush()
    head = struct.pack(">IIBBBBB", width, height, 1, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", body) + chunk(b"IEND", b"")


def jpeg(levels, size=None):
    """Grey, a block of 8 x 8 pixels for each of levels[y][x], exactly that level. size: what the header says instead."""
    def segment(mark, body):
        return bytes((0xff, mark)) + struct.pack(">H", len(body) + 2) + body

    width, height = size or (8 * len(levels[0]), 8 * len(levels))
    # DC: the categories 0 to 11 have codes of 4 bits, in order; AC: the end of the block is the one code, a bit.
    tables = b"\0" + bytes((0, 0, 0, 12)) + bytes(12) + bytes(range(12)) + b"\x10" + b"\1" + bytes(15) + b"\0"
    bits, last = "", 0
    for level in (level for row in levels for level in row):
        step, last = 8 * (level - 128) - last, 8 * (level - 128)
        count = abs(step).bit_length()
        bits += f"{count:04b}" + (f"{step if step > 0 else step + (1 << count) - 1:0{count}b}" if count else "") + "0"
    bits += "1" * (-len(bits) % 8)
    data = bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8)).replace(b"\xff", b"\xff\0")
    return (b"\xff\xd8" + segment(0xe0, b"JFIF\0\1\1\0\0\1\0\1\0\0") + segment(0xdb, b"\0" + bytes([1] * 64)) +
            segment(0xc0, struct.pack(">BHHB", 8, height, width, 1) + b"\1\x11\0") + segment(0xc4, tables) +
            segment(0xda, b"\1\1\0\0\x3f\0") + data + b"\xff\xd9")


# ---- what a texture of it must be ----

def side(length, most):
    """The largest power of two that is at most both."""
    out = 1
    while 2 * out <= min(length, most):
        out *= 2
    return out


def overlaps(length, texels):
    """Of each texel the pixels in it, with the length of their parts, in 1/texels of a pixel."""
    for t in range(texels):
        yield [(p, min((p + 1) * texels, (t + 1) * length) - max(p * texels, t * length))
               for p in range(t * length // texels, -(-(t + 1) * length // texels))]


def half_up(number, by):
    return (2 * number + by) // (2 * by)


def reduced(rows, most):
    """rows[y][x]: r, g, b, alpha in bytes. The same, reduced by area: colours weighted by alpha, alpha by area."""
    width, height, out = len(rows[0]), len(rows), []
    for down in overlaps(height, side(height, most[1])):
        out.append([])
        for across in overlaps(width, side(width, most[0])):
            parts = [(rows[y][x], a * b) for y, b in down for x, a in across]
            area, alpha = sum(a for _, a in parts), sum(p[3] * a for p, a in parts)
            color = [half_up(sum(p[k] * p[3] * a for p, a in parts), alpha) if alpha else
                     half_up(sum(p[k] * a for p, a in parts), area) for k in range(3)]
            out[-1].append((*color, half_up(alpha, area)))
    return out


def to_565(pixel):
    return tuple(half_up(pixel[k] * most, 255) for k, most in enumerate((31, 63, 31)))


def from_565(value):
    return tuple(half_up(value[k] * 255, most) for k, most in enumerate((31, 63, 31)))
