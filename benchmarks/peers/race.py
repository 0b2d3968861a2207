"""viscodesign against other tools: the same motion, measured side by side.

    python benchmarks/peers/race.py                     # every case, then report
    python benchmarks/peers/race.py --case release      # some cases; other lines stay
    python benchmarks/peers/race.py --report            # report what is there

A case is a motion with a reference; a contestant brings a ladder of settings, coarse to
fine. Every setting of every contestant has a process of its own, on one thread, one
after the other: import, prepare, first solution (together the cold time), then further
solutions of which the median is the warm time. The whole field runs several rounds, in
turn, so that a busy minute of the machine meets everyone; the least of the rounds counts.
A tool that is missing, raises, returns NaN or takes too long gets a line that says so.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import platform
import subprocess
import sys
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any, Literal, Protocol

import numpy as np
from machine import cpu, cpu_seconds

HERE = Path(__file__).parent
RESULTS = HERE.parent / "results" / "peers.jsonl"
CASE_MODULES = ("rod", "network", "coupled")
PACKAGES = (
    "casadi",
    "exudyn",
    "fonsim",
    "jax",
    "mujoco",
    "numba",
    "numpy",
    "pyelastica",
    "scipy",
    "soromox",
)
ONE_THREAD = dict.fromkeys(
    ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), "1"
) | {"XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"}
ROUNDS = 1
BUDGET = 20.0
"""Wall time of one contestant in one case and round [s]."""
FEWEST, MOST, PATIENCE = 5, 25, 1.0
"""Warm solutions at least and at most, and how long they are repeated in between [s]."""
DUEL_ERROR = 1e-3
"""Error that the settings have which meet in one process."""
DUEL_PATIENCE = 15.0
"""How long they meet [s]."""
SLOW = 2.0
"""A solution that takes longer [s] is not repeated FEWEST times but twice."""
Record = dict[str, Any]


@dataclass(frozen=True)
class Case(ABC):
    """A motion that everyone solves."""

    name: str
    title: str
    times: np.ndarray
    """(T,) at which values are compared [s]."""
    quantity: str
    """What is compared, for the report."""
    scale: float
    """What an error is divided by."""
    reference_error: float
    """How far the reference may be off, over the scale."""
    norm: Literal["euclid", "max"]
    """Distance of k values at one time: Euclid's, or the largest of them."""
    contestants: list[str]
    """As "module:Class"."""

    @abstractmethod
    def reference(self) -> np.ndarray:
        """The right values (T, k)."""

    def error(self, found: np.ndarray) -> float | None:
        """Largest distance from the reference over the scale; None where values are not finite."""
        right = self.reference()
        if found.shape != right.shape:
            raise ValueError(f"values of shape {found.shape} instead of {right.shape}")
        apart = np.abs(found - right)
        each = np.linalg.norm(apart, axis=1) if self.norm == "euclid" else np.max(apart, axis=1)
        return float(np.max(each)) / self.scale if np.all(np.isfinite(each)) else None


class Contestant(Protocol):
    """One tool on one case; made from the case."""

    name: str

    def settings(self) -> list[dict[str, Any]]:
        """What may be asked of it, coarse to fine, as JSON has it."""
        ...

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """All that comes before time stepping; what is returned solves afresh at each call."""
        ...


