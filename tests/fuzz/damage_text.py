"""Damages to the text of a spec: lines, indentation, YAML's own devices."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

ODD_CHARACTERS = "\t\x00\x01\x07\x1b\x7f\x85\xa0\u2028\u202e\ufeff:{}[]&*!|>'\"%@`#,?-=\\\n\r éΩ🙂"
LAUGHS = "".join(
    f"l{k}: &l{k} [{', '.join([f'*l{k - 1}'] * 9)}]\n" if k else "l0: &l0 [lol]\n"
    for k in range(12)
)
"""A billion of them, once unfolded."""
DEVICES = (
    "&a ", "*a ", "*unknown ", "!!python/object/apply:os.system ['true'] ", "!!python/name:os.system ",
    "!!binary aGVsbG8= ", "!!set {a, b} ", "!!omap [a: 1] ", "!!timestamp 2026-01-01 ", "!!int x ", "!own 3 ",
    "!<tag:yaml.org,2002:float> x ", "<<: *a ", "<<: [1, 2] ", "? [a, b] : c ", "|\n", ">-\n", "--- ", "... ",
    "%YAML 1.1\n", "%TAG ! tag:x,2000:\n", "{<<: {count: 3}} ", "&a [*a] ", "&a {b: *a} ", "'", '"', '"\\x00" ',
    '"\\ud800" ', '"\\q" ', "{a: 1, a: 2} ", "[1, 2", "}", "? ", "- ", ": ", ", ", "#", " #",
)  # fmt: skip


def _lines(text: str) -> list[str]:
    return text.split("\n")


def _truncate(rng: Random, text: str) -> str:
    return text[: rng.randrange(len(text) + 1)]


def _lost_beginning(rng: Random, text: str) -> str:
    return text[rng.randrange(len(text) + 1) :]


def _odd_character(rng: Random, text: str) -> str:
    at = rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(ODD_CHARACTERS) * rng.choice([1, 1, 3]) + text[at:]


def _lost_character(rng: Random, text: str) -> str:
    at = rng.randrange(len(text) + 1)
    return text[:at] + text[at + 1 :]


def _device(rng: Random, text: str) -> str:
    """One of YAML's devices before a value, or anywhere."""
    colons = [k + 2 for k in range(len(text) - 1) if text[k : k + 2] == ": "]
    at = rng.choice(colons) if colons and rng.random() < 0.8 else rng.randrange(len(text) + 1)
    return text[:at] + rng.choice(DEVICES) + text[at:]


def _lost_line(rng: Random, text: str) -> str:
    lines = _lines(text)
    del lines[rng.randrange(len(lines))]
    return "\n".join(lines)


def _doubled_line(rng: Random, text: str) -> str:
    lines = _lines(text)
    lines.insert(rng.randrange(len(lines) + 1), rng.choice(lines))
    return "\n".join(lines)


def _swapped_lines(rng: Random, text: str) -> str:
    lines = _lines(text)
    a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    return "\n".join(lines)


def _indentation(rng: Random, text: str) -> str:
    lines = _lines(text)
    at = rng.randrange(len(lines))
    lines[at] = rng.choice(["", " ", "\t", "   ", "          "]) + lines[at].strip()
    return "\n".join(lines)


def _tabs(rng: Random, text: str) -> str:
    return text.replace("  ", "\t", rng.choice([-1, 1, 3]))


def _documents(rng: Random, text: str) -> str:
    return (
        text
        + rng.choice(["\n---\n", "\n...\n---\n", "\n---\n---\n", "\n...\n"])
        + rng.choice(["", text, "a: 1", "- x"])
    )


def _line_ends(rng: Random, text: str) -> str:
    return text.replace("\n", rng.choice(["\r\n", "\r", "\n\r", "\x85", "\u2028"]))


def _alias_expansion(rng: Random, text: str) -> str:
    return LAUGHS + text if rng.random() < 0.5 else text + "\n" + LAUGHS


def _shared(rng: Random, text: str) -> str:
    """An anchor on one section and its alias in the place of another."""
    lines = _lines(text)
    heads = [
        k for k, line in enumerate(lines) if line[:1].isalpha() and line.rstrip().endswith(":")
    ]
    if len(heads) < 2:
        return text
    one, other = sorted(rng.sample(heads, 2))
    lines[one] += " &shared"
    lines[other] += rng.choice([" *shared", "\n  <<: *shared"])
    return "\n".join(lines)


def _long_line(rng: Random, text: str) -> str:
    size = rng.choice([1000, 100_000, 1_000_000])
    word = rng.choice(["x", "x ", "1", "[", "- ", "a: ", "{a: ", "é", "\\", "'"])
    return text + "\nlong: " + word * (size // len(word)) + "\n"


def _deep(rng: Random, text: str) -> str:
    depth = rng.choice([5, 31, 33, 500, 20_000])
    opening = rng.choice(["[", "{a: ", "- "])
    closing = {"[": "]", "{a: ": "}", "- ": ""}[opening] * (depth if rng.random() < 0.5 else 0)
    return text + "\ndeep: " + opening * depth + closing + "\n"


TEXT_DAMAGES: list[Callable[[Random, str], str]] = [
    _truncate, _lost_beginning, _odd_character, _odd_character, _lost_character, _device, _device, _device,
    _lost_line, _doubled_line, _swapped_lines, _indentation, _tabs, _documents, _line_ends, _alias_expansion,
    _shared, _long_line, _deep,
]  # fmt: skip
