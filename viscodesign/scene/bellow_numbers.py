"""The linear laws of a scene's bellows, one by one where bellows or sections differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import fields

import numpy as np

from viscodesign.model.bellow_law import BellowLaws
from viscodesign.model.scene_number import Numbers
from viscodesign.physics import bellow
from viscodesign.scene.scene import Scene


def bellow_laws(scene: Scene) -> BellowLaws:
    """The linear laws of all bellows."""
    if scene.members:
        return _side_by_side([bellow_laws(own) for own in scene.members.values()], scene)
    b, own = scene.bellows, scene.sections
    section_length = scene.actuator.length / (b.count // 2)
    modulus, moved = own.of_bellows(own.each("youngs_modulus")), moving_bellows(scene)
    rest = bellow.rest_volume(b.each("height"), b.each("width"), b.each("length"))
    return BellowLaws(
        length=b.each("length"),
        rest_volume=rest,
        compliance=bellow.compliance(b.each("length"), b.each("area_per_pressure")),
        curvature_per_pressure=moved
        * bellow.curvature_per_pressure(b.each("angle_per_pressure"), modulus, section_length),
        stretch_per_pressure=moved
        * bellow.stretch_per_pressure(b.each("extension_per_pressure"), modulus, section_length),
        floor_volume=b.each("collapse_fraction") * rest,
    )


def _side_by_side(laws: Sequence[BellowLaws], scene: Scene) -> BellowLaws:
    """The laws of all bellows of actuators that share fluid: the right ones, then the left ones."""
    counts = [own.bellows.count // 2 for own in scene.members.values()]

    def of_all(name: str) -> np.ndarray:
        each = [
            np.broadcast_to(getattr(own, name), 2 * n).reshape(2, n)
            for own, n in zip(laws, counts, strict=True)
        ]
        return np.concatenate(each, axis=1).ravel()

    return BellowLaws(**{f.name: of_all(f.name) for f in fields(BellowLaws)})


def moving_bellows(scene: Scene) -> Numbers:
    """One for a bellow that strains its section, zero where the section is blocked (B,)."""
    own = scene.sections
    return 1.0 if own.blocked is None else own.of_bellows(np.where(own.blocked, 0.0, 1.0))
