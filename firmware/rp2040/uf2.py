#!/usr/bin/env python3
"""uf2.py IMAGE.bin OUT.uf2 - a flash image of the RP2040 as a file to drag on to the Pico.

Refuses an image whose boot2 has a wrong checksum (the boot ROM would not start
it), and says which one is right.
Format: microsoft/uf2, README: blocks of 512 bytes, 256 of them payload.
"""
import contextlib
import os
import signal
import struct
import sys

FLASH = 0x10000000
PAYLOAD = 256
FAMILY_RP2040 = 0xE48BFF56
MAGIC = 0x0A324655, 0x9E5D5157, 0x0AB16F30
FAMILY_PRESENT = 0x2000
BOOT2 = 252  # bytes under its checksum


def crc32(data):
    """As the boot ROM has it: polynomial 04C11DB7, starts with all ones, nothing reflected or inverted."""
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte << 24
        for _ in range(8):
            crc = (crc << 1 ^ (0x04C11DB7 if crc & 0x80000000 else 0)) & 0xFFFFFFFF
    return crc


def blocks(image):
    count = (len(image) + PAYLOAD - 1) // PAYLOAD
    for i in range(count):
        payload = image[i * PAYLOAD:(i + 1) * PAYLOAD]
        head = struct.pack("<8I", *MAGIC[:2], FAMILY_PRESENT, FLASH + i * PAYLOAD, PAYLOAD, i, count, FAMILY_RP2040)
        yield head + payload.ljust(476, b"\0") + struct.pack("<I", MAGIC[2])


def main():
    if len(sys.argv) != 3:
        print("usage: uf2.py IMAGE.bin OUT.uf2", file=sys.stderr)
        sys.exit(2)
    source, out = sys.argv[1:]
    try:
        with open(source, "rb") as f:
            image = f.read()
        right = crc32(image[:BOOT2])
        if len(image) <= 256 or image[BOOT2:BOOT2 + 4] != struct.pack("<I", right):
            sys.exit(f"{source}: boot2's checksum is wrong; boot2.S should end with .word {right:#010x}")
    except OSError as error:
        sys.exit(f"{source}: {error.strerror}")
    for number in (signal.SIGINT, signal.SIGTERM): # too late: the file is there in a moment
        signal.signal(number, signal.SIG_IGN)
    try:
        with open(out + ".part", "wb") as f:
            f.writelines(blocks(image))
        os.replace(out + ".part", out)
    except OSError as error:
        sys.exit(f"{out}: {error.strerror}")
    finally:
        with contextlib.suppress(OSError):
            os.unlink(out + ".part")


if __name__ == "__main__":
    main()
