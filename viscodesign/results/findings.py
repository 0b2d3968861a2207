"""Findings about a scene or a run, each with its document for JSON.

Plain data. Nothing here knows how a number was computed; `report` draws it, the command
line prints it, and a script reads it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from typing import Any, Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.provenance import provenance

NOT_APPLICABLE = "not applicable"
"""Decision on an effect of which the scene has nothing that it acts on."""


@dataclass(frozen=True)
class Scales:
    """The four characteristic times of a scene [s]."""

    t_s: float
    """Elastic-inertial time of the solid."""
    t_f: float
    """Viscous-elastic time of the fluid, as the paper defines it."""
    t_i: float
    """Shortest monotone transient of the inlet pressure (infinite for a constant)."""
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
    """Whether a run includes an effect, and why."""

    name: str
    """Name of the effect."""
    mode: Literal["auto", "on", "off"]
    """As the spec has it."""
    taken: bool
    """Whether the run includes it."""
    weight: float
    """How much it matters by its formula; dimensionless, as a rule a ratio."""
    formula: str
    """That of the weight."""
    reason: str
    """Why it is included or neglected, in words."""
    contribution_m: float = 0.0
    """Estimated displacement of the tip when only this effect is switched, in the set of effects
    from which it was weighed last [m]."""
    budget_share: float = 0.0
    """The same as a share of the requested tip error."""
    present: bool = True
    """Whether the scene has what the effect acts on: otherwise it is not applicable."""
    traits: tuple[str, ...] = ()
    """What the effect makes of the model, for code that must not know its name."""

    @property
    def decision(self) -> str:
        """The decision in words."""
        if not self.present:
            return NOT_APPLICABLE
        return "included" if self.taken else "neglected"


@dataclass(frozen=True)
class EffectAblation:
    """Tip displacement by switching one effect, measured by a second solution."""

    name: str
    """Name of the effect."""
    taken: bool
    """Whether the run includes the effect; the second solution has it switched."""
    estimated_m: float
    """Estimated displacement, from the run's own set of effects [m]."""
    measured_m: float | None
    """Largest distance of the tips over all output times [m]; None where there is no solution."""
    solve_s: float
    """Wall time of the second solution [s]."""
    note: str = ""
    """Why there is no measurement, or the time up to which it was compared."""

    @property
    def decision(self) -> str:
        """The decision that was tested, in words."""
        return "included" if self.taken else "neglected"


@dataclass(frozen=True)
class Notice:
    """A warning to the user."""

    code: str
    """One word for programs, such as cavitation."""
    message: str
    """One sentence for people."""
    where: str = ""
    """The bellow, tube, section or inlet; empty for the whole."""
    time_s: float | None = None
    """When it was first so [s]; None if always."""


def outside_words(violations: Iterable[Notice]) -> str:
    """Where a run leaves what its model describes, by the codes of its ``violations``."""
    return f"outside of the model: {', '.join(violation_codes(violations))}"


def violation_codes(violations: Iterable[Notice]) -> tuple[str, ...]:
    """Their codes, each once."""
    return tuple(dict.fromkeys(own.code for own in violations))


@dataclass(frozen=True)
class Classification:
    """Timescales, ratios and quadrant of one scene, with what they mean."""

    name: str
    """Name of the scene."""
    scales: Scales
    """Its four times [s]."""
    quadrant: Literal["I", "II", "III", "IV"]
    """Quadrant of the plane of t_s/t_f and t_s/t_i."""
    meaning: str
    """What that means for the motion, in words."""
    cutoff_frequency_hz: float
    """Frequency above which the network does not follow its inlet [Hz]."""
    warnings: tuple[Notice, ...] = ()
    """What its assumptions do not cover."""


@dataclass(frozen=True)
class RetryAttempt:
    """One retry where a solver had stopped: what was changed, why, and whether it helped."""

    time_s: float
    """Time at which the run had stopped [s]."""
    tried: str
    """What was changed."""
    solved: bool
    """Whether it helped."""
    reason: str
    """Why the solver had stopped."""


def validity_document(violations: Iterable[Notice]) -> dict[str, Any]:
    """Whether a run stays within what its model describes, and where not, for a program."""
    reasons = documents(violations)
    return {"state": "outside" if reasons else "inside", "reasons": reasons}


Finding = Verdict | EffectAblation | Notice | RetryAttempt


def json_ready(value: Any) -> Any:
    """A value as JSON has it: non-finite numbers become null, tuples and arrays lists."""
    if isinstance(value, (np.generic, np.ndarray)):
        value = value.tolist()
    if isinstance(value, Mapping):
        return {str(key): json_ready(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [json_ready(item) for item in value]
    if isinstance(value, (bool, int, str)) or value is None:
        return value
    number = float(value)
    return number if math.isfinite(number) else None


def documents(findings: Iterable[Finding]) -> list[dict[str, Any]]:
    """Findings as objects of JSON, under the names of their fields."""
    return [dict(json_ready(asdict(found))) for found in findings]


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
        "warnings": documents(found.warnings),
    }
    return dict(json_ready(document))


def check_document(
    found: Classification, verdicts: Iterable[Verdict], facts: Sequence[str]
) -> dict[str, Any]:
    """The results of a check, under the names of a run's summary."""
    return {
        **classification_document(found),
        "effects": documents(verdicts),
        "facts": list(facts),
        "provenance": provenance(),
    }
