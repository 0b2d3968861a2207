"""Damages to the keys and values of a spec, and overrides that do the same."""

from __future__ import annotations

import copy
import datetime
from collections.abc import Callable, Iterator
from random import Random
from typing import Any

Place = tuple[Any, Any]
"""A mapping or list, and the key or index in it."""

ODD_VALUES: list[Any] = [
    None, True, False, "", " ", [], {}, [[]], [None], {"": ""}, {"a": {"b": [1]}}, 0, -1, 1, 10**400,
    -(10**30), 2**63, 2**64, 1e308, -1e308, 5e-324, float("nan"), float("inf"), -float("inf"),
    "nan", "inf", "1e999", "-1e999", "1e-999", "1_000", "0x10", "0o17", "1:30", "=", "<<", "*a", "&a",
    "yes", "no", "on", "off", "auto", "null", "~", "äöü", "\u202e", "\x85", "\u2028", "🙂", "١٢ mm",
    "½ mm", "1 ㎜", "a" * 5000, "9" * 5000, "1 " + "m*" * 30 + "m", "1 m^9999", "1 m**m", "2**99999 m",
    "(1 m)", "1 m)", "((((1", "1 m/0", "1/0 m", "0/0", "1e3", "1 e3 m", "%", "5 %", "5 % %", "5 mm mm",
    "12 parsec", "3 furlongz", "20 degC", "-500 degC", "20 degC/m", "1 delta_degC", "1 dB", "1 m + 1 s",
    "1 m - 1 m", "--1", "+-1", ".", "-", "1.2.3", "1,5 mm", "1 mm # no", "__import__('os')", "{}", "[]",
    "R1", "L1", "inlet", "R1-R2", "../../etc/passwd", "/dev/zero", "/dev/null", "table.csv", "\x00",
    "\x1b[31m", "\ud800", "line\nline", "tab\ttab", datetime.date(2026, 1, 1),
    datetime.datetime(2026, 1, 1, 12), b"binary", {1, 2}, {"kind": None}, {"kind": []}, {"kind": "sine"},
    {"kind": {"kind": 1}}, {"name": "own"}, {1: 2}, {None: 1}, {True: 1}, [[0, 0], [1]], [[0, 0], [1, 2, 3]],
    [0] * 3000, {f"k{k}": k for k in range(300)},
]  # fmt: skip
UNITS = (
    "mm", "m", "kPa", "Pa", "s", "ms", "kg", "rad", "deg", "degC", "K", "N", "Hz", "m^2/Pa", "Pa*s",
    "J", "V", "A", "mol", "bit", "m^3", "1/m", "m/s", "%", "", "pint", "bar", "atm", "psi", "inch",
)  # fmt: skip


def _odd(rng: Random) -> Any:
    """One of them of its own: later damages may change it."""
    return copy.deepcopy(rng.choice(ODD_VALUES))


def places(tree: Any) -> Iterator[Place]:
    """Every entry of every mapping and list below."""
    entries: Iterator[Any] = iter(())
    if isinstance(tree, dict):
        entries = iter(list(tree))
    elif isinstance(tree, list):
        entries = iter(range(len(tree)))
    for key in entries:
        yield tree, key
        yield from places(tree[key])


def _place(rng: Random, tree: Any, *, in_mapping: bool = False) -> Place:
    found = [p for p in places(tree) if isinstance(p[0], dict) or not in_mapping]
    return rng.choice(found) if found else ({"": None}, "")


def _delete(rng: Random, tree: Any) -> None:
    parent, key = _place(rng, tree)
    del parent[key]


def _rename(rng: Random, tree: Any) -> None:
    """A key with a slip of the finger."""
    parent, key = _place(rng, tree, in_mapping=True)
    word = str(key)
    at = rng.randrange(len(word) + 1)
    slip = rng.choice(["", "x", "_", " ", "é", ".", word[:1] * 2, ":", "\t", "#"])
    parent[word[:at] + slip + word[at + 1 :]] = parent.pop(key)


def _odd_key(rng: Random, tree: Any) -> None:
    """A key that no spec has, or one from another section."""
    parent, _ = _place(rng, tree, in_mapping=True)
    _, other = _place(rng, tree)
    key = rng.choice([other, "", " ", None, 7, 1.5, True, "<<", "a.b", "k" * 3000, "ключ", "\x07"])
    parent[key] = _odd(rng)


