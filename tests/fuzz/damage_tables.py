"""Tables in CSV that are damaged: an input's, a plunger's, a bellow's curve."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

from tests.fuzz.damage_text import ODD_CHARACTERS

CELLS = (
    "", " ", "nan", "inf", "-inf", "1e999", "1e308", "-1e308", "1e-320", "x", "1,5", "1;5", "1 kPa", "0x10",
    "1_000", "١", '"', '"1"', '"1,2"', "\x00", "--1", "1e", "9" * 400, "TRUE", "=1+1", "é", "#", "'1'", "\t1", "-0",
)  # fmt: skip
Rows = list[list[str]]


def damaged_table(rng: Random, spec: dict[str, Any]) -> tuple[str, bytes]:
    """How it is damaged, and the content of the table that ``spec`` now reads."""
    header, rows = rng.choice([_input, _plunger, _curve])(rng, spec)
    if rng.random() < 0.25:
        damage = rng.choice(BYTES)
        return damage.__name__.strip("_"), damage(rng, _csv(header, rows))
    damage_rows = rng.choice(ROWS)
    return damage_rows.__name__.strip("_"), _csv(*damage_rows(rng, header, rows)).encode(
        "utf-8", errors="surrogatepass"
    )


def _csv(header: list[str], rows: Rows) -> str:
    return "\n".join(",".join(cells) for cells in [header, *rows]) + "\n"


def _input(rng: Random, spec: dict[str, Any]) -> tuple[list[str], Rows]:
    _set_input(spec, {"kind": "table", "file": "broken.csv"})
    return ["time_s", "pressure_pa"], [[repr(0.1 * k), repr(1e3 * k)] for k in range(8)]


def _plunger(rng: Random, spec: dict[str, Any]) -> tuple[list[str], Rows]:
    given = {"kind": "syringe", "diameter": 0.02, "start": 0.05, "file": "broken.csv"}
    _set_input(spec, given)
    spec["fluid"] = "air"
    return ["time_s", "position_m"], [[repr(0.1 * k), repr(1e-4 * k)] for k in range(8)]


def _set_input(spec: dict[str, Any], given: dict[str, Any]) -> None:
    if "inputs" in spec:
        spec["inputs"][next(iter(spec["inputs"]))] = given
    else:
        spec["input"] = given


def _curve(rng: Random, spec: dict[str, Any]) -> tuple[list[str], Rows]:
    spec["bellows"]["curve"] = {"file": "broken.csv"}
    rows = [[repr(1e4 * k), repr(1e-5 * k), repr(0.1 * k), repr(1e-3 * k)] for k in range(-3, 5)]
    return ["pressure_pa", "area_m2", "angle_rad", "extension_m"], rows


def _odd_cell(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    row = rng.choice(rows)
    row[rng.randrange(len(row))] = rng.choice(CELLS)
    return header, rows


def _odd_header(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    k = rng.randrange(len(header))
    header[k] = rng.choice(
        [header[k][:-1], header[k].upper(), "", "time_ms", " " + header[k], "x", "é" * 200]
    )
    return header, rows


def _other_columns(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    for cells in rng.choice([rows, rows[:1], [header], [header, *rows]]):
        if rng.random() < 0.5:
            cells.append("1")
        else:
            cells.pop()
    return header, rows


def _other_order(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    rng.shuffle(rows)
    return header, rows


def _other_length(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    return header, rng.choice([[], rows[:1], rows * 2, rows * 10_000, [rows[0]] * 3])


def _no_header(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    return rows[0], rows[1:]


ROWS: list[Callable[[Random, list[str], Rows], tuple[list[str], Rows]]] = [
    _odd_cell, _odd_cell, _odd_header, _other_columns, _other_order, _other_length, _no_header,
]  # fmt: skip


def _encoded(rng: Random, text: str) -> bytes:
    return text.encode(rng.choice(["utf-16", "utf-8-sig", "utf-32", "cp037"]))


def _line_ends(rng: Random, text: str) -> bytes:
    return text.replace("\n", rng.choice(["\r\n", "\r", "\n\n", "\x85", "\x00"])).encode()


def _odd_character(rng: Random, text: str) -> bytes:
    at = rng.randrange(len(text) + 1)
    return (text[:at] + rng.choice(ODD_CHARACTERS) + text[at:]).encode()


def _truncated(rng: Random, text: str) -> bytes:
    return text[: rng.randrange(len(text) + 1)].encode()


def _nothing(rng: Random, text: str) -> bytes:
    return rng.choice(
        [b"", b"\n", b"\x00", b",", b'"', b"\xff\xff", b"," * 100_000, b'"' + b"x" * 300_000]
    )


def _other_sign(rng: Random, text: str) -> bytes:
    return text.replace(",", rng.choice([";", "\t", " ", "|", ",,"])).encode()


BYTES: list[Callable[[Random, str], bytes]] = [
    _encoded, _line_ends, _odd_character, _truncated, _nothing, _other_sign,
]  # fmt: skip
