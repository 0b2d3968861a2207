"""Pictures of pixels as PNG."""

from __future__ import annotations

import struct
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"
PNG_COMPRESSION = 1
"""Level of zlib."""
METRE = 1 / 0.0254
"""[inch]"""


def png_bytes(pixels: np.ndarray, dpi: float) -> bytes:
    """A PNG of opaque pixels (height, width, 3), uint8.

    Drawings are mostly white: lines are compressed as they are, since to try filters on each of
    them, as image libraries do, takes as long again and saves nothing.
    """
    height, width, _ = pixels.shape
    lines = np.zeros((height, 1 + 3 * width), dtype=np.uint8)  # each begins with its filter: none
    lines[:, 1:] = pixels.reshape(height, -1)
    density = round(dpi * METRE)
    chunks = (
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
        (b"pHYs", struct.pack(">IIB", density, density, 1)),
        (b"IDAT", zlib.compress(lines.tobytes(), PNG_COMPRESSION)),
        (b"IEND", b""),
    )
    return SIGNATURE + b"".join(_chunk(kind, data) for kind, data in chunks)


def _chunk(kind: bytes, data: bytes) -> bytes:
    checksum = zlib.crc32(kind + data)
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", checksum)
