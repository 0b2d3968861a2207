"""What is found of a scene or a run besides its arrays, each with its document.

Plain data. Nothing here knows how a number was computed; `report` draws it, the command
line prints it, and a script reads it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from typing import Any, Literal

import numpy as np


@dataclass(frozen=True)
class Scales:
    """The four characteristic times of a scene [s]."""

    t_s: float
    """Elastic-inertial time of the solid."""
    t_f: float
    """Viscous-elastic time of the fluid, as the paper defines it."""
    t_i: float
    """Shortest monotone swing of the inlet pressure (infinite for a constant)."""
    t_net: float
    """Slowest time constant of the real network."""

    @property
    def ratios(self) -> dict[str, float]:
        """`ts_over_tf` (x of the quadrant plane), `ts_over_ti` (y) and `tnet_over_ti`."""
        return {
            "ts_over_tf": _ratio(self.t_s, self.t_f),
            "ts_over_ti": _ratio(self.t_s, self.t_i),
            "tnet_over_ti": _ratio(self.t_net, self.t_i),
        }


def _ratio(above: float, below: float) -> float:
    if below == 0.0:
        return float("inf")
    return above / below


@dataclass(frozen=True)
class Verdict:
    """Why an effect is in or out of a run."""

    name: str
    mode: Literal["auto", "on", "off"]
    taken: bool
    weight: float
    formula: str
    reason: str
    contribution_m: float = 0.0
    """Estimate of how far the tip moves when this effect alone is switched [m]."""
    budget_share: float = 0.0
    """The same over the tip error asked for."""
    present: bool = True
    """Whether the scene has what the effect acts on."""


@dataclass(frozen=True)
class EffectAblation:
    """What switching one effect did to the tip, measured by a second solution."""

    name: str
    taken: bool
    """Whether the run has the effect; the second solution has it the other way round."""
    estimated_m: float
    """The verdict's contribution [m]."""
    measured_m: float | None
    """Largest distance of the tips over all output times [m]; None where there is no solution."""
    solve_s: float
    """Wall time of the second solution [s]."""
    note: str = ""
    """Why there is none, or up to when it reached."""


@dataclass(frozen=True)
class Notice:
    """A warning: something the numbers say and the user should hear."""

    code: str
    message: str
    where: str = ""
    time_s: float | None = None


@dataclass(frozen=True)
class Classification:
    """Timescales, ratios and quadrant of one scene, with what they mean."""

    name: str
    scales: Scales
    quadrant: Literal["I", "II", "III", "IV"]
    meaning: str
    cutoff_frequency_hz: float
    warnings: tuple[Notice, ...] = ()


@dataclass(frozen=True)
class RetryAttempt:
    """What was tried where, why, and whether it helped."""

    time_s: float
    """Where the run had stopped [s]."""
    tried: str
    """What was changed."""
    solved: bool
    reason: str
    """What had failed before."""


def plain(value: Any) -> Any:
    """JSON-ready: numbers that are not finite become null, tuples and arrays lists."""
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, dict):
        return {str(key): plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(item) for item in value]
    if isinstance(value, (bool, int, str)) or value is None:
        return value
    number = float(value)
    return number if math.isfinite(number) else None


def verdict_documents(verdicts: Iterable[Verdict]) -> list[dict[str, Any]]:
    """Verdicts as objects."""
    return [plain(asdict(verdict)) for verdict in verdicts]


def ablation_documents(ablations: Iterable[EffectAblation]) -> list[dict[str, Any]]:
    """Proofs as objects: name, taken, estimated_m, measured_m, solve_s, note."""
    return [plain(asdict(ablation)) for ablation in ablations]


def notice_documents(notices: Iterable[Notice]) -> list[dict[str, Any]]:
    """Warnings as objects: code, message, where, time_s."""
    return [plain(asdict(notice)) for notice in notices]


def classification_document(found: Classification) -> dict[str, Any]:
    """Scales, ratios and quadrant of one spec."""
    scales = found.scales
    document = {
        "name": found.name,
        "scales": {"t_s": scales.t_s, "t_f": scales.t_f, "t_i": scales.t_i, "t_net": scales.t_net},
        "ratios": scales.ratios,
        "quadrant": found.quadrant,
        "meaning": found.meaning,
        "cutoff_frequency_hz": found.cutoff_frequency_hz,
        "warnings": notice_documents(found.warnings),
    }
    return dict(plain(document))


def check_document(
    found: Classification, verdicts: Iterable[Verdict], facts: Sequence[str]
) -> dict[str, Any]:
    """What a check tells, under the names of a run's summary."""
    return {
        **classification_document(found),
        "effects": verdict_documents(verdicts),
        "facts": list(facts),
    }
