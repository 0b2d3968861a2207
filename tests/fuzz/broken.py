"""What must come of a damaged spec: a refusal that names the place, or a scene."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from pathlib import Path

from tests.fuzz.breaking import Broken
from tests.fuzz.commands import REFUSED, Said, has_timescales, said
from tests.fuzz.judge import HangError, Verdict, of_refusal, patience
from viscodesign import load
from viscodesign.errors import Fault, SpecError

QUICK = 20
"""Seconds of a processor in which any file is read or refused."""
LONGEST = 2_000
"""Characters of one fault."""
MOST = 60_000
"""Characters of all that is said of one spec."""
FEW_STEPS = "run.max_steps=300"
"""Work for those that turn out to be valid."""


def outcome_of(broken: Broken, *, solve: bool = True) -> Verdict:
    """Read it as the library and as the commands do; never raises."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "spec.yaml"
        file.write_bytes(broken.text)
        for name, content in broken.files.items():
            (Path(folder) / name).write_bytes(content)
        read = _read(broken, file)
        spoken = _spoken(broken, file, read, solve=solve)
    return Verdict(read.ending, (*read.complaints, *spoken))


def _read(broken: Broken, file: Path) -> Verdict:
    try:
        with patience(QUICK):
            load(file, broken.overrides)
    except SpecError as error:
        return Verdict("refused", (*of_refusal(error), *_of_places(error, file)))
    except HangError:
        return Verdict("hangs", (f"not read after {QUICK} s",))
    except Exception as error:  # whatever else is a finding
        return Verdict("breaks", (f"{type(error).__name__}: {error}"[:300],))
    return Verdict("loaded")


def _of_places(error: SpecError, file: Path) -> Iterator[str]:
    """Every fault names its file, and its line where its key stands in the file."""
    if len(str(error)) > MOST:
        yield f"{len(str(error))} characters are said"
    for fault in error.faults:
        if len(str(fault)) > LONGEST:
            yield f"a message of {len(str(fault))} characters: {str(fault)[:80]}"
        if str(file) not in fault.file and not fault.file.startswith("--set"):
            yield f"no file is named: {fault}"
        if fault.line is None and _has_line(fault, file):
            yield f"no line is named: {fault}"


def _has_line(fault: Fault, file: Path) -> bool:
    """Whether the file has a line that begins with the fault's first key."""
    first = fault.key.split(".")[0]
    lines = file.read_bytes().splitlines()
    return (
        bool(first)
        and not fault.file.startswith("--set")
        and any(line.startswith(f"{first}:".encode(errors="replace")) for line in lines)
    )


def _spoken(broken: Broken, file: Path, read: Verdict, *, solve: bool) -> Iterator[str]:
    """Through the commands: the same faults, as one message and an exit code."""
    if any("\x00" in word for word in broken.overrides):
        return  # no shell hands such a word on
    overrides = [word for o in broken.overrides for word in ("--set", o)]
    answer = said(["check", str(file), *overrides])
    yield from answer.complaints(["check", *broken.overrides])
    if (answer.code == REFUSED) < (read.ending == "refused"):
        yield f"'check' exits with {answer.code} for a spec that is refused"
    if read.ending != "loaded":
        return
    placed = said(["classify", str(file), *overrides, "--json"])
    yield from placed.complaints(["classify", *broken.overrides])
    if (placed.code == 0) != has_timescales(file, broken.overrides):
        yield f"'classify' exits with {placed.code}, 'check' with {answer.code}: {answer.err[:200]}"
    if solve:
        run = ["simulate", str(file), *overrides, "--set", FEW_STEPS, "--no-plots", "-q"]
        yield from _of_simulation(said([*run, "-o", str(file.parent / "run")]), answer)


def _of_simulation(solved: Said, checked: Said) -> Iterator[str]:
    yield from solved.complaints(["simulate"])
    if (solved.code == REFUSED) != (checked.code == REFUSED):
        codes = f"{solved.code}, 'check' with {checked.code}"
        yield f"'simulate' exits with {codes}: {(solved.err + checked.err)[:200]}"
