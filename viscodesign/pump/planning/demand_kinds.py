"""What is asked of an axis, by the kind of the pump; and what keeps a scene from being planned."""

from __future__ import annotations

from viscodesign.errors import Fault, SpecError, UsageError, described
from viscodesign.plugins import members
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.scene import Scene

MISSING = (
    "missing; the pump commands need the drive's data. Add for example\n"
    "  pump:\n    syringe_diameter: 34.9 mm\n    servo: ax18a\n"
    "or try one: --set 'pump={syringe_diameter: 34.9 mm}'"
)


def demand_kind(pump: PumpSpec) -> type[PumpDemand]:
    """What is asked of an axis of a pump of this kind."""
    return members("viscodesign.pump.kinds", PumpDemand)[pump.name]  # type: ignore[type-abstract]


def pump_of(scene: Scene) -> PumpSpec:
    """The scene's pump; raises `SpecError` with what to correct where nothing can be planned.

    All that takes a scene begins here: what is none raises `UsageError`.
    """
    if not isinstance(scene, Scene):
        raise UsageError(
            "expected a scene, such as load('leg.yaml') returns, or the `pumped` of several "
            f"actuators; got {described(scene)}"
        )
    driven = [name for name, source in scene.inputs.items() if not source.gives_pressure]
    if scene.pump is None:
        key, message = "pump", MISSING
    elif driven:
        key, message = (
            "input",
            f"the inlet '{driven[0]}' already has a syringe as its input; a plan starts from the "
            "pressure wanted at each inlet",
        )
    elif fault := next(demand_kind(scene.pump).faults(scene), None):
        key, message = fault
    else:
        found: PumpSpec = scene.pump
        return found
    raise SpecError([Fault(message, key, scene.source.file)])
