"""The mappings of a scene cannot be changed in place, and are dictionaries in every other way."""

from __future__ import annotations

import copy
import json
import pickle
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from tests.scenes import ACTUATOR_SPECS, CONFIGS, ROBOT_SPECS, SEVERAL_SPECS, leg
from viscodesign import Scene, load
from viscodesign.errors import UsageError
from viscodesign.loading import load_any
from viscodesign.scene.read_only import ReadOnlyDict, read_only
from viscodesign.scene.spec_part import SpecPart, copied

RICH = {
    "network.changes": {"R1-R2": {"length": "40 mm"}},
    "effects": {"gravity": "off"},
    "uncertainty": {"actuator.length": "5 %"},
    "sections": {"1": {"youngs_modulus": "1 MPa"}},
    "bellows.changes": {"R1": {"height": "9 mm"}},
    "inputs": {"inlet": {"kind": "constant", "value": "5 kPa"}},
    "input": None,
}
MAPPINGS: dict[str, Callable[[Scene], Any]] = {
    "effects": lambda scene: scene.effects.modes,
    "inputs": lambda scene: scene.inputs,
    "one input": lambda scene: leg().inputs,
    "tubes": lambda scene: scene.network.changes,
    "bellows": lambda scene: scene.bellows.changes,
    "sections": lambda scene: scene.section_changes,
    "uncertainty": lambda scene: scene.uncertainty and scene.uncertainty.spreads,
    "default": lambda scene: leg().network.changes,
    "copied": lambda scene: copied(scene.effects, {"modes": {"gravity": "on"}}).modes,
    "updated": lambda scene: scene.effects.model_copy(update={"modes": {"gravity": "on"}}).modes,
}
CHANGES: dict[str, Callable[[Any], Any]] = {
    "update": lambda found: found.update(any=1),
    "set": lambda found: found.__setitem__("any", 1),
    "delete": lambda found: found.__delitem__(next(iter(found), "")),
    "or": lambda found: found.__ior__({"any": 1}),
    "pop": lambda found: found.pop("any", None),
    "popitem": lambda found: found.popitem(),
    "clear": lambda found: found.clear(),
    "setdefault": lambda found: found.setdefault("any", 1),
}


@pytest.fixture(scope="module")
def rich() -> Scene:
    return leg().replace(RICH)


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
@pytest.mark.parametrize("mapping", MAPPINGS.values(), ids=MAPPINGS)
def test_no_mapping_of_a_scene_changes_in_place(
    mapping: Callable[[Scene], Any], change: Callable[[Any], Any], rich: Scene
) -> None:
    found = mapping(rich)
    before = dict(found)
    with pytest.raises(UsageError, match=r"not changed but replaced: scene\.replace\("):
        change(found)
    assert found == before


def _mappings(value: Any, place: str = "") -> Iterator[tuple[str, Any]]:
    """All mappings that a part of a spec has, also those that follow from its fields."""
    if isinstance(value, SpecPart):
        named = {**vars(value), **{n: getattr(value, n) for n in ("inputs", "sources", "scenes")
                                   if n in dir(value)}}  # fmt: skip
        for name, own in named.items():
            yield from _mappings(own, f"{place}.{name}")
    elif isinstance(value, Mapping):
        yield place, value
        for name, own in value.items():
            yield from _mappings(own, f"{place}.{name}")


@pytest.mark.parametrize("config", sorted(CONFIGS.glob("*.yaml")), ids=lambda path: path.stem)
def test_a_bundled_spec_has_no_mapping_that_changes(config: Any) -> None:
    scene = load_any(config)
    assert [place for place, own in _mappings(scene) if not isinstance(own, ReadOnlyDict)] == []
    assert list(_mappings(scene))


def test_nested_mappings_are_read_only_too() -> None:
    found = read_only({"columns": {"time": {"column": "t"}}})
    with pytest.raises(UsageError, match="not changed but replaced"):
        found["columns"]["time"]["column"] = "t_s"


def test_a_scene_with_mappings_is_copied_pickled_dumped_and_compared(rich: Scene) -> None:
    for same in (
        copy.copy(rich),
        copy.deepcopy(rich),
        pickle.loads(pickle.dumps(rich)),
        rich.model_copy(deep=True),
        load(rich.model_dump()).with_source(rich.source),
        load(json.loads(rich.model_dump_json())).with_source(rich.source),
    ):
        assert same == rich
        assert hash(same) == hash(rich)
        assert isinstance(same.effects.modes, ReadOnlyDict)
    dumped = rich.model_dump()["network"]["changes"]
    assert type(dumped) is dict
    assert repr(rich.effects.modes) == repr(dict(rich.effects.modes))


def test_what_is_made_of_a_mapping_may_be_changed(rich: Scene) -> None:
    for own in (dict(rich.effects.modes), rich.effects.modes.copy(), rich.effects.modes | {}):  # type: ignore[attr-defined]
        own["gravity"] = "auto"
    assert rich.effects.modes["gravity"] == "off"


@pytest.mark.parametrize("spec", [*ACTUATOR_SPECS, *ROBOT_SPECS, *SEVERAL_SPECS], ids=str)
def test_a_scene_equals_the_one_that_its_data_load_to(spec: Path) -> None:
    """Wherever it was read from."""
    scene = load_any(spec)
    again = load_any(scene.model_dump())
    assert again.source != scene.source
    assert again == scene
    assert hash(again) == hash(scene)
    other = load_any(spec, ["ambient_pressure=90 kPa"])
    assert other != scene
    assert scene != scene.name
