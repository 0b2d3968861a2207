"""The energy of a gait. Plain data."""

from __future__ import annotations

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class GaitEnergy:
    """What did work, what was lost and what is stored, over the run and over its last cycle [J].

    Works are by ``pump`` (of all sources), ``coupling`` (of bellows whose volume under load is not
    reciprocal to their strain under pressure: no body of elastic material does it) and
    ``friction`` (on the feet, never positive). Losses are in the ``tubes``, in the ``material`` of
    the legs, in ``impacts`` of feet, and by the ``steps`` of the solution, which vanish with them.
    """

    work_j: dict[str, float]
    loss_j: dict[str, float]
    stored_j: float
    """Kinetic, of gravity, elastic, and of the fluid: end minus start."""
    cycle_work_j: dict[str, float]
    cycle_loss_j: dict[str, float]
    cycle_stored_j: float
    imbalance_rel: float
    """Largest energy that is not accounted for, relative to the largest work of the pumps or of
    the coupling, or to the range of what is stored."""
