"""What is known of several actuators without solving them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from viscodesign.checks.check import Check, check
from viscodesign.checks.classify import classify
from viscodesign.errors import SpecError
from viscodesign.results.findings import Classification
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene


def check_several(scene: SeveralScene) -> Mapping[str, Check]:
    """Weigh every effect of every actuator, as `check` does of one.

    Those that share fluid have the same check, that of the system that they are.

    Raises `SpecError` where an actuator has no bounded solution.
    """
    found: dict[str, Check] = {}
    for name, own in scene.scenes.items():
        one = _checked(name, own)
        found[name] = replace(one, facts=(*_facts(scene, name), *one.facts))
    for joined in scene.joined:
        names = tuple(joined.members)
        one = _checked("+".join(names), joined)
        told = f"{' and '.join(names)}: one system, with one set of effects"
        found |= dict.fromkeys(names, replace(one, facts=(told, *one.facts)))
    return {name: found[name] for name in scene.actuators}


def _checked(name: str, scene: Scene) -> Check:
    try:
        return check(scene)
    except SpecError as error:
        raise error_of(name, error) from None


def classify_several(scene: SeveralScene) -> Mapping[str, Classification]:
    """Timescales and quadrant of every actuator, as `classify` tells of one.

    Those that share fluid have the same, of the system that they are.
    """
    found = {name: classify(own) for name, own in scene.scenes.items()}
    for joined in scene.joined:
        found |= dict.fromkeys(joined.members, classify(joined))
    return {name: found[name] for name in scene.actuators}


def classified(scene: Scene | SeveralScene) -> list[Classification]:
    """Those of all actuators of a spec, which may be one; what shares fluid has one together."""
    if isinstance(scene, SeveralScene):
        return list({id(own): own for own in classify_several(scene).values()}.values())
    return [classify(scene)]


def error_of(name: str, error: SpecError) -> SpecError:
    """The faults of an actuator's scene as those of the actuator."""
    return SpecError([replace(f, key=f"actuators.{name}: {f.key}") for f in error.faults])


def _facts(scene: SeveralScene, name: str) -> list[str]:
    """One sentence per inlet of an actuator: its source, and the other actuators on that source."""
    facts = []
    for inlet, source in scene.sources_of(name).items():
        others = [other for other in scene.fed_by(source) if other != name]
        also = f", which also feeds {', '.join(others)}" if others else ""
        given = "a given pressure, whatever flows"
        if not scene.sources[source].gives_pressure:
            part = f"of which each of the {len(others) + 1} has an even part: they are equal"
            given = f"a syringe, {part}" if others else "a syringe"
        facts.append(f"{inlet} is fed by {source}{also}: {given}")
    return facts
