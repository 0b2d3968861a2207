"""The ranges of body and bellows, for what single sections and bellows have instead."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from viscodesign.checks.plausible_ranges import PlausibleRange
from viscodesign.scene.bellow_changes import BellowChange
from viscodesign.scene.sections import SectionChange
from viscodesign.scene.spec_part import SpecPart

CHANGES: dict[str, tuple[str, type[SpecPart]]] = {
    "actuator": ("sections.*", SectionChange),
    "bellows": ("bellows.changes.*", BellowChange),
}
"""By the section that all share: where single ones have their own, and the keys there."""


def with_changes(ranges: Iterable[PlausibleRange]) -> Iterator[PlausibleRange]:
    """Ranges, each followed by the same one for what takes the number's place."""
    for found in ranges:
        yield found
        part, _, name = found.key.partition(".")
        if part in CHANGES and name in CHANGES[part][1].model_fields:
            place, _ = CHANGES[part]
            yield replace(found, key=f"{place}.{name}")
