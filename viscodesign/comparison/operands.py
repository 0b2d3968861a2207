"""What can be compared: a folder of a run, a spec, a table; or a run or a scene as an object."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from viscodesign.comparison.measured_motion import measured_motion
from viscodesign.errors import UsageError, did_you_mean
from viscodesign.lazy_dataclass import dataclass
from viscodesign.loading import load
from viscodesign.report.read_run import read_run
from viscodesign.results.findings import violation_codes
from viscodesign.results.run_comparison import ComparedMotion, Origin
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.reading.markers_file import MarkersFile
from viscodesign.scene.reading.read import Overrides
from viscodesign.scene.scene import Scene

SPECS, TABLES = (".yaml", ".yml"), (".csv", ".tsv", ".txt", ".dat")
Operand = str | Path | Trajectory | Scene


@dataclass(frozen=True, eq=False)
class ReadOperand:
    """An operand: its motion, or the scene that is to be simulated for it."""

    source: str
    motion: ComparedMotion | None = None
    scene: Scene | None = None


def read_operands(
    operands: Sequence[Operand], overrides: Overrides = (), markers: MarkersFile | None = None
) -> list[ReadOperand]:
    """Read all of them, before anything is simulated. Raises `ViscodesignError`."""
    _refuse_few(operands)
    _refuse_twice([given for given in operands if isinstance(given, str | Path)])
    return [_read(given, overrides, markers) for given in operands]


def _refuse_few(operands: Sequence[Operand]) -> None:
    if len(operands) < 2:
        what = f"only {operands[0]}" if operands else "nothing"
        raise UsageError(
            f"expected two or more motions to compare, got {what}. Give folders of runs, specs "
            "(.yaml) or measured tables (.csv); the first is the one that others are compared with"
        )


def _refuse_twice(paths: Sequence[str | Path]) -> None:
    counts = Counter(Path(path).resolve() for path in paths)
    for path in paths:
        if counts[Path(path).resolve()] > 1:
            raise UsageError(f"{path} is given twice; a motion does not differ from itself")


def _read(given: Operand, overrides: Overrides, markers: MarkersFile | None) -> ReadOperand:
    if isinstance(given, Trajectory):
        return ReadOperand("", motion_of(given, "run", ""))
    if isinstance(given, Scene):
        return ReadOperand("", scene=given)
    path = Path(given)
    if path.is_dir():
        return ReadOperand(str(path), motion_of(read_run(path), "run", str(path)))
    ending = path.suffix.lower()
    if ending in SPECS and path.exists():
        return ReadOperand(str(path), scene=load(path, overrides))
    if ending in TABLES and path.exists():
        return ReadOperand(str(path), measured_motion(path, markers))
    raise UsageError(_unknown(path))


def _unknown(path: Path) -> str:
    allowed = "expected the folder of a run, a spec (.yaml) or a measured table (.csv)"
    if path.exists():
        return f"{path} is none that can be compared; {allowed}"
    beside = (
        [str(path.with_name(p.name)) for p in path.parent.iterdir()] if path.parent.is_dir() else []
    )
    return f"there is no {path}{did_you_mean(str(path), beside)}; {allowed}"


def motion_of(run: Trajectory, origin: Origin, source: str) -> ComparedMotion:
    """The motion of a run. Raises `UsageError` where it ended before its first output time."""
    if not len(run.time):
        reason = f": {run.failure}" if run.failure else ""
        raise UsageError(
            f"{source or run.name} has no motion to compare; the run {run.status} before its "
            f"first output time{reason}"
        )
    stated = run.accuracy.estimated_tip_error_m
    return ComparedMotion(
        label=run.name,
        origin=origin,
        source=source,
        time=np.asarray(run.time),
        tip=np.asarray(run.tip[:, :2]),
        metrics=run.metrics,
        status=run.status,
        failure=run.failure or "",
        stated_error_m=stated,
        error_words=run.accuracy.method if stated is None else run.error_qualifier,
        period=run.period,
        band=run.uncertainty,
        outside=violation_codes(run.violations),
    )


def with_own_labels(motions: Sequence[ComparedMotion]) -> list[ComparedMotion]:
    """The same with labels of which no two are equal: with their sources, or else numbers."""
    counts = Counter(motion.label for motion in motions)
    named = [replace(m, label=m.source) if counts[m.label] > 1 and m.source else m for m in motions]
    counts, seen, found = Counter(m.label for m in named), Counter[str](), []
    for motion in named:
        seen[motion.label] += 1
        number = f" {seen[motion.label]}" if counts[motion.label] > 1 else ""
        found.append(replace(motion, label=motion.label + number))
    return found
