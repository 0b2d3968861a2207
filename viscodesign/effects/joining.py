"""How an effect joins a system, and what is refused of one that another package brings."""

from __future__ import annotations

from viscodesign.effects.base import Effect
from viscodesign.errors import Fault, SpecError
from viscodesign.model.dissipation import is_quadratic
from viscodesign.model.several_rods import SeveralTipsError
from viscodesign.model.system import System

PACKAGE = __name__.partition(".")[0]


def join(effect: Effect, system: System) -> None:
    """Let an effect add its terms.

    Raises `SpecError` where an effect is made for one rod and there are several, and where one from
    outside this package adds a dissipation that is not quadratic in the rod's rates: its force
    would be another one than its power says. Those of this package are held to that by their
    contract tests, since asking takes milliseconds.
    """
    known = len(system.dissipation_power.terms)
    try:
        effect.join(system)
    except SeveralTipsError as error:
        raise _refused(
            effect,
            "this effect acts on one tip, and actuators that share fluid have one each. Let `join` "
            "of {place} go through `system.rod.rods`, or switch the effect off",
        ) from error
    added = system.dissipation_power.terms[known:]
    is_own = type(effect).__module__.partition(".")[0] == PACKAGE
    if not added or is_own or is_quadratic(system, added):
        return
    raise _refused(
        effect,
        "the dissipation that this effect adds cannot be used: a dissipation must be quadratic in "
        "the rates, P(2v) = 4 P(v), since its force is half the gradient of the power. Correct "
        "`join` of {place}, or switch the effect off",
    )


def _refused(effect: Effect, message: str) -> SpecError:
    """``message`` says ``{place}`` where the code of the effect is to be named."""
    place = f"{type(effect).__name__} in {type(effect).__module__}"
    return SpecError([Fault(message.format(place=place), f"effects.{effect.name}")])
