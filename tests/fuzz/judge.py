"""What must hold of any run of any valid spec."""

from __future__ import annotations

import signal
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from tests.hard.case import STIR
from viscodesign import Trajectory, check, load, simulate
from viscodesign.errors import SolveError, SpecError
from viscodesign.report.files import write_run

PATIENCE = 120
"""Wall seconds after which a scene counts as hanging; the work limit is to end it long before."""
SLACK = 0.02
"""Share of the pressures' range by which one may leave it at a rough accuracy."""


class HangError(Exception):
    """A run that did not end."""


@dataclass(frozen=True)
class Verdict:
    """How a scene ended, and what was wrong with that."""

    ending: str
    complaints: tuple[str, ...] = ()
    steps: int = 0


@contextmanager
def patience(seconds: int) -> Iterator[None]:
    """Raise `HangError` inside after a while."""

    def ring(*_: object) -> None:
        raise HangError

    before = signal.signal(signal.SIGALRM, ring)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def judged(spec: dict[str, Any], folder: Path) -> Verdict:
    """Load, check, solve and write a spec as a user would; never raises."""
    file = folder / "spec.yaml"
    file.write_text(yaml.safe_dump(spec), encoding="utf-8")
    try:
        with warnings.catch_warnings(), patience(PATIENCE):
            warnings.simplefilter("error")
            scene = load(file)
            check(scene)
            run = simulate(scene)
            write_run(run, folder / "run", plots=False)
    except SpecError as error:
        return Verdict("refused", tuple(_of_message(str(error))))
    except SolveError as error:
        told = [
            *_of_message(str(error)),
            *([] if error.quantity and error.remedy else ["no remedy"]),
        ]
        return Verdict(f"no start: {error.quantity}", tuple(told))
    except HangError:
        return Verdict("hangs", (f"no end after {PATIENCE} s",))
    except Exception as error:  # whatever else is a finding
        return Verdict("breaks", (f"{type(error).__name__}: {error}",))
    ending = run.status if run.failure is None else f"failed: {run.failure[:40]}"
    return Verdict(ending, tuple(_of_run(run, folder / "run")), run.cost.steps)


def _of_message(message: str) -> Iterator[str]:
    if not message.strip() or "Traceback" in message or ".cpp" in message:
        yield f"unclear message: {message[:200]}"


def _of_run(run: Trajectory, folder: Path) -> Iterator[str]:
    if run.status not in ("complete", "failed") or (run.status == "failed") != bool(run.failure):
        yield f"status {run.status} with the message {run.failure}"
    yield from _of_message(run.failure or "none")
    arrays = {"tip": run.tip, "pressure": run.pressure, "volume": run.volume, "flow": run.flow}
    yield from (f"{name} is not finite" for name, a in arrays.items() if not np.isfinite(a).all())
    if np.any(np.diff(run.time) <= 0):
        yield "times do not ascend"
    volume, error = run.invariants.volume_imbalance_rel, run.accuracy.estimated_tip_error_m
    if run.status == "complete":
        if volume is not None and volume > 1e-8:
            yield f"volume imbalance {volume:.2g}"
        if error is None or not 0 <= error <= run.accuracy.requested_m:
            yield f"complete with an error of {error}"
        yield from _of_pressures(run)
    text = (folder / "trajectory.csv").read_text() + (folder / "shape.csv").read_text()
    if "nan" in text or "inf," in text:
        yield "a table holds what is no number"


def _of_pressures(run: Trajectory) -> Iterator[str]:
    taken = {v.name for v in run.effects if v.taken}
    if STIR & taken or "syringe" in run.spec_text or len(run.time) < 20:
        return
    told = np.concatenate([*run.inlet_pressure.values(), run.pressure[0]])
    low, high = told.min(), told.max()
    # Between the outputs the inlets may go farther than is told.
    slack = (SLACK + 0.3) * (high - low) + 1.0
    if "sine" not in run.spec_text and "square" not in run.spec_text:
        beyond = max(run.pressure.max() - high, low - run.pressure.min())
        if beyond > slack:
            yield f"a pressure leaves the inlets' range by {beyond:.3g} Pa"
