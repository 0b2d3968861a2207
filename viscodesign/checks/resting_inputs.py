"""Inputs that would move, but not within the run."""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.results.findings import Notice
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.scene import Scene

MOVED_SHARE = 1e-3
"""Part of what an input does in all that it does within a run, below which it rests."""
LONG_AFTER = 1e6
"""Durations of the run after which such an input has done all that it does."""


def resting_notices(scene: Scene) -> Iterator[Notice]:
    """One for every input that a run ends before; those of tables say more of themselves."""
    for name, source in scene.inputs.items():
        if source.covered is None and source.period is None and _rests(source, scene):
            where = "input" if len(scene.inputs) == 1 else f"inputs.{name}"
            yield Notice(
                "input_rests",
                f"it does not move before the run ends at {scene.run.duration:g} s; "
                "use a longer run.duration, or let it begin earlier",
                where,
            )


def _rests(source: Input, scene: Scene) -> bool:
    duration = scene.run.duration
    (low, high), (lowest, highest) = (
        source.extremes(time) for time in (duration, LONG_AFTER * duration)
    )
    return high - low < MOVED_SHARE * (highest - lowest)
