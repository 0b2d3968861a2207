"""The network by ngspice: pressures as voltages, volumes as charges, one batch run.

The deck is the exact analogue, in SI: 1 V is 1 Pa, 1 A is 1 m3/s; the pulse is the
expression of a behavioural source. Every accepted time point is stored in a binary file,
and read between them by the cubic through values and slopes; the slopes are the
circuit's own, dp/dt from the neighbours' pressures, so that reading costs no accuracy.

A run is a process. What its start costs is measured once in `prepare`, on the same deck
with a first microsecond alone, and told as `overhead_s`: whoever compares time stepping
takes it off, whoever compares ways to an answer leaves it.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import time
from abc import ABC
from collections.abc import Callable
from pathlib import Path
from typing import Any, ClassVar

import network
import numpy as np
from scipy.interpolate import CubicHermiteSpline

STARTS = 5
"""Empty starts, the fastest of which is the overhead."""
EMPTY = 1e-6
"""Simulated time of an empty start [s]."""


def deck(fluid: str, options: str, duration: float, longest: float) -> str:
    """The circuit, run to ``duration`` with steps up to ``longest`` [s]."""
    half, rate = network.DROP / 2, 6 / network.TRANSITION
    pulse = (
        f"{network.START} + {half}*(tanh({rate!r}*(time-{network.RISE_TIME}))"
        f" - tanh({rate!r}*(time-{network.FALL_TIME})))"
    )
    resistance = network.resistance(fluid)
    tanks = [f"C{k} b{k} 0 {network.COMPLIANCE!r}" for k in range(1, network.BELLOWS + 1)]
    tubes = [f"R{k} b{k - 1} b{k} {resistance!r}" for k in range(1, network.BELLOWS + 1)]
    nodes = " ".join(f"v(b{k})" for k in range(network.BELLOWS + 1))
    lines = [
        "chain of bellows",
        f"Bin b0 0 V = {pulse}",
        *tanks,
        *tubes,
        f".options {options}",
        f".save {nodes}",
        f".tran {longest!r} {duration!r} 0 {longest!r}",
        ".end",
    ]
    return "\n".join(lines) + "\n"


def read_raw(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Times (N,) [s] and node pressures (N, 17) [Pa], the inlet's first."""
    content = path.read_bytes()
    head, _, body = content.partition(b"Binary:\n")
    fields = dict(line.split(":", 1) for line in head.decode().splitlines() if ":" in line)
    columns = int(fields["No. Variables"])
    table = np.frombuffer(body, dtype=np.float64).reshape(-1, columns)
    return table[:, 0], table[:, 1:]


class Ngspice(ABC):
    """One integration method of ngspice, down a ladder of tolerances."""

    name: ClassVar[str]
    method: ClassVar[str]

    def __init__(self, case: network.NetworkCase) -> None:
        self.case = case
        self.rates = network.rate_matrix(case.fluid)
        self.overhead_s = float("nan")

    def settings(self) -> list[dict[str, Any]]:
        """Truncation tolerances and longest steps [s], coarse to fine."""
        ladder = [(7.0, 0.12), (7.0, 0.05), (1.0, 0.05), (0.1, 0.05), (0.01, 0.02), (1e-3, 0.02)]
        return [{"trtol": trtol, "longest_step_s": longest} for trtol, longest in ladder]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Write the deck and measure an empty start."""
        program = shutil.which("ngspice")
        if program is None:
            raise FileNotFoundError("ngspice is not installed: apt-get install ngspice")
        # ngspice's default relative tolerance is 1e-3; a current here is about 1e-5 A.
        options = (
            f"method={self.method} trtol={setting['trtol']} reltol={self._reltol(setting)}"
            " abstol=1e-15 vntol=1e-4 chgtol=1e-16"
        )
        longest = setting["longest_step_s"]
        empty = deck(self.case.fluid, options, EMPTY, longest)
        self.overhead_s = min(_timed(program, empty) for _ in range(STARTS))
        text = deck(self.case.fluid, options, network.DURATION, longest)
        return lambda: self._read(*_run(program, text))

    @staticmethod
    def _reltol(setting: dict[str, Any]) -> float:
        """Tightened along with the truncation tolerance, of which it is a factor."""
        return 1e-3 if setting["trtol"] >= 1.0 else 1e-4

    def _read(self, times: np.ndarray, pressure: np.ndarray) -> np.ndarray:
        times, first = np.unique(times, return_index=True)
        inlet, own = pressure[first, 0], pressure[first, 1:]
        a, b = self.rates
        slopes = own @ a.T + inlet[:, None] * b
        return np.asarray(CubicHermiteSpline(times, own, slopes)(self.case.times))


def _run(program: str, text: str) -> tuple[np.ndarray, np.ndarray]:
    """One batch process."""
    with tempfile.TemporaryDirectory() as folder:
        path, raw = Path(folder) / "chain.cir", Path(folder) / "chain.raw"
        path.write_text(text)
        command = [program, "-b", "-n", "-r", str(raw), str(path)]
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
        if done.returncode != 0 or not raw.exists():
            raise RuntimeError(f"ngspice failed: {(done.stdout + done.stderr)[-500:]}")
        return read_raw(raw)


def _timed(program: str, text: str) -> float:
    began = time.perf_counter()
    _run(program, text)
    return time.perf_counter() - began


class Trapezoidal(Ngspice):
    """Trapezoidal rule, ngspice's default."""

    name = "ngspice (trapezoidal)"
    method = "trap"


class Gear(Ngspice):
    """Gear's formulas up to order six."""

    name = "ngspice (Gear)"
    method = "gear maxord=6"
