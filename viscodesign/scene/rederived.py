"""Scenes of actuators as they follow from a spec of several with other numbers, not validated.

The other spec differs in numbers alone, which may be of any kind; those that carry formulas keep
them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from viscodesign.scene.fed_actuator import INLET, inherited
from viscodesign.scene.fluid_links import LinkedGroup, regrouped
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.joined_scene import JoinedScene
from viscodesign.scene.later_input import later_input
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import SameInput, unlike
from viscodesign.scene.several_scene import OF_DESIGN, SHARED, SeveralScene
from viscodesign.scene.spec_part import copied


def rederived(base: Scene, name: str, former: SeveralScene, spec: SeveralScene) -> Scene:
    """The scene of an actuator by itself in another spec; ``base``: in the former one."""
    sources = former.sources_of(name)
    inputs = {inlet: _share(source, former, spec) for inlet, source in sources.items()}
    is_single = tuple(sources) == (INLET,)
    driven = {"input": inputs[INLET]} if is_single else {"several_inputs": inputs}
    network = unlike(spec.actuators)[name].network
    found: Scene = copied(base, {**_parts(name, spec), "network": network, **driven})
    return found


def rederived_group(
    base: JoinedScene, group: LinkedGroup, former: SeveralScene, spec: SeveralScene
) -> JoinedScene:
    """The scene of actuators that share fluid in another spec; ``base``: in the former one."""
    tubes = zip(base.network.tubes or (), regrouped(group, spec).tubes, strict=True)
    entries = tuple(copied(own, {"length": t.length, "radius": t.radius}) for own, t in tubes)
    members = {name: copied(own, _parts(name, spec)) for name, own in base.actuators.items()}
    first = next(iter(members.values()))
    found: JoinedScene = copied(
        base,
        {
            **_shared(spec),
            "actuators": members,
            "actuator": first.actuator,
            "loads": first.loads,
            "network": copied(base.network, {"tubes": entries}),
            "several_inputs": {name: source_in(name, former, spec) for name in group.inputs},
        },
    )
    return found


def source_in(name: str, former: SeveralScene, spec: SeveralScene) -> Input:
    """An input of another spec with values of its own.

    Raises `TypeError` where one that is another one, later, needs plain numbers.
    """
    given, before = spec.inputs[name], former.inputs[name]
    if not isinstance(given, SameInput):
        return given  # type: ignore[no-any-return]
    if given is before and spec.inputs[given.source] is former.inputs[given.source]:
        return former.sources[name]
    try:
        found = later_input(spec.inputs[given.source], given.delay, spec.run.duration)
    except ValidationError as error:
        raise TypeError(f"the lines of input {name} need plain numbers") from error
    assert found is not None, "its kind can be later, or the former spec would have been refused"
    return found


def _share(source: str, former: SeveralScene, spec: SeveralScene) -> Input:
    """What one actuator has of an input."""
    own = source_in(source, former, spec)
    return own.shared_by(len(former.fed_by(source))) or own


def _parts(name: str, spec: SeveralScene) -> dict[str, Any]:
    """The fields of an actuator's scene but its network and its inputs."""
    design, loads = unlike(spec.actuators)[name], inherited(name, spec.actuators, "loads")
    return {
        **_shared(spec),
        **{field: getattr(design, field) for field in OF_DESIGN.values() if field != "network"},
        "loads": spec.loads if loads is None else loads,
    }


def _shared(spec: SeveralScene) -> Mapping[str, Any]:
    """The fields that all scenes of a spec have in common."""
    return {"fluid_choice": spec.fluid_choice} | {key: getattr(spec, key) for key in SHARED}