def _odd_value(rng: Random, tree: Any) -> None:
    parent, key = _place(rng, tree)
    parent[key] = _odd(rng)


def _wrong_unit(rng: Random, tree: Any) -> None:
    parent, key = _place(rng, tree)
    number = rng.choice([1, 0, -3, 0.5, "1e-3", "1e300", "1e-300", "7"])
    parent[key] = f"{number} {rng.choice(UNITS)}"


def _extreme_number(rng: Random, tree: Any) -> None:
    """A number of a size that nobody meant."""
    parent, key = _place(rng, tree)
    if isinstance(parent[key], (int, float, str)):
        parent[key] = rng.choice([1, -1]) * float(f"{10 ** rng.uniform(-320, 308):.3g}")


def _other_number(rng: Random, tree: Any) -> None:
    """A number some powers of ten away: a wrong prefix, a slipped point."""
    numbers = [
        (parent, key)
        for parent, key in places(tree)
        if isinstance(parent[key], float)
        or (isinstance(parent[key], int) and 1 < parent[key] < 1e15)
    ]
    for parent, key in rng.sample(numbers, min(len(numbers), 2)):
        parent[key] = float(f"{parent[key] * 10 ** rng.uniform(-6, 6):.3g}")


def _wrap(rng: Random, tree: Any) -> None:
    """A value one level deeper than it belongs."""
    parent, key = _place(rng, tree)
    value = parent[key]
    parent[key] = rng.choice(
        [[value], {"value": value}, {str(key): value}, [value, copy.deepcopy(value)]]
    )


def _move(rng: Random, tree: Any) -> None:
    """A value where another belongs."""
    parent, key = _place(rng, tree)
    other, name = _place(rng, tree)
    value = other[name]
    if isinstance(value, (dict, list)):
        value = str(value)[:60]
    parent[key] = value


GRAMMAR_SLIPS = (
    "{a} {b}{u}", "{a},{b}{u}", "{a}_{b}{u}", "{a}'{b}{u}", "{a}.{b}.{a}{u}", "{a}({b}){u}", "({a}){u}", "[{a}]{u}",
    "{a}{u} +- {b}{u}", "{a} ± {b}{u}", "{a}{u} - {b}{u}", "{a}-{b}{u}", "{a}..{b}{u}", "{a} to {b}{u}",
    "{a}/{b}{u}", "{a} {b}/{a}{u}", "{a}*{b}{u}", "{a} x {b}{u}", "{a}{u}*{b}", "{a}{u} {b}", "{a}{u}; {b}",
    "{a}e{b}.5{u}", "{a} e{b}{u}", "{a}e {b}{u}", "{a}*10^{b}{u}", "{a}\u00a0{u}", "{a}\u202f{b}{u}", "\u2212{a}{u}",
    "\uff11{u}", "\u0661{u}", "½{u}", "~{a}{u}", "<{a}{u}", "0x{a}{u}", "{a}:{b}{u}", "+-{a}{u}", "--{a}{u}",
    "{a}+{b}{u}", "{a}**{b}{u}", "{a}^{b}{u}", "{u} {a}", "{a}{u}.{u}", "{a} ({u})", "{a} %{u}", "{a}\u200b{u}",
)  # fmt: skip
"""Texts with two numbers, or with one that is no plain number; none of them is a value."""


def grammar_slip(rng: Random) -> str:
    """A text outside of the grammar of values."""
    first, second = rng.choice(["1", "37.5", "800", "-3"]), rng.choice(["2", "500", "16"])
    return rng.choice(GRAMMAR_SLIPS).format(a=first, b=second, u=f" {rng.choice(UNITS[:20])}")


def _grammar_slip(rng: Random, tree: Any) -> None:
    """A number written as people write numbers, which no value may be."""
    numbers = [p for p in places(tree) if _is_number(p[0][p[1]])]
    if numbers:
        parent, key = rng.choice(numbers)
        parent[key] = grammar_slip(rng)


def _other_prefix(rng: Random, tree: Any) -> None:
    """Numbers with a wrong prefix or unit, such as metres for millimetres."""
    numbers = [p for p in places(tree) if _is_number(p[0][p[1]])]
    for parent, key in rng.sample(numbers, min(len(numbers), rng.choice([1, 1, 3]))):
        parent[key] = float(f"{parent[key] * rng.choice([1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9]):.6g}")


