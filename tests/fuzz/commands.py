"""The same specs through the command line: exit codes, JSON documents and messages."""

from __future__ import annotations

import contextlib
import io
import signal
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from tests.fuzz.invariants import (
    CPU_LIMIT_S,
    TimeLimitError,
    Verdict,
    cpu_time_limit,
    message_problems,
    strict_json,
    written,
)
from tests.fuzz.scenes import Draft
from viscodesign import Trajectory, load, simulate
from viscodesign.checks.refusals import refuse_beyond_numbers
from viscodesign.cli.main import INTERNAL_ERROR, main
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities

REFUSED, FAILED = 2, 3


@dataclass(frozen=True)
class CommandOutcome:
    """Outcome of a command."""

    code: int
    out: str
    err: str

    def problems(self, words: Sequence[str]) -> Iterator[str]:
        """Problems of the outcome of any command."""
        shown = f"'{' '.join(words)[:120]}'"
        if self.code not in (0, REFUSED, FAILED):
            yield f"{shown} exits with {self.code}: {self.err[:300]}"
        if self.code and not self.err.strip():
            yield f"{shown} exits with {self.code} without a message"
        if self.code:
            yield from (f"{shown}: {c}" for c in message_problems(self.err))


def run_command(words: Sequence[str]) -> CommandOutcome:
    """Run a command in this process."""
    out, err = io.StringIO(), io.StringIO()
    with (
        warnings.catch_warnings(),
        contextlib.redirect_stdout(out),
        contextlib.redirect_stderr(err),
    ):
        warnings.simplefilter("error")
        before = signal.getsignal(signal.SIGINT)
        try:
            with cpu_time_limit(CPU_LIMIT_S):
                code = main(words)
        except TimeLimitError:
            return CommandOutcome(INTERNAL_ERROR, out.getvalue(), f"no end after {CPU_LIMIT_S} s")
        finally:
            signal.signal(signal.SIGINT, before)
    return CommandOutcome(code, out.getvalue(), err.getvalue())


def has_timescales(file: Path, overrides: Sequence[str] = ()) -> bool:
    """Whether the timescales are finite, so that `classify` succeeds even for an ill-posed scene."""
    try:
        refuse_beyond_numbers(SceneQuantities(load(file, overrides)))
    except SpecError:
        return False
    return True


def check_commands(draft: Draft, folder: Path, first: Verdict) -> Verdict:
    """The first verdict with the problems of the commands and the resolved spec."""
    found = list(_command_problems(draft, folder, first))
    if first.run is not None and not first.problems:
        found += _again(folder / "run" / "spec.yaml", first.run)
    numbers = {**first.numbers, "commands compared": 1.0}
    return replace(first, problems=(*first.problems, *found), numbers=numbers)


def _command_problems(draft: Draft, folder: Path, first: Verdict) -> Iterator[str]:
    file = str(written(draft, folder))
    ran = {"complete": 0, "refused": REFUSED}.get(first.ending, FAILED)
    weighed = REFUSED if ran == REFUSED else 0
    placed = 0 if has_timescales(Path(file)) else REFUSED
    lines = {
        ("simulate", file, "-o", str(folder / "cli"), "--no-plots", "--json", "-q"): ran,
        ("check", file, "--json"): weighed,
        ("check", file): weighed,
        ("classify", file, "--json"): placed,
    }
    for words, wanted in lines.items():
        answer = run_command(words)
        yield from answer.problems(words)
        if answer.code != wanted:
            yield f"'{words[0]}' exits with {answer.code} instead of {wanted}: {answer.err[:200]}"
        if "--json" in words and answer.code != REFUSED and answer.out:
            strict_json(answer.out)


def _again(resolved: Path, first: Trajectory) -> Iterator[str]:
    """The resolved spec must give the same numbers to the last digit."""
    again = simulate(load(resolved))
    if again.status != first.status:
        yield f"spec.yaml, run again, ends {again.status}: {again.failure}"
    elif not (
        np.array_equal(again.tip, first.tip) and np.array_equal(again.pressure, first.pressure)
    ):
        size = (
            float(np.max(np.abs(again.tip - first.tip))) if len(again.tip) == len(first.tip) else 0
        )
        yield f"spec.yaml, run again, gives other numbers (tip distance {size:.3g})"
