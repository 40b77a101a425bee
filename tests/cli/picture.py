"""picture.py - reads back the PNG files that the command writes."""
import struct
import zlib


def picture(path, channels=3):
    """Width, height and rows of RGB bytes, or with 4 channels RGBA, of a PNG of 8 bits a channel."""
    data = open(path, "rb").read()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    assert (depth, color) == (8, {3: 2, 4: 6}[channels]), f"{path}: not of 8 bits and {channels} channels"
    raw, rows, last, size = zlib.decompress(packed), [], bytes(channels * width), channels * width + 1
    for y in range(height):
        kind, row = raw[y * size], bytearray(raw[y * size + 1:(y + 1) * size])
        for x in range(channels * width):
            a, b, c = (row[x - channels] if x >= channels else 0), last[x], (last[x - channels] if x >= channels else 0)
            paeth = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
            row[x] = (row[x] + (0, a, b, (a + b) // 2, paeth)[kind]) & 255
        rows.append(bytes(row))
        last = row
    return width, height, rows
