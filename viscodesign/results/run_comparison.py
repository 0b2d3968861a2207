"""Several motions beside each other: plain data, and what it says in words."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.lazy_names import module_above
from viscodesign.results.coefficient_band import CoefficientBand
from viscodesign.results.findings import json_ready
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.notebook_view import NotebookView
from viscodesign.results.trajectory import Status

if TYPE_CHECKING:
    import pandas as pd

Origin = Literal["run", "spec", "table"]
INTERPOLATION = (
    "at every output time of either, in the part of time that both have; between its own output "
    "times a motion is a cubic through its two neighbours, with the slopes of central differences"
)
"""How motions on different times are compared."""
IN_PHASE = 1e-3
"""Shift, in periods or of the whole time, below which nobody is called late."""
EXPLAINED = 0.5
"""Part of the distance that a shift of time has to leave at most to be told."""
DIFFERENCE_COLUMNS = (
    *("from_s", "to_s", "rms_m", "max_m", "max_time_s", "interpolation_m", "verdict"),
    *("shift_s", "shifted_rms_m"),
    *("phase_rms_m", "phase_max_m", "phase_shift_s", "phase_shifted_rms_m"),
    *("band_95_m", "within_band"),
)


@dataclass(frozen=True, eq=False)
class ComparedMotion:
    """The path of a tip, and what is known of it."""

    label: str
    """What pictures and tables call it, one of a kind."""
    origin: Origin
    source: str
    """Path of the folder, the spec or the table; empty where it was given as an object."""
    time: np.ndarray
    """(T,) [s], increasing."""
    tip: np.ndarray
    """(T, 2): x, z [m]."""
    metrics: Mapping[str, float]
    """Its own, as `results.metrics` defines them; NaN where one is not defined."""
    status: Status = "complete"
    failure: str = ""
    stated_error_m: float | None = None
    """Estimated error of the tip at any time [m]; None where none is stated."""
    error_words: str = ""
    """Which model the error belongs to, or why there is none."""
    period: float | None = None
    """[s]; None where the motion is not cyclic, or it is not known."""
    note: str = ""
    """What was left out of its file."""
    band: CoefficientBand | None = None
    """What the coefficients of its spec leave open; None where the spec does not say."""
    outside: tuple[str, ...] = ()
    """Why a run lies outside of what its model describes, as codes such as choking."""

    @property
    def title(self) -> str:
        """Its label, and a word where it is not whole."""
        if self.status == "complete":
            return self.label
        return f"{self.label} ({self.status} at {self.time[-1]:.4g} s)"

    @property
    def error_text(self) -> str:
        """Its stated error in words."""
        if self.stated_error_m is None:
            return self.error_words or "not stated"
        size = f"{1e3 * self.stated_error_m:.2g} mm"
        return f"{size}, {self.error_words}" if self.error_words else size

    @property
    def band_text(self) -> str:
        """What its coefficients leave open, in words."""
        if self.band is None:
            return "not stated"
        return f"+-{1e3 * self.band.half_width_m:.3g} mm (95 %)"


@dataclass(frozen=True, eq=False)
class PhaseDifference:
    """Two cyclic motions at the same phase of their last full periods."""

    phase: np.ndarray
    """(m,) from 0 to 1, without 1; zero where time is a multiple of the period."""
    distance: np.ndarray
    """(m,) [m]."""
    shift: float
    """By how much the second is late, in periods from -0.5 to 0.5, where both fit best."""
    shift_s: float
    """The same [s], of the first's period."""
    shifted_rms_m: float
    """Distance after that shift, root mean square [m]."""

    @property
    def rms_m(self) -> float:
        """Root mean square of the distance [m]."""
        return float(np.sqrt(np.mean(self.distance**2)))

    @property
    def max_m(self) -> float:
        """Largest distance [m]."""
        return float(self.distance.max())


