"""Specs with damaged keys, values, text, bytes or tables."""

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
    """A file that may be invalid, its tables and overrides."""

    how: str
    text: bytes
    files: dict[str, bytes] = field(default_factory=dict)
    overrides: tuple[str, ...] = ()


Way = Callable[[Random, dict[str, Any]], Broken]


def broken_spec(rng: Random) -> Broken:
    """A valid spec with one or a few damages."""
    scene = draft(rng)
    files = {name: text.encode() for name, text in scene.files.items()}
    way = rng.choice([_in_values, _in_values, _in_text, _in_text, _in_bytes, _in_tables, _by_set])
    return (
        replace(way(rng, scene.spec), files=files)
        if way is not _in_tables
        else (_in_tables(rng, scene.spec))
    )


def _dumped(rng: Random, spec: dict[str, Any]) -> str:
    flow = rng.choice([None, None, False])
    return yaml.safe_dump(spec, sort_keys=False, default_flow_style=flow, width=100)


def _text(rng: Random, spec: dict[str, Any]) -> str:
    """The spec as YAML, or one of the bundled ones with their comments and units."""
    if rng.random() < 0.4:
        return (CONFIGS / rng.choice(BUNDLED)).read_text(encoding="utf-8")
    return _dumped(rng, spec)


def _in_values(rng: Random, spec: dict[str, Any]) -> Broken:
    whole = yaml.safe_load(_text(rng, spec))
    told = []
    for _ in range(rng.choice([1, 1, 1, 2, 5])):
        damage = rng.choice(TREE_DAMAGES)
        told.append(damage.__name__.strip("_"))
        damage(rng, whole)
    return Broken(" + ".join(told), _dump_any(whole))


def _dump_any(whole: Any) -> bytes:
    """YAML of a damaged mapping, whatever it contains."""
    return yaml.dump(whole, Dumper=_Plain, sort_keys=False, allow_unicode=True).encode(
        "utf-8", errors="surrogatepass"
    )


class _Plain(yaml.SafeDumper):
    """Writes repeated objects in full, without aliases."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def _in_text(rng: Random, spec: dict[str, Any]) -> Broken:
    text, told = _text(rng, spec), []
    for _ in range(rng.choice([1, 1, 2, 4])):
        damage = rng.choice(TEXT_DAMAGES)
        told.append(damage.__name__.strip("_"))
        text = damage(rng, text)
    return Broken(" + ".join(told), text.encode("utf-8", errors="surrogatepass"))


def _in_bytes(rng: Random, spec: dict[str, Any]) -> Broken:
    damage = rng.choice(BYTE_DAMAGES)
    return Broken(damage.__name__.strip("_"), damage(rng, _text(rng, spec)))


def _in_tables(rng: Random, spec: dict[str, Any]) -> Broken:
    spec = copy.deepcopy(spec)
    how, content = damaged_table(rng, spec)
    return Broken(f"table: {how}", _dumped(rng, spec).encode(), {"broken.csv": content})


def _by_set(rng: Random, spec: dict[str, Any]) -> Broken:
    count = rng.choice([1, 1, 2, 4])
    overrides = tuple(rng.choice(OVERRIDES)(rng, spec) for _ in range(count))
    return Broken("--set", _text(rng, spec).encode(), overrides=overrides)
