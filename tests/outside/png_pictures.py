"""PNG pictures of 8 bits, by Python's own library alone: pixels read and written, and how far two pictures are apart."""
import math
import struct
import zlib
from pathlib import Path


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png_bytes(width, height, rgb):
    """A PNG of width * height * 3 bytes."""
    rows = b"".join(b"\0" + rgb[y * width * 3:(y + 1) * width * 3] for y in range(height))
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


def unfiltered(data, stride, rows, step):
    """The bytes of all rows, `step` bytes per pixel; PNG's filters undone."""
    result, above = [], bytearray(stride)
    for y in range(rows):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        if kind == 1:
            for i in range(step, stride):
                row[i] = (row[i] + row[i - step]) & 255
        elif kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, above))
        elif kind == 3:
            for i in range(stride):
                row[i] = (row[i] + ((row[i - step] if i >= step else 0) + above[i]) // 2) & 255
        elif kind == 4:
            for i in range(stride):
                left, corner = (row[i - step], above[i - step]) if i >= step else (0, 0)
                guess = left + above[i] - corner
                near = min((abs(guess - left), 0, left), (abs(guess - above[i]), 1, above[i]), (abs(guess - corner), 2, corner))
                row[i] = (row[i] + near[2]) & 255
        result.append(row)
        above = row
    return b"".join(result)


def read(path):
    """(width, height, rgb) of a PNG of 8 bits with or without alpha, which is left out."""
    data = Path(path).read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, bits, colors, _, _, interlaced = struct.unpack(">IIBBBBB", data[at + 8:at + 21])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    if bits != 8 or colors not in (2, 6) or interlaced:
        raise ValueError(f"{path}: not a PNG of 8 bits per channel, RGB or RGBA")
    step = 3 if colors == 2 else 4
    rgb = unfiltered(zlib.decompress(packed), width * step, height, step)
    if step == 4:
        rgb = bytes(value for i, value in enumerate(rgb) if i % 4 != 3)
    return width, height, rgb


class Difference:
    """Of two pictures of one size: pixels beyond 1/255 in a channel, the largest step, decibels (PSNR)."""

    def __init__(self, first, second):
        if first[:2] != second[:2]:
            raise ValueError(f"pictures of {first[:2]} and {second[:2]}")
        steps = [abs(a - b) for a, b in zip(first[2], second[2])]
        self.pixels = first[0] * first[1]
        self.largest = max(steps)
        self.beyond = sum(max(steps[i:i + 3]) > 1 for i in range(0, len(steps), 3))
        squares = sum(step * step for step in steps)
        self.decibels = 10.0 * math.log10(255.0 ** 2 * len(steps) / squares) if squares else math.inf

    def __str__(self):
        far = "equal" if self.largest == 0 else f"{self.decibels:.1f} dB"
        return f"{self.beyond} of {self.pixels} beyond 1/255, largest {self.largest}, {far}"
