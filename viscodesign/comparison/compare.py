"""Motions in one picture and one table: `compare`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from viscodesign._version import __version__
from viscodesign.comparison.differences import tip_difference_of
from viscodesign.comparison.measured_motion import tip_metrics
from viscodesign.comparison.operands import (
    Operand,
    ReadOperand,
    motion_of,
    read_operands,
    with_own_labels,
)
from viscodesign.comparison.simulated_operands import Progress, SimulatedRun, runs_of
from viscodesign.results.loop_part import LoopPart
from viscodesign.results.run_comparison import (
    ComparedMotion,
    Comparison,
    ComparisonInterruptedError,
)
from viscodesign.scene.reading.markers_file import MarkersFile, read_markers
from viscodesign.scene.reading.read import Overrides
from viscodesign.scene.reading.sources import SpecSource
from viscodesign.scene.scene import Scene


def compare(
    *operands: Operand,
    overrides: Overrides = (),
    period: float | None = None,
    markers: SpecSource | MarkersFile | None = None,
    verify: bool = True,
    folder: str | Path | None = None,
    progress: Progress | None = None,
) -> Comparison:
    """Compare motions with the first of them.

    ``operands``: folders of runs, specs (simulated first), tables with times and the tip's x and
    z; or trajectories and scenes. ``overrides``: of all specs, as `load` takes them. ``period``
    [s]: of tables, by default that of the first cyclic motion. ``markers``: of tables in space, a
    file or a mapping with the clamp's markers and the tip's. ``verify``: whether errors of
    specs are estimated. ``folder``: where runs of specs are kept; those of the same spec that
    are there already are read. ``progress`` is called with the fraction done.

    Raises `ViscodesignError` for what cannot be compared. Ctrl-C raises
    `ComparisonInterruptedError`, a `KeyboardInterrupt` that holds the comparison of what there is.
    """
    places = None if markers is None else read_markers(markers)
    read = read_operands(operands, overrides, places)
    gathered = _Gathered()
    try:
        gathered.fill(read, runs_of(_scenes(read), _path(folder), verify=verify, progress=progress))
    except KeyboardInterrupt:
        gathered.stop(read)
    motions = [motion for motion in gathered.motions if motion is not None]
    if gathered.missing and len(motions) < 2:
        raise ComparisonInterruptedError(None)
    found = compared(motions, period, gathered.notes, tuple(gathered.missing))
    if gathered.missing:
        raise ComparisonInterruptedError(found)
    return found


class _Gathered:
    """Motions of operands, in their order, as they come."""

    def __init__(self) -> None:
        self.motions: list[ComparedMotion | None] = []
        self.notes: list[str] = []
        self.missing: list[str] = []
        """What an interrupt left out."""

    def fill(self, read: Sequence[ReadOperand], runs: Iterator[SimulatedRun]) -> None:
        """Take the motions that are there, and then those of the runs one by one."""
        self.motions = [operand.motion for operand in read]
        for k, operand in enumerate(read):
            if operand.scene is None:
                continue
            if (found := next(runs, None)) is None:
                self.missing.append(operand.source or operand.scene.name)
                continue
            self._take(k, operand, found)

    def _take(self, k: int, operand: ReadOperand, found: SimulatedRun) -> None:
        if found.was_kept:
            self.notes.append(f"{operand.source}: the run of this spec in {found.folder} was read")
        if found.run.status == "interrupted":
            end = f" after {found.run.time[-1]:.4g} s" if len(found.run.time) else ""
            self.missing.append(f"{operand.source or found.run.name}{end}")
        if found.run.status != "interrupted" or len(found.run.time):
            self.motions[k] = motion_of(found.run, "spec", operand.source)

    def stop(self, read: Sequence[ReadOperand]) -> None:
        """Note which specs have no run."""
        left = [r for r, m in zip(read, self.motions, strict=False) if m is None]
        names = [r.source or r.scene.name for r in left if r.scene is not None]
        self.missing = [*self.missing, *(name for name in names if name not in self.missing)]


def _scenes(read: Sequence[ReadOperand]) -> list[Scene]:
    return [operand.scene for operand in read if operand.scene is not None]


def _path(folder: str | Path | None) -> Path | None:
    return None if folder is None else Path(folder)


def compared(
    motions: Sequence[ComparedMotion],
    period: float | None = None,
    notes: Sequence[str] = (),
    missing: tuple[str, ...] = (),
) -> Comparison:
    """The comparison of motions that are there."""
    cyclic, more = _with_period(with_own_labels(motions), period)
    return Comparison(
        motions=tuple(cyclic),
        differences=tuple(tip_difference_of(cyclic[0], other) for other in cyclic[1:]),
        version=__version__,
        missing=missing,
        notes=(*notes, *(f"{m.label}: {m.note}" for m in cyclic if m.note), *more),
    )


def _with_period(
    motions: Sequence[ComparedMotion], period: float | None
) -> tuple[list[ComparedMotion], list[str]]:
    """The same, with a period for tables that last as long; and what was assumed."""
    known = next((m for m in motions if m.period is not None), None)
    length = period if period is not None or known is None else known.period
    found, notes = [], []
    for motion in motions:
        if motion.origin != "table" or length is None:
            found.append(motion)
        elif not LoopPart.of(motion.time, length).is_period:
            found.append(motion)
            notes.append(f"{motion.label} is shorter than a period of {length:g} s: not cyclic")
        else:
            found.append(_cyclic(motion, length))
            if period is None and known is not None:
                notes.append(
                    f"{motion.label} is taken to have the period of {known.label}, {length:g} s"
                )
    return found, notes


def _cyclic(motion: ComparedMotion, period: float) -> ComparedMotion:
    """A table as a cyclic motion; its loop is the last period."""
    return replace(motion, period=period, metrics=tip_metrics(motion.time, motion.tip, period))
