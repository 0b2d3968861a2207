"""Sensitivities of a motion: how far each number moves the tip, and the band of tolerances.

Plain data. Nothing here knows how a number was computed; `report` draws it, the command line
prints it, and a script reads it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import json_ready
from viscodesign.results.notebook_view import NotebookView
from viscodesign.results.provenance import provenance
from viscodesign.storage.cached_property import cached_property

if TYPE_CHECKING:
    import pandas as pd

AXES = ("x", "z")
MM_PER_PERCENT = 1e3 / 100


@dataclass(frozen=True)
class SensitiveNumber:
    """A number of the spec."""

    key: str
    value: float
    """[unit]"""
    unit: str
    deviation: float | None = None
    """One standard deviation [unit]; None without a tolerance."""


@dataclass(frozen=True)
class SampledVariance:
    """Variances from many solutions, which know nothing of slopes."""

    size: int
    """Size of each of the two samples."""
    solutions: int
    failed: int
    """Solutions that failed, and were taken to be where slopes say."""
    deviation_m: np.ndarray
    """(2,) standard deviation of x and z [m]."""
    first_order: np.ndarray
    """(2, k): part of the variance that each number has alone (Sobol's first-order indices)."""
    total_order: np.ndarray
    """(2, k): the same with all that it does together with others."""


@dataclass(frozen=True, eq=False)
class SensitivityStudy(NotebookView):
    """How far each number of a scene moves its tip, at every output time."""

    name: str
    version: str
    spec_sha256: str
    time: np.ndarray
    """(T,) output times [s]."""
    tip: np.ndarray
    """(T, 2): x, z [m]."""
    numbers: tuple[SensitiveNumber, ...]
    slopes: np.ndarray
    """(T, 2, k): derivatives of x and z by the numbers [m/unit]."""
    effects: frozenset[str]
    variances: np.ndarray | None = None
    """(T, 2, k): variances of x and z [m2] with the tolerance of each number alone."""
    left_out: tuple[tuple[str, str], ...] = ()
    """Keys that were not asked for by name and have no slope, and why."""
    sampled: SampledVariance | None = None
    """The same by a sample of designs, without linearization; None where none was asked for."""
    wall_s: float = 0.0
    """Wall time of the study [s]."""
    resolved_sha256: str = ""
    """SHA-256 of the resolved spec, with all overrides."""

    def __repr__(self) -> str:
        band = " with a band" if self.has_band else ""
        return f"<SensitivityStudy {self.name}: {len(self.numbers)} numbers{band}>"

    @property
    def has_band(self) -> bool:
        """Whether there are tolerances."""
        return self.variances is not None

    @cached_property
    def mm_per_percent(self) -> np.ndarray:
        """(T, 2, k): shift of x and z [mm] with one percent of each number."""
        values = np.array([number.value for number in self.numbers])
        return np.asarray(self.slopes * values * MM_PER_PERCENT)

    @cached_property
    def spread(self) -> np.ndarray:
        """(T, 2, k): standard deviation of x and z [m] with the tolerance of each number alone."""
        return np.zeros_like(self.slopes) if self.variances is None else np.sqrt(self.variances)

    @cached_property
    def band(self) -> np.ndarray:
        """(T, 2): standard deviation of x and z [m] with all tolerances, numbers independent."""
        return np.asarray(np.sqrt(np.sum(self.spread**2, axis=2)))

    @cached_property
    def worst_row(self) -> int:
        """Output time at which the band is widest."""
        return int(np.argmax(np.sum(self.band**2, axis=1)))

    @property
    def shares(self) -> np.ndarray:
        """(k,) of the variance of both coordinates, over all output times, by each number."""
        own = np.sum(self.spread**2, axis=(0, 1))
        return np.asarray(own / (own.sum() or 1.0))

    @property
    def worst_shares(self) -> np.ndarray:
        """(2, k) of the variances of x and z where the band is widest."""
        own = self.spread[self.worst_row] ** 2
        return np.asarray(own / np.where(own.sum(axis=1), own.sum(axis=1), 1.0)[:, None])

    @property
    def sizes(self) -> np.ndarray:
        """(T, k) standard deviation of the tip's place [mm] with the tolerance of each number, or
        without tolerances its shift with one percent."""
        moved = 1e3 * self.spread if self.has_band else self.mm_per_percent
        return np.asarray(np.hypot(moved[:, 0], moved[:, 1]))

    @property
    def order(self) -> list[int]:
        """Places of the numbers, those first that move the tip farthest."""
        largest = self.sizes.max(axis=0, initial=0.0)
        return sorted(range(len(self.numbers)), key=lambda k: -largest[k])

    @property
    def table_columns(self) -> list[str]:
        """Names of the columns of `sensitivity.csv`."""
        own = [f"tip_{axis}_m" for axis in AXES]
        own += [f"tip_{axis}_sd_m" for axis in AXES] if self.has_band else []
        keys = [number.key for number in self.numbers]
        return ["time_s", *own, *(f"{k}:tip_{axis}_mm_per_percent" for k in keys for axis in AXES)]

    def rows(self) -> np.ndarray:
        """Rows of `sensitivity.csv`."""
        per_percent = self.mm_per_percent.transpose(0, 2, 1).reshape(len(self.time), -1)
        band = [self.band] if self.has_band else []
        return np.column_stack([self.time, self.tip, *band, per_percent])

    def frame(self) -> pd.DataFrame:
        """All slopes against time: the columns of `sensitivity.csv`."""
        import pandas as pd

        return pd.DataFrame(self.rows(), columns=self.table_columns)

    def document(self) -> dict[str, Any]:
        """The study as one document, numbers that move the tip farthest first."""
        document = {
            "name": self.name,
            "version": self.version,
            "spec_sha256": self.spec_sha256,
            "resolved_sha256": self.resolved_sha256,
            "keys": [self._number_document(k) for k in self.order],
            **({"band": self._band_document()} if self.has_band else {}),
            **({"sobol": self._sampled_document(self.sampled)} if self.sampled else {}),
            "effects": sorted(self.effects),
            "left_out": [{"key": key, "reason": why} for key, why in self.left_out],
            "cost": {"wall_s": self.wall_s},
            "provenance": provenance(),
        }
        return dict(json_ready(document))

    def _number_document(self, k: int) -> dict[str, Any]:
        number, moved = self.numbers[k], self.mm_per_percent[:, :, k]
        sizes = np.hypot(moved[:, 0], moved[:, 1])
        row = int(np.argmax(sizes))
        found = {
            "key": number.key,
            "value": number.value,
            "unit": number.unit,
            "largest_mm_per_percent": sizes[row],
            "time_s": self.time[row],
            "tip_x_mm_per_percent": moved[row, 0],
            "tip_z_mm_per_percent": moved[row, 1],
        }
        if self.has_band:
            deviation = number.deviation or 0.0
            found["standard_deviation"] = deviation
            found["tolerance"] = deviation / abs(number.value) if number.value else None
            found["share_of_variance"] = self.shares[k]
        return found

    def _band_document(self) -> dict[str, Any]:
        rows = self.band.argmax(axis=0)
        widest = {
            f"tip_{axis}_sd_max_m": self.band[row, c]
            for c, (axis, row) in enumerate(zip(AXES, rows, strict=True))
        }
        times = {f"tip_{a}_sd_max_time_s": self.time[r] for a, r in zip(AXES, rows, strict=True)}
        return {**widest, **times, "widest_time_s": self.time[self.worst_row]}

    def _sampled_document(self, sampled: SampledVariance) -> dict[str, Any]:
        keys = [number.key for number in self.numbers]
        found: dict[str, Any] = {
            "time_s": self.time[self.worst_row],
            "solutions": sampled.solutions,
            "failed": sampled.failed,
        }
        for c, axis in enumerate(AXES):
            found[f"tip_{axis}"] = {
                "sd_m": sampled.deviation_m[c],
                "band_sd_m": self.band[self.worst_row, c],
                "keys": [
                    {
                        "key": key,
                        "first_order": sampled.first_order[c, k],
                        "total_order": sampled.total_order[c, k],
                        "share": self.worst_shares[c, k],
                    }
                    for k, key in enumerate(keys)
                ],
            }
        return found


class SensitivityInterruptedError(KeyboardInterrupt):
    """Ctrl-C ended a study whose run and slopes are complete; ``study`` is what there is of it.

    ``missing``: what is not, in words.
    """

    def __init__(self, study: SensitivityStudy, missing: str) -> None:
        self.study = study
        self.missing = missing
        super().__init__(f"interrupted: the run and its slopes are complete, without {missing}")
