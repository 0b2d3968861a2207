"""What a fit found: numbers with their intervals, and what cannot be told apart.

Plain data. Nothing here knows how a number was computed; `report` draws it, the command line
prints it, and a script reads it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import json_ready
from viscodesign.results.mismatch import Mismatch
from viscodesign.results.notebook_view import NotebookView
from viscodesign.results.provenance import provenance

RunStatus = Literal["complete", "unfinished", "interrupted", "mismatch"]
"""Mismatch: the fit is done, and its model does not describe the recordings."""
WhyUnknown = Literal["", "no_end", "too_wide", "edge_of_range", "mismatch"]
"""Why a number does not count as identified: the data set no end to its interval; its half width is
above half of it; it is at the edge of the range that was searched; the model does not describe the
recordings. "" for one that is identified."""
Edge = Literal["", "low", "high"]


@dataclass(frozen=True)
class FittedNumber:
    """A number of the spec, as the data have it."""

    key: str
    value: float
    """[unit]"""
    unit: str
    start: float
    """In the spec [unit]."""
    low: float | None
    high: float | None
    """Ends of the interval that holds it with 95 % [unit]; None where the data set no end."""
    why_unknown: WhyUnknown = ""
    edge: Edge = ""
    """Edge of the range that was searched, where the value lies on one."""

    @property
    def is_identified(self) -> bool:
        """Whether the data determine it: its interval is narrow, and the model describes them."""
        return not self.why_unknown

    @property
    def half_width(self) -> float | None:
        """Half the interval, as a part of the value; None where it is open."""
        if self.low is None or self.high is None:
            return None
        return (self.high - self.low) / 2 / abs(self.value)

    def document(self) -> dict[str, Any]:
        """The number for a program."""
        return {
            "key": self.key,
            "value": self.value,
            "unit": self.unit,
            "low_95": self.low,
            "high_95": self.high,
            "identified": self.is_identified,
            "reason": self.why_unknown or None,
            "edge": self.edge or None,
            "start": self.start,
        }


@dataclass(frozen=True)
class FittedProduct:
    """A product of powers of numbers that the data determine, though not its factors."""

    powers: tuple[tuple[str, float], ...]
    """Keys with their powers."""
    value: float
    """In SI."""
    low: float
    high: float

    @property
    def formula(self) -> str:
        """Such as ``fluid.viscosity * network.tube_radius^-4``."""
        return " * ".join(key if power == 1 else f"{key}^{power:g}" for key, power in self.powers)

    def document(self) -> dict[str, Any]:
        """The product for a program."""
        return {
            "keys": [key for key, _ in self.powers],
            "powers": [power for _, power in self.powers],
            "formula": self.formula,
            "value": self.value,
            "low_95": self.low,
            "high_95": self.high,
        }


@dataclass(frozen=True, eq=False)
class FittedRun:
    """A recording, and what the fitted numbers make of it."""

    file: str
    overrides: tuple[str, ...]
    time: np.ndarray
    """(T,) [s]"""
    headers: tuple[str, ...]
    """(C,) Of the columns that were compared."""
    units: tuple[str, ...]
    """(C,)"""
    measured: np.ndarray
    """(T, C) NaN where nothing was measured."""
    expected: np.ndarray
    """(T, C)"""
    kept: np.ndarray
    """(T, C) Whether a sample counted: it was measured, and is not gross."""
    noise: np.ndarray
    """(C,) Standard deviation that was found."""
    clock_offset_s: float
    """By how much its clock is late."""
    clock_deviation_s: float | None
    """Standard deviation of that; None where the clocks agree, and the offset is taken to be 0."""
    driven_by: tuple[str, ...]
    """In words, inlet by inlet."""

    @property
    def residuals(self) -> np.ndarray:
        """(T, C) Measured minus expected, in standard deviations of the noise."""
        return np.asarray((self.measured - self.expected) / self.noise)

    @property
    def missing(self) -> int:
        """Samples that were not measured."""
        return int(np.isnan(self.measured).sum())

    @property
    def gross(self) -> int:
        """Samples that were left out as grossly wrong."""
        return int((np.isfinite(self.measured) & ~self.kept).sum())

    def document(self) -> dict[str, Any]:
        """The recording for a program."""
        noise = dict(zip(self.headers, self.noise.tolist(), strict=True))
        return {
            "file": self.file,
            "overrides": list(self.overrides),
            "samples": int(self.kept.sum()),
            "missing": self.missing,
            "gross": self.gross,
            "noise": noise,
            "clock_offset_s": self.clock_offset_s,
            "clock_offset_sd_s": self.clock_deviation_s,
            "driven_by": list(self.driven_by),
        }


@dataclass(frozen=True)
class Experiment:
    """A more informative experiment, and what it would add."""

    words: str
    overrides: tuple[str, ...]
    """Keys of the spec that it changes."""
    sensors: tuple[str, ...]
    """What is measured beside what was."""
    half_widths: Mapping[str, float]
    """Expected half width of every number's interval, relative to its value, with all data."""

    def document(self) -> dict[str, Any]:
        """The experiment for a program."""
        return {
            "words": self.words,
            "set": list(self.overrides),
            "sensors": list(self.sensors),
            "expected_half_widths": dict(self.half_widths),
        }


