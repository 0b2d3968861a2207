"""Specs that are damaged: in their keys and values, their text, their bytes, their tables."""

from __future__ import annotations

import copy
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from random import Random
from typing import Any

import yaml

from tests.fuzz.damage_bytes import BYTE_DAMAGES
from tests.fuzz.damage_tables import damaged_table
from tests.fuzz.damage_text import TEXT_DAMAGES
from tests.fuzz.damage_values import OVERRIDES, TREE_DAMAGES
from tests.fuzz.scenes import draft
from tests.scenes import CONFIGS

BUNDLED = sorted(p.name for p in CONFIGS.glob("*.yaml"))


@dataclass(frozen=True)
class Broken:
    """A file that may be no spec any more, its tables, and overrides."""

    how: str
    text: bytes
    files: dict[str, bytes] = field(default_factory=dict)
    overrides: tuple[str, ...] = ()


Way = Callable[[Random, dict[str, Any]], Broken]


def broken_spec(dice: Random) -> Broken:
    """A valid spec with one damage, or a few."""
    scene = draft(dice)
    files = {name: text.encode() for name, text in scene.files.items()}
    way = dice.choice([_in_values, _in_values, _in_text, _in_text, _in_bytes, _in_tables, _by_set])
    return (
        replace(way(dice, scene.spec), files=files)
        if way is not _in_tables
        else (_in_tables(dice, scene.spec))
    )


def _dumped(dice: Random, spec: dict[str, Any]) -> str:
    flow = dice.choice([None, None, False])
    return yaml.safe_dump(spec, sort_keys=False, default_flow_style=flow, width=100)


def _text(dice: Random, spec: dict[str, Any]) -> str:
    """The spec as YAML, or one of the bundled ones with their comments and units."""
    if dice.random() < 0.4:
        return (CONFIGS / dice.choice(BUNDLED)).read_text(encoding="utf-8")
    return _dumped(dice, spec)


def _in_values(dice: Random, spec: dict[str, Any]) -> Broken:
    whole = yaml.safe_load(_text(dice, spec))
    told = []
    for _ in range(dice.choice([1, 1, 1, 2, 5])):
        damage = dice.choice(TREE_DAMAGES)
        told.append(damage.__name__.strip("_"))
        damage(dice, whole)
    return Broken(" + ".join(told), _dump_any(whole))


def _dump_any(whole: Any) -> bytes:
    """YAML of what a mapping became, whatever it holds."""
    return yaml.dump(whole, Dumper=_Plain, sort_keys=False, allow_unicode=True).encode(
        "utf-8", errors="surrogatepass"
    )


class _Plain(yaml.SafeDumper):
    """Writes a thing that duplicate key, first defined on line twice."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _in_text(dice: Random, spec: dict[str, Any]) -> Broken:
    text, told = _text(dice, spec), []
    for _ in range(dice.choice([1, 1, 2, 4])):
        damage = dice.choice(TEXT_DAMAGES)
        told.append(damage.__name__.strip("_"))
        text = damage(dice, text)
    return Broken(" + ".join(told), text.encode("utf-8", errors="surrogatepass"))


def _in_bytes(dice: Random, spec: dict[str, Any]) -> Broken:
    damage = dice.choice(BYTE_DAMAGES)
    return Broken(damage.__name__.strip("_"), damage(dice, _text(dice, spec)))


def _in_tables(dice: Random, spec: dict[str, Any]) -> Broken:
    spec = copy.deepcopy(spec)
    how, content = damaged_table(dice, spec)
    return Broken(f"table: {how}", _dumped(dice, spec).encode(), {"broken.csv": content})


def _by_set(dice: Random, spec: dict[str, Any]) -> Broken:
    count = dice.choice([1, 1, 2, 4])
    overrides = tuple(dice.choice(OVERRIDES)(dice, spec) for _ in range(count))
    return Broken("--set", _text(dice, spec).encode(), overrides=overrides)
