"""Invariants of any run of any valid spec."""

from __future__ import annotations

import csv
import json
import math
import signal
import traceback
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import yaml

from tests.fuzz.scenes import Draft
from tests.hard.case import STIR, VOLUME
from viscodesign import Scene, Trajectory, check, load, simulate
from viscodesign.errors import SolveError, SpecError
from viscodesign.postprocess.terminations import LIMITS
from viscodesign.report.run_folder import write_run

CPU_LIMIT_S = 60
"""CPU seconds after which a scene counts as hanging; the step limit should end it long before.
Not wall time, since the machine may be busy."""
SLACK = 0.02
"""Fraction of the inlets' pressure range by which a pressure may exceed it, since the accuracy is
that of the tip and may be coarse."""
MOST_CORNERS = 2000
MOST_STRETCHED = 3.0
"""Length of an actuator relative to that at rest."""
WORDS_OF_PROGRAMS = ("Traceback", ".cpp", "internal error", "NoneType", "casadi", "pydantic")
"""Words that no message for a user contains."""


class TimeLimitError(Exception):
    """A run exceeded its CPU time."""


@dataclass(frozen=True)
class Verdict:
    """How a scene ended, and the problems found."""

    ending: str
    problems: tuple[str, ...] = ()
    steps: int = 0
    numbers: dict[str, float] = field(default_factory=dict)
    """Numbers for the summary table."""
    run: Trajectory | None = None


@contextmanager
def cpu_time_limit(seconds: int) -> Iterator[None]:
    """Raise `TimeLimitError` in the block after so many seconds of CPU time."""

    def ring(*_: object) -> None:
        raise TimeLimitError

    before = signal.signal(signal.SIGPROF, ring)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)


def check_scene(draft: Draft, folder: Path) -> Verdict:
    """Load, check, solve and write a spec as a user would; never raises."""
    try:
        with warnings.catch_warnings(), cpu_time_limit(CPU_LIMIT_S):
            warnings.simplefilter("error")
            scene = load(written(draft, folder))
            check(scene)
            run = simulate(scene)
            write_run(run, folder / "run", plots=False)
            problems = tuple(_run_problems(scene, run, folder / "run"))
    except SpecError as error:
        return Verdict("refused", tuple(refusal_problems(error)))
    except SolveError as error:
        silent = () if error.quantity and error.remedy else ("no remedy",)
        return Verdict(f"no start: {error.quantity}", (*message_problems(str(error)), *silent))
    except TimeLimitError:
        return Verdict("hangs", (f"no end after {CPU_LIMIT_S} s",))
    except Exception as error:  # whatever else is a finding
        place = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{Path(place.filename).name}:{place.lineno}"
        return Verdict("breaks", (f"{type(error).__name__} in {where}: {error}",))
    return Verdict(_ending(run), problems, run.cost.steps, _numbers(run), run)


def written(draft: Draft, folder: Path) -> Path:
    """The path of the spec, written with its tables."""
    folder.mkdir(exist_ok=True)
    for name, text in draft.files.items():
        (folder / name).write_text(text, encoding="utf-8")
    file = folder / "spec.yaml"
    file.write_text(yaml.safe_dump(draft.spec, sort_keys=False), encoding="utf-8")
    return file


def message_problems(message: str) -> Iterator[str]:
    """Messages that are not fit for a user."""
    if not message.strip() or any(word in message for word in WORDS_OF_PROGRAMS):
        yield f"unclear message: {message[:300]!r}"


def refusal_problems(error: SpecError) -> Iterator[str]:
    """A refusal must have faults, each with a message."""
    if not error.faults:
        yield "refused without a fault"
    for fault in error.faults:
        yield from message_problems(fault.message)


def _ending(run: Trajectory) -> str:
    if run.failure is None:
        return run.status
    words = "".join(c for c in run.failure if not c.isdigit())
    return f"failed: {words[:40]}" if "the limit of" not in words else "failed: the limit of steps"


def _numbers(run: Trajectory) -> dict[str, float]:
    energy = run.invariants.energy_imbalance_rel
    return {"energy": energy} if energy is not None and run.status == "complete" else {}


