"""The linear laws of a scene's bellows, one by one where bellows or sections differ."""

from __future__ import annotations

import numpy as np

from viscodesign.model.bellow_law import BellowLaws
from viscodesign.model.scene_number import Numbers
from viscodesign.physics import bellow
from viscodesign.scene.scene import Scene


def bellow_laws(scene: Scene) -> BellowLaws:
    """The linear laws of all bellows."""
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


def moving_bellows(scene: Scene) -> Numbers:
    """One for a bellow that strains its section, zero where the section is blocked (B,)."""
    own = scene.sections
    return 1.0 if own.blocked is None else own.of_bellows(np.where(own.blocked, 0.0, 1.0))
