"""`actuators:` of a scene without a robot: what each is, what feeds it and what it carries."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import Field

from viscodesign.scene.loads import Loads
from viscodesign.scene.several import ActuatorDesign


class FedActuator(ActuatorDesign):
    """One of several actuators that hang side by side.

    One that is `like` another has its source and its loads, too, unless it has its own.
    """

    source: str | dict[str, str] | None = Field(
        None,
        description="Name of the input that feeds it; of a network with several inlets, one for "
        "each: {inlet: input}. Default: the only input",
    )
    loads: Loads | None = Field(None, description="Instead of the scene's loads")


def inherited(name: str, actuators: Mapping[str, FedActuator], key: str) -> object:
    """What an actuator has under a key, or the one that it is like; None where none has any."""
    own: FedActuator | None = actuators[name]
    for _ in actuators:
        if own is None or getattr(own, key) is not None:
            break
        own = actuators.get(own.like or "")
    return None if own is None else getattr(own, key)


INLET = "inlet"
"""What the inlet of a network with one is called."""


def by_inlet(source: Any) -> dict[str, str]:
    """Inputs by inlet; one alone is that of the only inlet."""
    if source is None:
        return {}
    return dict(source) if isinstance(source, dict) else {INLET: source}