def _run_problems(scene: Scene, run: Trajectory, folder: Path) -> Iterator[str]:
    if run.status not in ("complete", "failed") or (run.status == "failed") != bool(run.failure):
        yield f"status {run.status} with the message {run.failure}"
    yield from message_problems(run.failure or "none")
    yield from (c for notice in run.warnings for c in message_problems(notice.message))
    arrays = {
        "tip": run.tip, "pressure": run.pressure, "volume": run.volume,
        "flow": run.flow, "shape": run.shape, "time": run.time,
    }  # fmt: skip
    yield from (f"{name} is not finite" for name, a in arrays.items() if not np.isfinite(a).all())
    if np.any(np.diff(run.time) <= 0):
        yield "times do not ascend"
    if run.status == "complete":
        yield from _time_problems(scene, run)
        yield from _balance_problems(run)
        yield from _pressure_problems(scene, run)
    yield from _file_problems(run, folder)


def _time_problems(scene: Scene, run: Trajectory) -> Iterator[str]:
    told = scene.run.output_times_array()
    if len(told) != len(run.time) or not np.allclose(told, run.time, rtol=1e-9, atol=0.0):
        yield f"complete with {len(run.time)} times instead of {len(told)}, or with other times"


def _balance_problems(run: Trajectory) -> Iterator[str]:
    volume, energy = run.invariants.volume_imbalance_rel, run.invariants.energy_imbalance_rel
    error = run.accuracy.estimated_tip_error_m
    if volume is not None and not volume <= VOLUME:
        yield f"volume imbalance {volume:.2g}"
    if energy is not None and not 0 <= energy <= LIMITS.energy_imbalance:
        yield f"energy imbalance {energy:.2g}"
    doubted = any(notice.code == "energy_imbalance" for notice in run.warnings)
    if energy is not None and energy > LIMITS.energy_doubtful and not doubted:
        yield f"energy imbalance {energy:.2g} without a warning"
    if error is None or not 0 <= error <= run.accuracy.requested_m:
        yield f"complete with an error of {error}"


def _pressure_problems(scene: Scene, run: Trajectory) -> Iterator[str]:
    """Without feedback and inertance, pressures stay within the range of the inlets."""
    taken = {v.name for v in run.effects if v.taken}
    sources = list(scene.inputs.values())
    if STIR & taken or not all(source.gives_pressure for source in sources):
        return
    duration = scene.run.duration
    corners = [t for s in sources for t in s.corners(duration)][:MOST_CORNERS]
    times = np.unique([*np.linspace(0.0, duration, 5000), *corners])
    told = [scene.gauge_pressure + source.values(times) for source in sources]
    before = [scene.gauge_pressure] if scene.run.start == "rest" else []
    jumps = [[scene.gauge_pressure + s.values(np.zeros(1))[0] for s in sources]]
    history = np.concatenate([*told, *jumps, run.pressure[0], before, *run.inlet_pressure.values()])
    low, high = float(history.min()), float(history.max())
    beyond = max(float(run.pressure.max()) - high, low - float(run.pressure.min()), 0.0)
    if beyond - _head(scene, taken) > SLACK * (high - low) + 1e-6 * max(abs(low), abs(high)) + 1e-6:
        yield f"a pressure exceeds the inlets' range of {high - low:.3g} Pa by {beyond:.3g} Pa"


def _head(scene: Scene, taken: set[str]) -> float:
    """Hydrostatic pressure difference between the ends of the actuator [Pa]."""
    gravity = scene.loads.gravity
    if gravity is None or "fluid_mass" not in taken:
        return 0.0
    return MOST_STRETCHED * scene.fluid.density * gravity.acceleration * scene.actuator.length


def _file_problems(run: Trajectory, folder: Path) -> Iterator[str]:
    for name, rows in (("trajectory.csv", len(run.time)), ("shape.csv", None)):
        with (folder / name).open(newline="") as file:
            header, *lines = list(csv.reader(file))
        if rows is not None and len(lines) != rows:
            yield f"{name} has {len(lines)} rows instead of {rows}"
        if any(len(line) != len(header) for line in lines):
            yield f"{name} has rows whose length differs from the header"
        elif not all(math.isfinite(float(cell)) for line in lines for cell in line):
            yield f"{name} contains text that is not a number"
    summary = strict_json((folder / "summary.json").read_text(encoding="utf-8"))
    if not isinstance(summary, dict) or summary["status"] != run.status:
        yield "summary.json does not tell the run's status"


def strict_json(text: str) -> object:
    """Parse JSON strictly, without the NaN and Infinity that Python accepts."""

    def refuse(word: str) -> float:
        raise ValueError(f"{word} in a JSON document")

    return json.loads(text, parse_constant=refuse)
