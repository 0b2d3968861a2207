"""When the speed of a gait is stated, and why not."""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.walk_study import WalkStudy


@dataclass(frozen=True)
class StepRule:
    """How small steps are, and when a speed is stated."""

    per_cycle: int = 250
    """Steps of a cycle at first."""
    most_halvings: int = 4
    largest_change: float = 0.03
    """Change of the advance by halving the step, and between cycles, for a stated speed."""
    damping_ratio: float = 3.0
    """Damping time over that of the steps themselves, half of a step, for a stated speed."""
    gas_imbalance: float = 1e-8
    """Contents of bellows against what flowed in, relative to them, for a stated speed."""
    least_advance: float = 1e-4
    """Advance per cycle below which a robot marks time, over the length of its body."""

    def least_damping(self, period: float) -> float:
        """Damping time below which no step is small enough, at a period [s]."""
        return self.damping_ratio * period / (self.per_cycle << self.most_halvings) / 2


STEPS = StepRule()


def relative_change(before: float, after: float, body_length: float) -> float:
    """Change of an advance, relative to it; where a robot marks time, to the least that counts."""
    return abs(after - before) / max(abs(after), STEPS.least_advance * body_length)


def refusal(study: WalkStudy, *, is_damped: bool, emptied: str) -> str:
    """Why no speed is stated; empty where nothing speaks against it.

    ``emptied``: what is said of a bellow without volume; empty where each has some.
    """
    if emptied:
        return emptied
    imbalance = study.invariants.gas_mass_imbalance_rel
    if not imbalance <= STEPS.gas_imbalance:
        return (
            f"the fluid's mass is off by {imbalance:.2g} of the contents, more than the "
            f"{STEPS.gas_imbalance:g} allowed: the pressures are not solved. Use smaller strokes"
        )
    found = ", ".join(f"{1e3 * advance:.4g}" for advance in study.advances_by_step_m)
    steps = ", ".join(f"{1e3 * step:.3g}" for step in study.steps_s)
    told = f"with steps of {steps} ms the last cycle advances by {found} mm"
    if not is_damped:
        return (
            f"the steps damp the legs more than robot.damping_time does: {told}. State the "
            "damping of the legs, on which the speed depends"
        )
    if study.step_halving_change >= STEPS.largest_change:
        return (
            f"the advance per cycle changes by {study.step_halving_change:.2g} of it when the "
            f"step is halved: {told}. More damping (robot.damping_time) makes it converge"
        )
    if study.cycle_change >= STEPS.largest_change:
        return (
            f"the gait is not periodic yet: its last cycle differs by {study.cycle_change:.2g} "
            "from the one before. Use a longer run.duration"
        )
    return ""
