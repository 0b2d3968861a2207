"""From the spec of several actuators to its scenes; all faults of the file are reported at once."""

from __future__ import annotations

from viscodesign.scene.effects_choice import KnownEffects
from viscodesign.scene.reading.document import ACTUATORS_KEY, ROBOT_KEY
from viscodesign.scene.reading.read import Overrides, with_provenance
from viscodesign.scene.reading.read_robot import read_as
from viscodesign.scene.reading.sources import ReadSpec
from viscodesign.scene.several_scene import SeveralScene


def is_several(spec: ReadSpec) -> bool:
    """Whether a spec has several actuators, and no robot that walks on them."""
    return ACTUATORS_KEY in spec.document.data and ROBOT_KEY not in spec.document.data


def several_of(
    spec: ReadSpec, overrides: Overrides = (), known: KnownEffects | None = None
) -> SeveralScene:
    """The actuators of a spec with some keys overridden. Raises `SpecError` with all faults."""
    return with_provenance(read_as(SeveralScene, spec, overrides, known), spec)
