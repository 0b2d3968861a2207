"""The body of a scene as a beam, section by section where sections differ."""

from __future__ import annotations

from typing import Any

import numpy as np

from viscodesign.model.rod import Body, SectionNumbers
from viscodesign.model.scene_number import Numbers, mean_of
from viscodesign.model.several_rods import several_bodies
from viscodesign.physics import beam
from viscodesign.scene.scene import Scene


def body_of(scene: Scene) -> Body:
    """The actuator as a beam; where sections differ, with the numbers of each.

    Of actuators that share fluid, all of them side by side.
    """
    if scene.members:
        return several_bodies([body_of(own) for own in scene.members.values()])
    own, count = scene.sections, scene.bellows.count // 2
    modulus, height, width = (own.each(n) for n in ("youngs_modulus", "height", "width"))
    bending = beam.bending_stiffness(modulus, height, width, own.each("bending_factor"))
    extension = beam.extension_stiffness(modulus, height, width, own.each("extension_factor"))
    mass = beam.mass_per_length(own.each("density"), height, width, own.each("solid_fraction"))
    blocked = own.blocked
    if blocked is not None:
        bending, extension = _blocked(bending, blocked), _blocked(extension, blocked)
    if not any(isinstance(value, np.ndarray) for value in (bending, extension, mass)):
        return Body(scene.actuator.length, count, bending, extension, mass)
    return Body(
        scene.actuator.length,
        count,
        bending_stiffness=1 / mean_of(1 / bending, _shares_of_deflection(count)),
        extension_stiffness=1 / mean_of(1 / extension),
        mass_per_length=mean_of(mass),
        varied=SectionNumbers(bending, extension, mass),
    )


def _blocked(stiffness: Any, blocked: np.ndarray) -> Any:
    return np.where(blocked, np.inf, stiffness)


def _shares_of_deflection(count: int) -> np.ndarray:
    """Part of a tip's deflection by a force there that each of ``count`` sections causes (S,)."""
    reach = np.arange(count, -1, -1) / count
    return np.asarray(reach[:-1] ** 3 - reach[1:] ** 3)


def section_stiffnesses(body: Body) -> tuple[Numbers, Numbers]:
    """In bending [N m2] and in extension [N], each one for all sections or of each (S,).

    Zero where a section is blocked: there no strain by pressure pulls on it.
    """
    if body.members:
        each = [(own, *section_stiffnesses(own)) for own in body.members]
        return (
            np.concatenate([bending * np.ones(own.sections) for own, bending, _ in each]),
            np.concatenate([extension * np.ones(own.sections) for own, _, extension in each]),
        )
    if body.varied is None:
        return body.bending_stiffness, body.extension_stiffness
    both = body.varied.bending_stiffness, body.varied.extension_stiffness
    bending, extension = (_unblocked(own) for own in both)
    return bending, extension


def _unblocked(stiffness: Numbers) -> Numbers:
    if not isinstance(stiffness, np.ndarray):
        return stiffness
    return np.where(np.isinf(stiffness), 0.0, stiffness)
