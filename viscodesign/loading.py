"""Reading a spec with the effects of this version."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from viscodesign.effects.catalogue import effect_names, option_kinds
from viscodesign.scene.effects_choice import KnownEffects
from viscodesign.scene.reading.document import Document
from viscodesign.scene.reading.json_schema import spec_schema
from viscodesign.scene.reading.read import Overrides, load_scene, scene_of
from viscodesign.scene.reading.read_robot import is_robot, robot_of
from viscodesign.scene.reading.read_several import is_several, several_of
from viscodesign.scene.reading.sources import ReadSpec, SpecSource, read_spec
from viscodesign.scene.reading.write import plain_part
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene


def known_effects() -> KnownEffects:
    """Names and options that a spec may use under `effects:`."""
    return KnownEffects(effect_names(), option_kinds())


def load(source: SpecSource, overrides: Overrides = ()) -> Scene:
    """Read a spec.

    ``source``: a path, an open file, the text of a spec (a string with a line break, or in
    braces), or a mapping of its keys; names of tables are relative to the file, or else to the
    current folder. ``overrides``: values by key, such as ``{"network.tube_length": 0.2}``, or
    texts 'network.tube_length=0.2 m'. Numbers are SI, texts may have a unit.

    Raises `SpecError` with all faults.
    """
    return load_scene(source, overrides, known_effects())


def load_robot(source: SpecSource, overrides: Overrides = ()) -> RobotScene:
    """Read the spec of a robot: one with the key `robot:`. Arguments as of `load`.

    Raises `SpecError` with all faults.
    """
    return robot_of(read_spec(source), overrides, known_effects())


def load_several(source: SpecSource, overrides: Overrides = ()) -> SeveralScene:
    """Read a spec of several actuators: one with the key `actuators:`. Arguments as of `load`.

    Raises `SpecError` with all faults.
    """
    return several_of(read_spec(source), overrides, known_effects())


def load_any(source: SpecSource, overrides: Overrides = ()) -> Scene | RobotScene | SeveralScene:
    """Read a spec of any kind. Arguments as of `load`."""
    spec = read_spec(source)
    if is_robot(spec):
        return robot_of(spec, overrides, known_effects())
    read = several_of if is_several(spec) else scene_of
    return read(spec, overrides, known_effects())


def load_pumped(source: SpecSource, overrides: Overrides = ()) -> Scene:
    """What a pump feeds: one actuator, or several as one scene. Arguments as of `load`."""
    spec = read_spec(source)
    if is_several(spec):
        return several_of(spec, overrides, known_effects()).pumped
    return scene_of(spec, overrides, known_effects())


def replaced(scene: Scene, changes: Mapping[str, Any]) -> Scene:
    """A scene with other values of some keys, checked like a loaded one."""
    return scene_of(_read_again(scene), changes, known_effects())


def checked(scene: Scene) -> Scene:
    """A scene whose values nobody has checked, checked like a loaded one."""
    return replaced(scene, {})


def checked_several(scene: SeveralScene) -> SeveralScene:
    """Several actuators whose values nobody has checked, checked like loaded ones."""
    return several_of(_read_again(scene), {}, known_effects())


def checked_robot(scene: RobotScene) -> RobotScene:
    """A robot whose values nobody has checked, checked like a loaded one."""
    return robot_of(_read_again(scene), {}, known_effects())


def _read_again(scene: Scene | SeveralScene | RobotScene) -> ReadSpec:
    folder = Path(scene.source.file).parent
    return ReadSpec(Document("", plain_part(scene)), folder, scene.source)


def schema() -> dict[str, Any]:
    """The JSON Schema of a spec, for editors."""
    return spec_schema(known_effects())