def main() -> None:
    """Race, then report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--case", nargs="+", help="names of cases")
    parser.add_argument("--contestant", nargs="+", help="modules or classes, as rod_exudyn")
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    parser.add_argument("--budget", type=float, default=BUDGET, help="of a contestant [s]")
    parser.add_argument("--output", type=Path, default=RESULTS)
    parser.add_argument("--report", action="store_true", help="only report")
    parser.add_argument("--meet", action="store_true", help="only the best settings in turn")
    parser.add_argument("--one", help=argparse.SUPPRESS)
    parser.add_argument("--duel", nargs="*", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.duel is not None:
        say(duel(*given.duel))
        return
    if given.one:
        say(measure(**json.loads(given.one)))
        return
    if not given.report:
        for case in cases():
            if given.case is None or case.name in given.case:
                if not given.meet:
                    run_case(case, given)
                run_duel(case, given.output)
    from report import write_report

    write_report(given.output)


def cases() -> list[Case]:
    """All cases of all modules."""
    return [case for name in CASE_MODULES for case in importlib.import_module(name).CASES]


# -- all rounds of one case ---------------------------------------------------------------


def run_case(case: Case, given: argparse.Namespace) -> None:
    """Every contestant in turn, and again; written down as they come."""
    best: dict[tuple[str, str], Record] = {}
    chosen = [
        c
        for c in case.contestants
        if given.contestant is None or any(c.startswith(k) for k in given.contestant)
    ]
    for _ in range(given.rounds):
        for contestant in chosen:
            for record in climb(case.name, contestant, given.budget):
                key = (contestant, json.dumps(record["setting"]))
                best[key] = better(best.get(key), record)
                print(told(best[key]), flush=True)
            write(given.output, case, chosen, list(best.values()))


def run_duel(case: Case, path: Path) -> None:
    """The cheapest settings that are good enough in turn, in one process; written down."""
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    best: dict[str, Record] = {}
    results = [r for r in lines if r["kind"] == "result" and "warm_s" in r]
    for r in sorted(results, key=lambda r: r["warm_s"]):
        error = r["error_rel"]
        if r["case"] == case.name and error is not None and error <= DUEL_ERROR:
            best.setdefault(r["contestant"], r)
    asked = [json.dumps({k: r[k] for k in ("contestant", "place")}) for r in best.values()]
    done = subprocess.run(
        [sys.executable, __file__, "--duel", case.name, *asked],
        env=os.environ | ONE_THREAD,
        capture_output=True,
        text=True,
        cwd=HERE,
    )
    found = [json.loads(x[len(MARK) :]) for x in done.stdout.splitlines() if x.startswith(MARK)]
    kept = [r for r in lines if r["kind"] != "duel" or r["case"] != case.name]
    new = [{"kind": "duel", "case": case.name} | record for record in found]
    path.write_text("".join(json.dumps(line) + "\n" for line in [*kept, *new]))


def climb(case: str, contestant: str, budget: float) -> Iterator[Record]:
    """Its settings from coarse to fine, until the time is up."""
    began = time.perf_counter()
    place, count = 0, 1
    while place < count:
        left = budget - (time.perf_counter() - began)
        record = in_own_process(case, contestant, place, left)
        count, place = record.pop("count", count), place + 1
        yield record
        if record.get("overran"):
            return


def in_own_process(case: str, contestant: str, place: int, limit: float) -> Record:
    """One setting, or what became of it."""
    asked = json.dumps({"case": case, "contestant": contestant, "place": place})
    record: Record = {"kind": "result", "case": case, "contestant": contestant, "place": place}
    try:
        done = subprocess.run(
            [sys.executable, __file__, "--one", asked],
            env=os.environ | ONE_THREAD,
            capture_output=True,
            text=True,
            timeout=max(limit, 1.0),
            cwd=HERE,
        )
    except subprocess.TimeoutExpired as late:
        record["overran"], text = True, late.stdout or b""
        out, fault = (text.decode() if isinstance(text, bytes) else text), "out of time"
    else:
        out, fault = done.stdout, f"ended by itself: {done.stderr.strip()[-300:]}"
    lines = [line[len(MARK) :] for line in out.splitlines() if line.startswith(MARK)]
    for line in lines:
        record |= json.loads(line)
    if "warm_s" not in record and "failure" not in record:
        record["failure"] = fault
    return {"name": contestant, "setting": {"place": place}} | record


def better(before: Record | None, now: Record) -> Record:
    """The least times of two rounds; what failed once counts only if it always failed."""
    if before is None or "warm_s" not in before:
        return now
    if "warm_s" not in now:
        return before
    times = {k: min(before[k], now[k]) for k in TIMES}
    return now | times | {"rounds": before["rounds"] + now["rounds"]}


def told(record: Record) -> str:
    """One line for whoever watches."""
    head = f"{record['case']:14} {record['name']:34} {json.dumps(record['setting'])}"
    if "warm_s" not in record:
        return f"{head}: {record['failure']}"
    error = "not finite" if record["error_rel"] is None else f"{record['error_rel']:.2e}"
    return f"{head}: error {error}, {1e3 * record['warm_s']:.3g} ms, cold {record['cold_s']:.2g} s"


def write(path: Path, case: Case, chosen: list[str], records: list[Record]) -> None:
    """The header, other lines as they were, and these."""
    old = [json.loads(line) for line in path.read_text().splitlines()] if path.exists() else []
    kept = [
        r
        for r in old
        if r["kind"] != "header" and (r["case"] != case.name or r.get("contestant") not in chosen)
    ]
    about = [r for r in kept if r["kind"] in ("result", "duel")]
    described = {r["case"]: r for r in kept if r["kind"] == "case"} | {case.name: facts(case)}
    lines = [header(), *described.values(), *about, *records]
    path.parent.mkdir(exist_ok=True)
    fresh = path.with_suffix(".part")
    fresh.write_text("".join(json.dumps(line) + "\n" for line in lines))
    fresh.replace(path)


def facts(case: Case) -> Record:
    """What the report says of a case."""
    keys = ("title", "quantity", "scale", "reference_error", "norm")
    return {"kind": "case", "case": case.name} | {key: getattr(case, key) for key in keys}


def header() -> Record:
    """Versions and machine."""
    # As it says of itself: an editable installation's record may be an old one.
    versions = {"viscodesign": importlib.import_module("viscodesign").__version__}
    for name in PACKAGES:
        try:
            versions[name] = metadata.version(name)
        except metadata.PackageNotFoundError:
            versions[name] = "absent"
    return {
        "kind": "header",
        "versions": versions,
        "python": platform.python_version(),
        "cpu": cpu(),
        "threads": 1,
    }


# -- inside the process of one setting -----------------------------------------------------

MARK = "result: "
"""Begins the lines that count; tools print what they like."""
TIMES = ("cold_s", "prepare_s", "first_s", "warm_s")


def measure(case: str, contestant: str, place: int) -> Iterator[Record]:
    """Facts of one setting as they become known."""
    chosen = next(c for c in cases() if c.name == case)
    began = cpu_seconds()
    try:
        module, kind = contestant.split(":")
        tool = getattr(importlib.import_module(module), kind)(chosen)
        ladder = tool.settings()
        yield {"name": tool.name, "count": len(ladder), "setting": ladder[place]}
        preparing = cpu_seconds()
        solve = tool.prepare(ladder[place])
        prepared = cpu_seconds()
        values = solve()
        solved = cpu_seconds()
        error = chosen.error(values)
        warm = repeated(solve, solved - prepared)
    except Exception as fault:  # a tool may raise whatever it likes
        yield {"failure": f"{type(fault).__name__}: {fault}"[:300]}
        return
    yield {
        "cold_s": solved - began,
        "prepare_s": prepared - preparing,
        "first_s": solved - prepared,
        "warm_s": min(warm),
        "solves": len(warm),
        "rounds": 1,
        "error_rel": error,
        # What a program's own start takes, of every solution [s].
        "overhead_s": getattr(tool, "overhead_s", 0.0),
    }


def duel(case: str, *asked: str) -> Iterator[Record]:
    """CPU times of several tools at one setting each, in turn."""
    chosen = next(c for c in cases() if c.name == case)
    solvers: dict[str, Callable[[], np.ndarray]] = {}
    for each in map(json.loads, asked):
        module, kind = each["contestant"].split(":")
        tool = getattr(importlib.import_module(module), kind)(chosen)
        solvers[tool.name] = tool.prepare(tool.settings()[each["place"]])
        solvers[tool.name]()
    spent: dict[str, list[float]] = {name: [] for name in solvers}
    began = time.perf_counter()
    while len(spent[name := next(iter(spent))]) < 3 or (
        time.perf_counter() - began < DUEL_PATIENCE and len(spent[name]) < MOST
    ):
        for name, solve in solvers.items():
            start = cpu_seconds()
            solve()
            spent[name].append(cpu_seconds() - start)
    for name, times in spent.items():
        yield {"name": name, "warm_s": min(times), "solves": len(times)}


def repeated(solve: Callable[[], np.ndarray], first: float) -> list[float]:
    """Times of further solutions [s]."""
    spent: list[float] = []
    fewest = FEWEST if first < SLOW else 2
    while len(spent) < fewest or (sum(spent) < PATIENCE and len(spent) < MOST):
        began = cpu_seconds()
        solve()
        spent.append(cpu_seconds() - began)
    return spent


def say(records: Iterator[Record]) -> None:
    """Hand over to the parent, line by line."""
    for record in records:
        print(MARK + json.dumps(record), flush=True)


if __name__ == "__main__":
    main()
