"""Whether a scene's actuator may touch something, for what cannot follow that."""

from __future__ import annotations

from viscodesign.effects.base import Trait
from viscodesign.effects.select import select_effects
from viscodesign.errors import Fault, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities


def has_contact(quantities: SceneQuantities) -> bool:
    """Whether an effect of the scene lets the rod touch a rigid surface."""
    return bool(_touching(quantities))


def refuse_contact(quantities: SceneQuantities, what: str) -> None:
    """Raise `SpecError` where the rod may touch something; ``what`` cannot follow it then."""
    for name in _touching(quantities):
        raise SpecError(
            [
                Fault(
                    f"{what} cannot follow an actuator that touches something: leave "
                    f"`loads.ground` out, or write `effects.{name}: off`; simulate, check and "
                    "sweep can",
                    "loads.ground",
                )
            ]
        )


def _touching(quantities: SceneQuantities) -> list[str]:
    """Names of the effects that bring contact."""
    chosen = select_effects(quantities).effects
    return [effect.name for effect in chosen if Trait.CONTACT in effect.traits]