def _reference(rng: Random, tree: Any) -> None:
    """A pressure, or something else, with a reference."""
    numbers = [p for p in places(tree) if _is_number(p[0][p[1]])]
    if numbers:
        parent, key = rng.choice(numbers)
        word = rng.choice(
            ["abs", "gauge", "absolute", "rel", "ABS", "abs abs", "gauge abs", "(abs)"]
        )
        parent[key] = (
            f"{rng.choice([1, 140, -3])} {rng.choice(['kPa', 'bar', 'Pa', 'm', ''])} {word}"
        )


def _both_outputs(rng: Random, tree: Any) -> None:
    """Keys of outputs that exclude each other, by the million, or that coincide."""
    run = tree.get("run") if isinstance(tree, dict) else None
    if isinstance(run, dict):
        run |= rng.choice(
            [
                {"output_interval": 0.1, "output_times": [0.1]},
                {"output_times": [0.1, 0.1 + 1e-15, 0.2]},
                {"output_times": None},
                {"output_interval": None},
            ]
        )


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and abs(value) < 1e15


TREE_DAMAGES: list[Callable[[Random, Any], None]] = [
    _delete, _rename, _odd_key, _odd_value, _odd_value, _odd_value, _wrong_unit, _extreme_number,
    _wrap, _move, _other_number, _other_number, _extreme_number,
    _grammar_slip, _grammar_slip, _other_prefix, _reference, _both_outputs,
]  # fmt: skip


def _path(rng: Random, tree: Any) -> str:
    """The dotted path of an entry."""
    parts, here = [], tree
    while isinstance(here, (dict, list)) and here and (not parts or rng.random() < 0.8):
        keys = list(here) if isinstance(here, dict) else list(range(len(here)))
        parts.append(rng.choice(keys))
        here = here[parts[-1]]
    return ".".join(map(str, parts))


def _set_value(rng: Random, tree: Any) -> str:
    return f"{_path(rng, tree)}={_word(rng)}"


def _set_unit(rng: Random, tree: Any) -> str:
    return f"{_path(rng, tree)}={rng.choice([1, -2, 0.5, '1e9'])} {rng.choice(UNITS)}"


def _set_number(rng: Random, tree: Any) -> str:
    return f"{_path(rng, tree)}={10 ** rng.uniform(-12, 12):.3g}"


def _set_below(rng: Random, tree: Any) -> str:
    """A key below one that may have none."""
    more = rng.choice(
        ["x", "0", "-1", "999999999999", "kind", "tubes.0", "a.b.c.d.e", "", ".", "١"]
    )
    return f"{_path(rng, tree)}.{more}={_word(rng)}"


def _set_elsewhere(rng: Random, tree: Any) -> str:
    keys = ["", "=", "==", ".", "..", "a", "run", "run.", ".run", "Run.duration", "effects", "inputs.a",
            "network.changes.R1-R2", "pump.servo_id", "\x00", "ключ", "a" * 3000, ".".join("a" * 500)]  # fmt: skip
    return rng.choice(keys) + rng.choice(["=", "", " = ", "=="]) + _word(rng)


def _word(rng: Random) -> str:
    """What may stand behind the equals sign."""
    odd = rng.choice(ODD_VALUES)
    words = [str(odd)[:6000], repr(odd)[:6000], "[", "{", "[[0,0],[1,1e5]]", "{kind: sine}", "- a", "a: b", "!!x y",
             "&a [*a]", "*a", "'", '"', "|\n x", "# x", "---\na\n---\nb", "%YAML 9.9", "@", "`", "[" * 500,
             "{a: " * 200, "? a", "!", "&a", "<<: 1", "{<<: 1}", "{[1]: 2}", "{a: 1, a: 2}"]  # fmt: skip
    return rng.choice(words)


def _set_slip(rng: Random, tree: Any) -> str:
    return f"{_path(rng, tree)}={grammar_slip(rng)}"


OVERRIDES: list[Callable[[Random, Any], str]] = [
    _set_value, _set_value, _set_unit, _set_below, _set_elsewhere, _set_number, _set_number,
    _set_slip,
]  # fmt: skip
