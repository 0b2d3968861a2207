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


def damaged_table(dice: Random, spec: dict[str, Any]) -> tuple[str, bytes]:
    """How it is damaged, and the content of the table that ``spec`` now reads."""
    header, rows = dice.choice([_input, _plunger, _curve])(dice, spec)
    if dice.random() < 0.25:
        damage = dice.choice(BYTES)
        return damage.__name__.strip("_"), damage(dice, _csv(header, rows))
    damage_rows = dice.choice(ROWS)
    return damage_rows.__name__.strip("_"), _csv(*damage_rows(dice, header, rows)).encode(
        "utf-8", errors="surrogatepass"
    )


def _csv(header: list[str], rows: Rows) -> str:
    return "\n".join(",".join(cells) for cells in [header, *rows]) + "\n"


def _input(dice: Random, spec: dict[str, Any]) -> tuple[list[str], Rows]:
    _set_input(spec, {"kind": "table", "file": "broken.csv"})
    return ["time_s", "pressure_pa"], [[repr(0.1 * k), repr(1e3 * k)] for k in range(8)]


def _plunger(dice: Random, spec: dict[str, Any]) -> tuple[list[str], Rows]:
    given = {"kind": "syringe", "diameter": 0.02, "start": 0.05, "file": "broken.csv"}
    _set_input(spec, given)
    spec["fluid"] = "air"
    return ["time_s", "position_m"], [[repr(0.1 * k), repr(1e-4 * k)] for k in range(8)]


def _set_input(spec: dict[str, Any], given: dict[str, Any]) -> None:
    if "inputs" in spec:
        spec["inputs"][next(iter(spec["inputs"]))] = given
    else:
        spec["input"] = given


def _curve(dice: Random, spec: dict[str, Any]) -> tuple[list[str], Rows]:
    spec["bellows"]["curve"] = {"file": "broken.csv"}
    rows = [[repr(1e4 * k), repr(1e-5 * k), repr(0.1 * k), repr(1e-3 * k)] for k in range(-3, 5)]
    return ["pressure_pa", "area_m2", "angle_rad", "extension_m"], rows


def _odd_cell(dice: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    row = dice.choice(rows)
    row[dice.randrange(len(row))] = dice.choice(CELLS)
    return header, rows


def _odd_header(dice: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    k = dice.randrange(len(header))
    header[k] = dice.choice(
        [header[k][:-1], header[k].upper(), "", "time_ms", " " + header[k], "x", "é" * 200]
    )
    return header, rows


def _other_columns(dice: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    for cells in dice.choice([rows, rows[:1], [header], [header, *rows]]):
        if dice.random() < 0.5:
            cells.append("1")
        else:
            cells.pop()
    return header, rows


def _other_order(dice: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    dice.shuffle(rows)
    return header, rows


def _other_length(dice: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    return header, dice.choice([[], rows[:1], rows * 2, rows * 10_000, [rows[0]] * 3])


def _no_header(dice: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    return rows[0], rows[1:]


ROWS: list[Callable[[Random, list[str], Rows], tuple[list[str], Rows]]] = [
    _odd_cell, _odd_cell, _odd_header, _other_columns, _other_order, _other_length, _no_header,
]  # fmt: skip


def _encoded(dice: Random, text: str) -> bytes:
    return text.encode(dice.choice(["utf-16", "utf-8-sig", "utf-32", "cp037"]))


def _line_ends(dice: Random, text: str) -> bytes:
    return text.replace("\n", dice.choice(["\r\n", "\r", "\n\n", "\x85", "\x00"])).encode()


def _odd_character(dice: Random, text: str) -> bytes:
    at = dice.randrange(len(text) + 1)
    return (text[:at] + dice.choice(ODD_CHARACTERS) + text[at:]).encode()


def _truncated(dice: Random, text: str) -> bytes:
    return text[: dice.randrange(len(text) + 1)].encode()


def _nothing(dice: Random, text: str) -> bytes:
    return dice.choice(
        [b"", b"\n", b"\x00", b",", b'"', b"\xff\xff", b"," * 100_000, b'"' + b"x" * 300_000]
    )


def _other_sign(dice: Random, text: str) -> bytes:
    return text.replace(",", dice.choice([";", "\t", " ", "|", ",,"])).encode()


BYTES: list[Callable[[Random, str], bytes]] = [
    _encoded, _line_ends, _odd_character, _truncated, _nothing, _other_sign,
]  # fmt: skip