@dataclass(frozen=True)
class TimeShift:
    """How late one motion is, where both fit best."""

    shift_s: float
    """By how much the second is late [s]."""
    rms_m: float
    """Distance after that shift, root mean square [m]."""


@dataclass(frozen=True, eq=False)
class TipDifference:
    """A motion against the first one."""

    label: str
    """Title of the motion."""
    first: str
    """Title of the first."""
    time: np.ndarray
    """(n,) at which both were compared [s]."""
    distance: np.ndarray
    """(n,) between the tips at the same time [m]."""
    rms_m: float
    """Over time, by the trapezoidal rule [m]."""
    interpolation_m: float
    """Estimated error of interpolating between output times [m]; 0 on equal times."""
    own_error_m: float | None
    """Stated error of the motion [m]."""
    first_error_m: float | None
    """Stated error of the first [m]."""
    is_part: bool
    """Whether one of the two lasts longer than what was compared."""
    phase: PhaseDifference | None = None
    """Where both are cyclic and have a whole period."""
    shift: TimeShift | None = None
    """Shift in time between motions that are not cyclic."""
    band: np.ndarray | None = None
    """(n,) Half of the 95 % interval of the distance by the coefficients [m]; None where no spec
    says how well they are known, or they move both motions."""
    outside: tuple[str, ...] = ()
    """Which of the two lie outside of their model, with the codes of why."""
    has_clock: bool = True
    """Whether one was recorded, with a clock of its own; two simulations begin together."""

    @property
    def max_m(self) -> float:
        """Largest distance at the same time [m]."""
        return float(self.distance.max())

    @property
    def max_time_s(self) -> float:
        """When it is largest [s]."""
        return float(self.time[int(self.distance.argmax())])

    @property
    def numerical_m(self) -> float | None:
        """What errors and interpolation may contribute together [m]; None where not known."""
        if self.own_error_m is None or self.first_error_m is None:
            return None
        return self.own_error_m + self.first_error_m + self.interpolation_m

    @property
    def verdict(self) -> Literal["differ", "within errors", "unknown"]:
        """Whether the largest distance is more than numerical errors explain."""
        if self.numerical_m is None:
            return "unknown"
        return "differ" if self.max_m > self.numerical_m else "within errors"

    @property
    def band_m(self) -> float | None:
        """The band where the distance is largest [m]; None without one."""
        return None if self.band is None else float(self.band[int(self.distance.argmax())])

    @property
    def within_band(self) -> float | None:
        """Share of the times at which the band holds the distance [1]; None without one."""
        if self.band is None:
            return None
        return float(np.mean(self.distance <= self.band + (self.numerical_m or 0.0)))

    @property
    def band_sentence(self) -> str:
        """What the coefficients leave open of the distance; empty where that is not known."""
        if self.band is None:
            return ""
        widest = float(self.band.max())
        return (
            f"by the coefficients it may be +-{_mm(widest)} (95 %, at "
            f"{self.time[int(self.band.argmax())]:.4g} s) and +-{_mm(self.band_m or 0.0)} where it "
            f"is largest: the band holds it at {100 * (self.within_band or 0.0):.0f} % of the times"
        )

    @property
    def sentence(self) -> str:
        """The difference in words."""
        span = f"from {self.time[0]:.4g} to {self.time[-1]:.4g} s"
        part = ", the part of time that both have" if self.is_part else ""
        return (
            f"{self.label} differs from {self.first} by {_mm(self.max_m)} at most (at "
            f"{self.max_time_s:.4g} s) and {_mm(self.rms_m)} rms, {span}{part}; {self._errors()}"
            f"{self._outside()}"
        )

    def _outside(self) -> str:
        if not self.outside:
            return ""
        told = " and ".join(self.outside)
        return f"; outside of the model, which no stated error counts: {told}"

    def _errors(self) -> str:
        own, first = self.own_error_m, self.first_error_m
        between = self.interpolation_m
        added = f", and about {_mm(between, 2)} interpolation" if between > 0 else ""
        if own is None or first is None:
            known = [e for e in (first, own) if e is not None]
            words = (
                f"{_mm(known[0], 2)} of it may be numerical" if known else "no errors are stated"
            )
            missing = [t for t, e in ((self.first, first), (self.label, own)) if e is None]
            told = f"; that of {missing[0]} is not known" if known else ""
            return f"{words}{told}{added}"
        words = f"of which {_mm(first, 2)} + {_mm(own, 2)} may be numerical{added}"
        if self.verdict == "within errors":
            return f"{words}: the errors alone explain it, so no difference can be told"
        return words

    @property
    def shift_sentence(self) -> str:
        """What a shift of time explains; empty where that is less than half of the distance."""
        found = self.shift
        if found is None or self.verdict == "within errors":
            return ""
        least = IN_PHASE * float(self.time[-1] - self.time[0])
        if found.rms_m > EXPLAINED * self.rms_m or abs(found.shift_s) < least:
            return ""
        late = "later" if found.shift_s >= 0 else "earlier"
        asked = "; are their clocks the same?" if self.has_clock else ""
        return (
            f"{self.label} fits best {abs(found.shift_s):.3g} s {late}: without that "
            f"{_mm(found.rms_m)} rms{asked}"
        )

    @property
    def sentences(self) -> list[str]:
        """All that is to say of the two."""
        said = (self.sentence, self.band_sentence, self.shift_sentence, self.phase_sentence)
        return [text for text in said if text]

    @property
    def phase_sentence(self) -> str:
        """The difference at the same phase in words; empty where there is none."""
        if self.phase is None:
            return ""
        found = self.phase
        sizes = (
            f"at the same phase of the last period: {_mm(found.max_m)} at most, "
            f"{_mm(found.rms_m)} rms"
        )
        if abs(found.shift) < IN_PHASE:
            return f"{sizes}; neither is later by {100 * IN_PHASE:g} % of the period"
        late = "late" if found.shift_s >= 0 else "early"
        return (
            f"{sizes}; {self.label} is {abs(found.shift_s):.3g} s {late} "
            f"({100 * abs(found.shift):.2g} % of the period), without that "
            f"{_mm(found.shifted_rms_m)} rms"
        )

    def row(self) -> dict[str, Any]:
        """Its numbers under the names of the table's columns."""
        phase = self.phase
        return {
            "from_s": float(self.time[0]),
            "to_s": float(self.time[-1]),
            "rms_m": self.rms_m,
            "max_m": self.max_m,
            "max_time_s": self.max_time_s,
            "interpolation_m": self.interpolation_m,
            "verdict": self.verdict,
            "shift_s": None if self.shift is None else self.shift.shift_s,
            "shifted_rms_m": None if self.shift is None else self.shift.rms_m,
            "phase_rms_m": None if phase is None else phase.rms_m,
            "phase_max_m": None if phase is None else phase.max_m,
            "phase_shift_s": None if phase is None else phase.shift_s,
            "phase_shifted_rms_m": None if phase is None else phase.shifted_rms_m,
            "band_95_m": self.band_m,
            "within_band": self.within_band,
        }


