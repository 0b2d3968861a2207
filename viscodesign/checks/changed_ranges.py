"""The usual ranges of body and bellows, for what single sections and bellows have instead."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from viscodesign.checks.plausible_ranges import RANGES, PlausibleRange
from viscodesign.scene.bellow_changes import BellowChange
from viscodesign.scene.sections import SectionChange


def _changed_ranges() -> Iterator[PlausibleRange]:
    for usual, place, change in (
        ("actuator.", "sections.*", SectionChange),
        ("bellows.", "bellows.changes.*", BellowChange),
    ):
        for found in RANGES:
            name = found.key.removeprefix(usual)
            if found.key.startswith(usual) and name in change.model_fields:
                yield replace(found, key=f"{place}.{name}")


CHANGED_RANGES = tuple(_changed_ranges())
