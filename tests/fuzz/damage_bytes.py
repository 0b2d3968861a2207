"""Files that are no text of a spec at all, or in an encoding that none has."""

from __future__ import annotations

from collections.abc import Callable
from random import Random


def _noise(rng: Random, text: str) -> bytes:
    return bytes(rng.randrange(256) for _ in range(rng.choice([0, 1, 2, 30, 3000])))


def _words(rng: Random, text: str) -> bytes:
    """Characters of YAML in no order."""
    alphabet = "ab1 :-[]{}&*!?|>'\"%#,\n\t"
    return "".join(rng.choice(alphabet) for _ in range(rng.choice([1, 5, 50, 500]))).encode()


def _flipped(rng: Random, text: str) -> bytes:
    content = bytearray(text.encode())
    for _ in range(rng.choice([1, 1, 3, 30])):
        content[rng.randrange(len(content))] = rng.randrange(256)
    return bytes(content)


def _encoded(rng: Random, text: str) -> bytes:
    name = rng.choice(["utf-16", "utf-16-le", "utf-32", "latin-1", "cp037", "utf-8-sig", "utf-7"])
    content = text.encode(name, errors="replace")
    return content * 2 if rng.random() < 0.2 else content


def _cut(rng: Random, text: str) -> bytes:
    """In the middle of a character."""
    return text.encode() + "ä".encode()[:1]


def _whole(rng: Random, text: str) -> bytes:
    return rng.choice(
        [b"", b" ", b"\n", b"\t", b"\x00", b"#", b"---", b"...", b"null", b"~", b"{}", b"[]", b"a", b"1", b"''",
         b"- a", b"a:", b": a", b"{a}", b"? a", b"&a", b"*a", b"!x", b"%YAML 1.2", b"\xef\xbb\xbf", b"\xff\xfe",
         b"\x89PNG\r\n\x1a\n", b"PK\x03\x04", b"%PDF-1.4", b"<?xml version='1.0'?>", b'{"name": 1}',
         b"name: x\nactuator: []\n", b"a: 1\n" * 100_000, b"[" * 100_000, b"- " * 100_000,
         b"".join(b"k%d: 1\n" % k for k in range(30_000)), b"x: " + b"y" * (5 << 20)]
    )  # fmt: skip


BYTE_DAMAGES: list[Callable[[Random, str], bytes]] = [
    _noise, _words, _flipped, _flipped, _encoded, _cut, _whole, _whole,
]  # fmt: skip