@dataclass(frozen=True, eq=False)
class Comparison(NotebookView):
    """Motions, and how far each is from the first."""

    motions: tuple[ComparedMotion, ...]
    """At least two."""
    differences: tuple[TipDifference, ...]
    """Differences of all but the first, in their order."""
    version: str
    missing: tuple[str, ...] = ()
    """What an interrupt left out."""
    notes: tuple[str, ...] = ()
    """What was assumed, and what was read instead of computed."""

    @property
    def status(self) -> Literal["complete", "interrupted"]:
        """Whether all that was asked for is there."""
        return "interrupted" if self.missing else "complete"

    @property
    def columns(self) -> list[str]:
        """Names of the columns of `compare.csv`."""
        known = ("label", "origin", "source", "status", "rows", "end_s", "period_s")
        errors = ("stated_error_m", "coefficients_95_m")
        return [*known, *errors, *METRIC_NAMES, *DIFFERENCE_COLUMNS, "failure"]

    def rows(self) -> list[list[Any]]:
        """Rows of `compare.csv`, one a motion; the first has no difference."""
        blank = dict.fromkeys(DIFFERENCE_COLUMNS)
        found = [self._row(self.motions[0], blank)]
        for motion, difference in zip(self.motions[1:], self.differences, strict=True):
            found.append(self._row(motion, difference.row()))
        return found

    def _row(self, motion: ComparedMotion, difference: Mapping[str, Any]) -> list[Any]:
        stated = math.nan if motion.stated_error_m is None else motion.stated_error_m
        period = math.nan if motion.period is None else motion.period
        known = [motion.label, motion.origin, motion.source, motion.status]
        band = math.nan if motion.band is None else motion.band.half_width_m
        numbers = [len(motion.time), float(motion.time[-1]), period, stated, band]
        own = [math.nan if v is None else v for v in difference.values()]
        own[DIFFERENCE_COLUMNS.index("verdict")] = difference["verdict"] or ""
        metrics = [motion.metrics[name] for name in METRIC_NAMES]
        return [*known, *numbers, *metrics, *own, motion.failure]

    def frame(self) -> pd.DataFrame:
        """The table: the columns of `compare.csv`."""
        import pandas as pd

        return pd.DataFrame(self.rows(), columns=self.columns)

    def document(self) -> dict[str, Any]:
        """All but the curves as one document."""
        document = {
            "status": self.status,
            "version": self.version,
            "interpolation": INTERPOLATION,
            "motions": [
                {
                    "label": m.label,
                    "origin": m.origin,
                    "source": m.source,
                    "status": m.status,
                    "failure": m.failure or None,
                    "rows": len(m.time),
                    "start_s": float(m.time[0]),
                    "end_s": float(m.time[-1]),
                    "period_s": m.period,
                    "stated_error_m": m.stated_error_m,
                    "error": m.error_text,
                    "coefficients_95_m": m.band and m.band.half_width_m,
                    "coefficients": m.band_text,
                    "outside": list(m.outside),
                    "metrics": dict(m.metrics),
                }
                for m in self.motions
            ],
            "differences": [
                {"label": m.label, "to": self.motions[0].label, **d.row(), "words": d.sentences}
                for m, d in zip(self.motions[1:], self.differences, strict=True)
            ],
            "missing": list(self.missing),
            "notes": list(self.notes),
        }
        return dict(json_ready(document))

    def save(
        self,
        directory: str | Path,
        *,
        plots: bool = True,
        report: bool = True,
        force: bool = False,
        picture_format: Literal["png", "pdf", "svg"] = "png",
        style: Literal["plain", "paper", "talk", "dark"] = "plain",
        width: str | float | None = None,
    ) -> list[Path]:
        """Write table, document, picture and page, as `viscodesign compare` does; returns them.

        ``style`` and ``width`` of the picture: as `--style` and `--width` have them. Raises
        `UsageError` for others, and where the folder cannot be written, or (without ``force``)
        holds files that are not ours.
        """
        pictures = module_above("report.picture_options").picture_options(
            picture_format, style, width
        )
        files: list[Path] = module_above("report.comparison_folder").write_comparison(
            self, directory, plots=plots, report=report, force=force, pictures=pictures
        )
        return files

    def __repr__(self) -> str:
        return f"<Comparison of {', '.join(m.title for m in self.motions)}: {self.status}>"


class ComparisonInterruptedError(KeyboardInterrupt):
    """Ctrl-C ended a comparison; ``comparison`` is what there was, None with one motion."""

    def __init__(self, comparison: Comparison | None) -> None:
        self.comparison = comparison
        super().__init__()


def _mm(length: float, digits: int = 3) -> str:
    return f"{1e3 * length:.{digits}g} mm"
