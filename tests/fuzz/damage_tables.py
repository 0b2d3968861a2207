"""Tables in CSV that are damaged: an input's, a plunger's, a bellow's curve."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

import yaml

from tests.fuzz.damage_text import ODD_CHARACTERS

CELLS = (
    "", " ", "nan", "inf", "-inf", "1e999", "1e308", "-1e308", "1e-320", "x", "1,5", "1;5", "1 kPa", "0x10",
    "1_000", "١", '"', '"1"', '"1,2"', "\x00", "--1", "1e", "9" * 400, "TRUE", "=1+1", "é", "#", "'1'", "\t1", "-0",
)  # fmt: skip
Rows = list[list[str]]
CHOICES: dict[str, tuple[Any, ...]] = {
    "repeat": (True, False, "yes", "off", 3, None),
    "smooth": (
        "auto",
        "off",
        False,
        "20 ms",
        "5 Hz",
        "0 s",
        "-1 s",
        "1e9 s",
        "1e12 Hz",
        5,
        "5",
        "often",
        None,
    ),
    "decimal": ("comma", "point", "dot", 3, None),
}
"""Other keys of a table, with values right and wrong."""


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
    given: dict[str, Any] = {"kind": "table", "file": "broken.csv"}
    for key, values in CHOICES.items():
        if rng.random() < 0.25:
            given[key] = rng.choice(values)
    if rng.random() < 0.25:
        given["columns"] = yaml.safe_load(rng.choice(COLUMNS))
    _set_input(spec, given)
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


SPELLINGS = (
    "{name} [{unit}]", "{name} ({unit})", "{name}/{unit}", "{name}, {unit}", "{name}_{unit}", "{name} in {unit}",
    "{name}", "[{unit}]", "{name} [[{unit}]", "{name} ({unit}", "{name}_{unit}_{unit}", "{unit}", "{name} [{unit} abs]",
    "{name} ({unit}(g))", "inlet_{name}_pa",
)  # fmt: skip
UNITS = (
    "s", "ms", "µs", "min", "Pa", "kPa", "mpa", "MPa", "mbar", "psi", "psig", "m", "mm", "inch", "deg", "°", "m2",
    "mm^2", "", "%", "furlong", "kPa/s", "s" * 300,
)  # fmt: skip
COLUMNS = (
    "{time: 1, pressure: 2}", "{time: 2, pressure: 1}", "{pressure: {column: 2, unit: kPa}}", "{time: 0}", "{time: 99}",
    "{x: 1}", "{}", "[]", "{time: {}}", "{time: {column: time_s, unit: kPa}}", "{time: {column: 1, unit: 3}}", "{time: [1]}",
    "{position: {column: 2, unit: mm}}", "{time: true}", "{time: null}", "{pressure: 'p [kPa]'}",
)  # fmt: skip


def _spelled_header(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    """Headers as loggers write them, or nearly so."""
    named = []
    for cell in header:
        name = rng.choice([cell.rsplit("_", 1)[0], "t", "p", "Zeit", "x", ""])
        named.append(rng.choice(SPELLINGS).format(name=name, unit=rng.choice(UNITS)))
    return named, rows


def _decimal_commas(rng: Random, header: list[str], rows: Rows) -> tuple[list[str], Rows]:
    signs = rng.choice(["...", ",,,", ",,.", ".,,"])
    commas = [[cell.replace(".", rng.choice(signs)) for cell in row] for row in rows]
    return [";".join(header)], [[";".join(row)] for row in commas]


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
    _spelled_header, _spelled_header, _decimal_commas,
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