@dataclass(frozen=True, eq=False)
class Fit(NotebookView):
    """The numbers of a spec by measurements."""

    name: str
    version: str
    spec_sha256: str
    status: RunStatus
    numbers: tuple[FittedNumber, ...]
    products: tuple[FittedProduct, ...]
    runs: tuple[FittedRun, ...]
    chi2_per_dof: float
    """Mean square of what is left over that of its noise: above 1 where it follows a pattern."""
    effects: frozenset[str]
    mesh: Mapping[str, Any]
    """How finely the model was solved, and by how much a finer solution would move a number."""
    spec: str
    """The spec with the fitted numbers, as text: `load` reads it."""
    resolved_sha256: str = ""
    left_out: tuple[tuple[str, str], ...] = ()
    """Keys that were not asked for by name and cannot be free, and why."""
    warnings: tuple[str, ...] = ()
    """What casts doubt on the numbers, a sentence each."""
    mismatch: Mismatch | None = None
    """Where the model leaves more of the recordings than their noise."""
    next_experiment: Experiment | None = None
    """The most informative recording for the numbers that are not identified yet."""
    evaluations: int = 0
    """Times that the model was solved."""
    wall_s: float = 0.0
    """Wall time of the fit [s]."""

    def __repr__(self) -> str:
        known = sum(number.is_identified for number in self.numbers)
        return f"<Fit {self.name}: {known} of {len(self.numbers)} numbers identified>"

    def __getitem__(self, key: str) -> FittedNumber:
        """The number of a key; raises `KeyError` where none was fitted."""
        return {number.key: number for number in self.numbers}[key]

    @property
    def values(self) -> dict[str, float]:
        """Fitted numbers [SI] by key."""
        return {number.key: number.value for number in self.numbers}

    @property
    def cannot_be_told_apart(self) -> list[list[str]]:
        """Keys of each product that is known, while its factors are not."""
        return [[key for key, _ in product.powers] for product in self.products]

    def document(self) -> dict[str, Any]:
        """The fit as one document."""
        offsets = [run.clock_offset_s for run in self.runs]
        following = self.next_experiment
        document = {
            "name": self.name,
            "version": self.version,
            "spec_sha256": self.spec_sha256,
            "resolved_sha256": self.resolved_sha256,
            "status": self.status,
            "parameters": [number.document() for number in self.numbers],
            "clock_offset_s": offsets[0] if len(offsets) == 1 else offsets,
            "cannot_be_told_apart": self.cannot_be_told_apart,
            "products": [product.document() for product in self.products],
            "chi2_per_dof": self.chi2_per_dof,
            "mismatch": None if self.mismatch is None else self.mismatch.document(),
            "next_experiment": None if following is None else following.document(),
            "recordings": [run.document() for run in self.runs],
            "effects": sorted(self.effects),
            "mesh": dict(self.mesh),
            "left_out": [{"key": key, "reason": why} for key, why in self.left_out],
            "warnings": list(self.warnings),
            "cost": {"wall_s": self.wall_s, "evaluations": self.evaluations},
            "provenance": provenance(),
        }
        return dict(json_ready(document))
