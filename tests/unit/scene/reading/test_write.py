"""A resolved spec is runnable and means the same scene, to the last bit."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jsonschema
import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.scenes import ACTUATOR_SPECS, CONFIGS, leg
from viscodesign import Scene, load
from viscodesign.loading import known_effects, schema
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.reading.write import resolved_yaml

GOOD = (CONFIGS / "leg_16_straight_air.yaml").read_text()


def again(scene: Scene) -> dict[str, Any]:
    """The scene that the resolved spec of another one gives."""
    return parse_scene(resolved_yaml(scene).encode(), known=known_effects()).model_dump()


@pytest.mark.parametrize("config", [p.stem for p in ACTUATOR_SPECS])
def test_a_resolved_spec_is_the_same_scene(config: str) -> None:
    scene = load(CONFIGS / f"{config}.yaml")
    assert again(scene) == scene.model_dump()
    jsonschema.Draft202012Validator(schema()).validate(yaml.safe_load(resolved_yaml(scene)))


POSITIVE = st.floats(min_value=1e-9, max_value=1e9)


@given(length=POSITIVE, viscosity=POSITIVE, value=st.floats(-1e9, 1e9), fraction=st.floats(0, 0.99))
@settings(max_examples=25, deadline=None)
def test_numbers_survive_a_round_trip_exactly(
    length: float, viscosity: float, value: float, fraction: float
) -> None:
    scene = leg(
        f"actuator.length={length!r}",
        f"bellows.collapse_fraction={fraction!r}",
        f"fluid={{name: honey, viscosity: {viscosity!r}, density: 1420.0}}",
        f"input={{kind: table, rows: [[0, {value!r}], [{length!r}, 3 kPa]], transient_time: 1}}",
    )
    assert again(scene) == scene.model_dump()


@pytest.mark.parametrize(
    "overrides",
    [
        ["run={duration: 1 ns}"],
        ["run={duration: 1 min, output_times: [0, 1, 60]}"],
        ["loads={gravity: {tilt: 90 deg}, payload: 20 g, tip_force: {x: 1}}"],
        ["name='on'"],
        ["name='1e5'"],
        ["effects=off"],
        ["pump={syringe_diameter: 34.9 mm, servo_id: {inlet: 3}, sensor: {channel: 0}, "
         "limit_switches: {low: D1, high: D2}}"],
        ["network.changes={R2-R1: {radius: 1 mm}}"],
        ["input=null", "inputs={inlet: {kind: step, value: 3 kPa}}"],
    ],
)  # fmt: skip
def test_words_and_parts_survive_a_round_trip(overrides: list[str]) -> None:
    scene = leg(*overrides)
    assert again(scene) == scene.model_dump()


def test_a_table_file_resolves_to_rows(tmp_path: Path) -> None:
    (tmp_path / "in.csv").write_text("time_s,pressure_pa\n0,0\n1,1e3\n1,2e3\n4,0\n")
    file = tmp_path / "leg.yaml"
    start, end = GOOD.index("input:"), GOOD.index("loads:")
    file.write_text(GOOD[:start] + "input: {kind: table, file: in.csv}\n" + GOOD[end:])
    scene = load(file)
    other = tmp_path / "elsewhere.yaml"
    other.write_text(resolved_yaml(scene))
    assert "\n  file:" not in other.read_text()
    assert load(other).model_dump() == scene.model_dump()
