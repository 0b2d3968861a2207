"""A damaged spec must give a refusal that names the location, or a scene."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.fuzz.broken_specs import Broken
from tests.fuzz.commands import REFUSED, CommandOutcome, has_timescales, run_command
from tests.fuzz.invariants import TimeLimitError, Verdict, cpu_time_limit, refusal_problems
from viscodesign import load
from viscodesign.errors import Fault, SpecError

READ_LIMIT_S = 20
"""CPU seconds within which any file must be read or refused."""
LONGEST = 2_000
"""Maximum characters of one fault."""
MOST = 60_000
"""Maximum characters of all messages about one spec."""
FEW_STEPS = "run.max_steps=300"
"""Step limit for specs that turn out to be valid."""


def outcome_of(broken: Broken, *, solve: bool = True) -> Verdict:
    """Read a spec by the library and by the commands; never raises."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "spec.yaml"
        file.write_bytes(broken.text)
        for name, content in broken.files.items():
            (Path(folder) / name).write_bytes(content)
        read = _read(broken, file)
        spoken = _message_problems(broken, file, read, solve=solve)
    return Verdict(read.ending, (*read.problems, *spoken))


def _read(broken: Broken, file: Path) -> Verdict:
    try:
        with cpu_time_limit(READ_LIMIT_S):
            load(file, broken.overrides)
    except SpecError as error:
        return Verdict("refused", (*refusal_problems(error), *_location_problems(error, file)))
    except TimeLimitError:
        return Verdict("hangs", (f"not read after {READ_LIMIT_S} s",))
    except Exception as error:  # whatever else is a finding
        return Verdict("breaks", (f"{type(error).__name__}: {error}"[:300],))
    return Verdict("loaded")


def _location_problems(error: SpecError, file: Path) -> Iterator[str]:
    """Every fault must name its file, and its line if its key is in the file."""
    if len(str(error)) > MOST:
        yield f"{len(str(error))} characters in all messages"
    for fault in error.faults:
        if len(str(fault)) > LONGEST:
            yield f"a message of {len(str(fault))} characters: {str(fault)[:80]}"
        if str(file) not in fault.file and not fault.file.startswith("--set"):
            yield f"no file in message: {fault}"
        if fault.line is None and _has_line(fault, file):
            yield f"no line in message: {fault}"


def _has_line(fault: Fault, file: Path) -> bool:
    """Whether the file has a line that begins with the fault's first key."""
    first = fault.key.split(".")[0]
    lines = file.read_bytes().splitlines()
    return (
        bool(first)
        and not fault.file.startswith("--set")
        and any(line.startswith(f"{first}:".encode(errors="replace")) for line in lines)
    )


def _message_problems(broken: Broken, file: Path, read: Verdict, *, solve: bool) -> Iterator[str]:
    """The commands must report the same faults as one message and an exit code."""
    if any("\x00" in word for word in broken.overrides):
        return  # no shell hands such a word on
    overrides = [word for o in broken.overrides for word in ("--set", o)]
    answer = run_command(["check", str(file), *overrides])
    yield from answer.problems(["check", *broken.overrides])
    if (answer.code == REFUSED) < (read.ending == "refused"):
        yield f"'check' exits with {answer.code} for an invalid spec"
    if read.ending != "loaded":
        return
    placed = run_command(["classify", str(file), *overrides, "--json"])
    yield from placed.problems(["classify", *broken.overrides])
    if (placed.code == 0) != has_timescales(file, broken.overrides):
        yield f"'classify' exits with {placed.code}, 'check' with {answer.code}: {answer.err[:200]}"
    if solve:
        run = ["simulate", str(file), *overrides, "--set", FEW_STEPS, "--no-plots", "-q"]
        yield from _simulation_problems(run_command([*run, "-o", str(file.parent / "run")]), answer)


def _simulation_problems(solved: CommandOutcome, checked: CommandOutcome) -> Iterator[str]:
    yield from solved.problems(["simulate"])
    if (solved.code == REFUSED) != (checked.code == REFUSED):
        codes = f"{solved.code}, 'check' with {checked.code}"
        yield f"'simulate' exits with {codes}: {(solved.err + checked.err)[:200]}"
