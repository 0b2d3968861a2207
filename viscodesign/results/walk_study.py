"""How a robot walks. Plain data: `report` draws it, the command line prints it."""

from __future__ import annotations

from dataclasses import asdict, field
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice, json_ready
from viscodesign.results.gait_energy import GaitEnergy
from viscodesign.results.provenance import provenance
from viscodesign.results.robot_motion import RobotMotion


@dataclass(frozen=True)
class FootUse:
    """What a foot does in a cycle."""

    lift_m: float
    """Largest height over the ground."""
    stance_share: float
    """Part of the cycle on the ground."""
    slide_share: float
    """Part of the cycle in which it slides."""
    peak_normal_n: float
    peak_friction_n: float


@dataclass(frozen=True)
class PumpUse:
    """What a source's pump does."""

    volume_m3: float
    """Barrel that holds the fluid while it is not in the legs, in the last cycle."""
    run_volume_m3: float
    """The same over the whole run, which begins with legs at their first pressure."""
    flow_m3_s: float
    """Largest rate of that volume in the last cycle."""
    is_feasible: bool | None
    """Whether the spec's pump can do it; None where it has none."""


@dataclass(frozen=True)
class ContactInvariants:
    """What must hold in every run, as it was found."""

    worst_penetration_m: float
    worst_gap_force_n_m: float
    """Largest product of a gap and its force."""
    worst_cone_excess_n: float
    """Largest friction beyond Coulomb's cone; 0 within it."""
    friction_work_j: float
    """Work of friction on the feet; never positive."""
    largest_friction_work_j: float
    """Work of friction in a single step on one foot; never positive."""
    force_imbalance_rel: float
    """Momentum of the whole robot against the forces on it, relative to its weight."""
    gas_mass_imbalance_rel: float
    """Contents of bellows against what flowed in, relative to their contents."""
    energy_imbalance_rel: float
    """Of `GaitEnergy`."""


@dataclass(frozen=True, eq=False)
class WalkStudy:
    """The gait of a robot, or why none is stated."""

    name: str
    body_length_m: float
    motion: RobotMotion
    """With the smallest step."""
    steps_s: tuple[float, ...]
    """The steps that were tried, each half of the one before [s]."""
    advances_by_step_m: tuple[float, ...]
    """How far the body came in the last cycle, by step."""
    advances_by_cycle_m: tuple[float, ...]
    """How far it came in every whole cycle, with the smallest step."""
    body_path_error_m: float
    """Largest distance of the body's paths with the last two steps, over the whole run: the error
    of the finer one, which is of first order on the ground. NaN where there is only one."""
    feet_path_error_m: float
    """The same of the foot that is farthest."""
    step_halving_change: float
    """Change of the advance per cycle by the last halving of the step, relative to it."""
    cycle_change: float
    """Change of the advance from the last cycle but one to the last, relative to it."""
    refusal: str
    """Why no speed is stated; empty where it is."""
    end: str
    """`failed` or `interrupted` where the motion itself ended early, else empty."""
    feet: dict[str, FootUse]
    pumps: dict[str, PumpUse]
    invariants: ContactInvariants
    energy: GaitEnergy
    warnings: tuple[Notice, ...]
    spec_text: str
    """The resolved spec, runnable."""
    solve_cpu_s: float
    """Processor time of the solution with the smallest step [s]."""
    total_s: float
    """That of all [s]."""
    provenance: dict[str, Any] = field(default_factory=provenance)
    """What it was computed with."""

    def __repr__(self) -> str:
        if self.refusal:
            return f"<WalkStudy {self.name}: no speed stated>"
        return f"<WalkStudy {self.name}: {1e3 * self.advance_per_cycle_m:.3g} mm a cycle>"

    @property
    def advance_per_cycle_m(self) -> float:
        """How far the body comes in a cycle, forward positive [m]; NaN where it is not stated."""
        return float("nan") if self.refusal else self.advances_by_step_m[-1]

    @property
    def status(self) -> str:
        """`complete`, `refused` where no speed is stated, `failed` or `interrupted`."""
        return self.end or ("refused" if self.refusal else "complete")

    @property
    def speed_body_lengths_per_s(self) -> float:
        """Speed either way, in lengths of the body a second [1/s]; NaN where it is not stated."""
        return abs(self.advance_per_cycle_m) / (self.motion.period * self.body_length_m)

    @property
    def pump_volume_m3(self) -> float:
        """Largest barrel that a pump needs in the last cycle [m3]."""
        return max(pump.volume_m3 for pump in self.pumps.values())

    @property
    def pump_run_volume_m3(self) -> float:
        """Largest barrel that a pump needs over the whole run [m3]."""
        return max(pump.run_volume_m3 for pump in self.pumps.values())

    def document(self) -> dict[str, Any]:
        """As in `summary.json`."""
        found: dict[str, Any] = json_ready({
            "name": self.name,
            "status": self.status,
            "refusal": self.refusal or None,
            "advance_per_cycle_m": self.advance_per_cycle_m,
            "speed_body_lengths_per_s": self.speed_body_lengths_per_s,
            "period_s": self.motion.period,
            "body_length_m": self.body_length_m,
            "worst_penetration_m": self.invariants.worst_penetration_m,
            "pump_volume_m3": self.pump_volume_m3,
            "pump_run_volume_m3": self.pump_run_volume_m3,
            "pump_flow_m3_s": max(pump.flow_m3_s for pump in self.pumps.values()),
            "body_path_error_m": self.body_path_error_m,
            "feet_path_error_m": self.feet_path_error_m,
            "step_halving_change": self.step_halving_change,
            "cycle_change": self.cycle_change,
            "steps_s": list(self.steps_s),
            "advances_by_step_m": list(self.advances_by_step_m),
            "advances_by_cycle_m": list(self.advances_by_cycle_m),
            "pumps": {name: asdict(pump) for name, pump in self.pumps.items()},
            "feet": {name: asdict(foot) for name, foot in self.feet.items()},
            "invariants": asdict(self.invariants),
            "energy": asdict(self.energy),
            "warnings": [asdict(notice) for notice in self.warnings],
            "cost": {"solve_cpu_s": self.solve_cpu_s, "total_s": self.total_s},
            "provenance": self.provenance,
        })  # fmt: skip
        return found
