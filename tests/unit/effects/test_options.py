"""Options that an effect brings: keys of a spec like all others, in the effect's own file."""

from __future__ import annotations

import copy
import importlib
import json
import pickle
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
import yaml
from pydantic import Field

from tests.scenes import CONFIGS, ROOT, leg
from tests.trajectories import made_run
from viscodesign import Scene, Trajectory, compile, effects, load, load_several
from viscodesign.calibration.fitted_spec import fitted_scene, spec_text
from viscodesign.cli import completion
from viscodesign.cli.main import main
from viscodesign.compiled.free_keys import FreeKeys, candidates
from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import _catalogue
from viscodesign.effects.effects_key import scene_key
from viscodesign.errors import SpecError, UsageError
from viscodesign.inverse.alternatives import with_modes_of
from viscodesign.loading import schema
from viscodesign.pump.planning.scene_variants import planned
from viscodesign.report.run_folder import write_run
from viscodesign.results.fit_result import FittedNumber
from viscodesign.scene.reading.edit import with_value
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.spec_part import SpecPart
from viscodesign.studies.all_effects import with_felt_effects
from viscodesign.studies.stated_uncertainty import stated_deviations
from viscodesign.studies.swept_keys import swept_keys
from viscodesign.units import Length

CONFIG = "leg_4_air"
TEXT = (CONFIGS / f"{CONFIG}.yaml").read_text(encoding="utf-8")
DISTANCE, STIFFNESS, DEEPEST = (
    "effects.wall.distance",
    "effects.wall.stiffness",
    "effects.wall.deepest",
)
STATED = {"distance": 0.03, "stiffness": 500.0, "deepest": 5e-3}


@pytest.fixture(autouse=True)
def wall(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A catalogue with the wall of `examples/extending`, as if its file stood in the folder."""
    shutil.copy(ROOT / "examples" / "extending" / "wall.py", tmp_path)
    monkeypatch.setattr(effects, "__path__", [*effects.__path__, str(tmp_path)])
    _catalogue.cache_clear()
    yield
    _catalogue.cache_clear()
    sys.modules.pop("viscodesign.effects.wall", None)


def with_wall(*overrides: str) -> Scene:
    return leg(*overrides, config=CONFIG)


def stated(scene: Scene) -> dict[str, Any]:
    """The wall of a scene, as plain data."""
    found: dict[str, Any] = scene.model_dump()["effects"]["wall"]
    return found


# -- what a spec may say ------------------------------------------------------------


@pytest.mark.parametrize(
    ("overrides", "expected"),
    [
        (["effects.wall=on"], {"mode": "on", **STATED, "distance": 0.02}),
        (["effects.wall={mode: auto, distance: 3 cm}"], {"mode": "auto", **STATED}),
        (["effects.wall={distance: 30 mm}"], STATED),
        ([f"{DISTANCE}=30mm"], STATED),
        (["effects.wall=on", f"{DISTANCE}=30mm"], {"mode": "on", **STATED}),
        (["effects.wall={distance: 30 mm}", "effects.wall=off"], {"mode": "off", **STATED}),
        ([f"{DISTANCE}=0.03", f"{STIFFNESS}=0.5 N/mm", "effects.wall.mode=on"], {"mode": "on", **STATED}),
    ],
)  # fmt: skip
def test_modes_and_options_stand_together(overrides: list[str], expected: dict[str, Any]) -> None:
    scene = with_wall(*overrides)
    assert stated(scene) == expected
    assert scene.effects.mode("wall") == expected.get("mode", scene.effects.others)


def test_a_spec_that_does_not_name_an_effect_leaves_its_options_out() -> None:
    scene = with_wall()
    assert "wall" not in scene.model_dump()["effects"]
    assert "wall" not in resolved_yaml(scene)


def test_a_word_for_all_effects_stays_when_one_is_set() -> None:
    """`effects: off` is short for `{others: off}`, as `wall: on` is for `{mode: on}`."""
    scene = with_wall("effects=off", f"{DISTANCE}=30mm")
    assert scene.effects.others == "off"
    changed = with_value("effects: off\n", ["effects", "gravity"], "on")
    assert changed == "effects: {others: off, gravity: on}\n"


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("wall: {distance: 3 kg}", "effects.wall.distance: '3 kg' is a mass; expected a length"),
        ("wall: {distance: -3 mm}", "effects.wall.distance: must be above 0 m; got '-3 mm'"),
        (
            "wall: {distnce: 3 mm}",
            "effects.wall.distnce: no such key; did you mean 'distance'? "
            "Allowed here: mode, distance, stiffness, deepest",
        ),
        ("wall: {mode: maybe}", "effects.wall.mode: must be one of auto, on, off; got 'maybe'"),
        ("wall: maybe", "effects.wall: must be one of auto, on, off; got 'maybe'"),
        ("wall: {stiffness: [1]}", "effects.wall.stiffness: a list is not a number"),
        ("gravity: {tilt: 1}", "effects.gravity: this effect has no options; must be one of"),
        ("others: {mode: on}", "effects.others: must be one of auto, on, off; got a mapping"),
        ("wal: {distance: 3 mm}", "effects.wal: no such effect; did you mean 'wall'?"),
    ],
)
def test_every_fault_has_its_line_and_its_key(line: str, message: str) -> None:
    text = TEXT.replace("  others: off\n", f"  {line}\n")
    number = text.splitlines().index(f"  {line}") + 1
    with pytest.raises(SpecError) as caught:
        load(text)
    (fault,) = caught.value.faults
    assert fault.line == number
    assert str(fault).startswith(f"<text>:{number}: {message}")


def test_a_changed_text_keeps_what_a_word_said() -> None:
    text = TEXT.replace("  others: off\n", "  wall: on  # near\n")
    changed = with_value(text, DISTANCE.split("."), "30 mm")
    assert "  wall: {mode: on, distance: 30 mm}  # near" in changed
    again = with_value(changed, ["effects", "wall"], "off")
    assert stated(load(again)) == {"mode": "off", **STATED}


# -- scenes ---------------------------------------------------------------------------


def test_scenes_are_read_again_copied_and_compared() -> None:
    scene = with_wall("effects.wall=on", f"{DISTANCE}=30mm")
    for same in (
        load(scene.model_dump()),
        load(json.loads(scene.model_dump_json())),
        load(resolved_yaml(scene)),
        pickle.loads(pickle.dumps(scene)),
        copy.deepcopy(scene),
        with_wall("effects.wall={mode: on, distance: 3 cm}"),
        scene.model_copy(update={"name": scene.name}),
    ):
        assert same == scene
        assert stated(same) == {"mode": "on", **STATED}
    assert "distance: 0.03 m\n" in resolved_yaml(scene)
    assert with_wall("effects.wall=on") != scene
    assert scene_key(with_wall("effects.wall=on")) != scene_key(scene)


def test_other_modes_keep_the_options() -> None:
    scene = with_wall("effects.wall=on", f"{DISTANCE}=30mm")
    for other in (
        scene.replace({"effects.wall": "off"}),
        scene.replace({"effects.gravity": "off"}),
        scene.replace({"effects": scene.effects.with_modes({"gravity": "on"}, "off")}),
        with_felt_effects(scene),
        with_modes_of(with_wall().effects, scene),
        planned(scene),
    ):
        assert stated(other)["distance"] == 0.03
    nearer = scene.replace({DISTANCE: "10 mm"})
    assert stated(nearer) == {"mode": "on", **STATED, "distance": 0.01}
    copied = scene.effects.model_copy(update={"options": {"wall": {"distance": "4 cm"}}})
    assert copied.options["wall"].distance == 0.04


def test_actuators_share_them() -> None:
    scene = load_several(CONFIGS / "two_legs.yaml", ["effects.wall=on", f"{DISTANCE}=30mm"])
    found = [*scene.scenes.values(), *scene.joined]
    assert found
    assert all(stated(own) == {"mode": "on", **STATED} for own in found)


def test_a_run_is_read_again_without_the_catalogue(tmp_path: Path) -> None:
    """Which a page is made of, on whatever machine."""
    scene = with_wall("effects.wall={mode: on, distance: 30 mm}")
    again = parse_scene(resolved_yaml(scene).encode())
    assert again.effects.modes == scene.effects.modes
    assert not again.effects.options
    run = made_run(bellows=4, spec_text=resolved_yaml(scene))
    write_run(run, tmp_path / "run", plots=False)
    assert stated(load(Trajectory.read(tmp_path / "run").spec_text)) == {"mode": "on", **STATED}


# -- studies --------------------------------------------------------------------------


@pytest.mark.parametrize("overrides", [(), ("effects.wall=on",)], ids=["unsaid", "stated"])
def test_options_are_numbers_that_may_be_free(overrides: tuple[str, ...]) -> None:
    keys = FreeKeys(with_wall(*overrides), [DISTANCE])
    assert keys.values.tolist() == [0.02]
    assert str(keys.numbers[0].bounds) == "above 0"
    assert stated(keys.placed([0.05]))["distance"] == 0.05
    assert keys.validated([0.05]).effects.modes == with_wall(*overrides).effects.modes
    assert {DISTANCE, STIFFNESS, DEEPEST} <= set(candidates(with_wall(*overrides)))
    (swept,) = swept_keys(with_wall(*overrides), {DISTANCE: "10 mm..30 mm:3"})
    assert swept.is_free
    assert swept.values.grid() == pytest.approx((0.01, 0.02, 0.03))


@pytest.mark.parametrize("key", ["effects", "effects.wall", "effects.wall.mode", "effects.gravity"])
def test_modes_cannot_be_free(key: str) -> None:
    with pytest.raises(SpecError, match="which effects are included stays as it was chosen"):
        FreeKeys(with_wall(), [key])


def test_a_found_option_stays_where_a_fit_or_a_design_is_written() -> None:
    scene = with_wall("effects.wall=on")
    distance = FittedNumber(DISTANCE, 0.015, "m", 0.02, 0.014, 0.016)
    assert stated(fitted_scene(scene, [distance])) == {"mode": "on", **STATED, "distance": 0.015}
    lines = spec_text(fitted_scene(scene, [distance]), [distance]).splitlines()
    (line,) = [line for line in lines if line.startswith("    distance: ")]
    assert line == "    distance: 0.015 m  # 95 %: 0.014 to 0.016"


def test_an_unknown_option_cannot_be_free() -> None:
    with pytest.raises(SpecError, match=f"no such number in this scene; did you mean '{DISTANCE}'"):
        FreeKeys(with_wall(), ["effects.wall.distanc"])


def test_how_well_an_option_is_known_can_be_stated() -> None:
    scene = with_wall("effects.wall=on", f"uncertainty={{{DISTANCE}: 10 %}}")
    assert stated_deviations(scene)[DISTANCE].deviation == pytest.approx(0.002)


def test_the_tip_follows_the_wall_with_exact_slopes() -> None:
    """Pressed by its bellows against a wall, the tip moves as the wall does."""
    scene = leg(
        "effects={others: off, wall: {mode: on, distance: 5 mm}}",
        "run={duration: 1 s, output_interval: 1 s}",
        config="steady_right",
    )
    pressed = compile(scene, [DISTANCE, STIFFNESS], ["tip_x_m"])
    slopes = pressed.jacobian()["tip_x_m"][-1]
    steps = 1e-5 * pressed.values
    for k, step in enumerate(steps):
        ends = [
            pressed(pressed.values + sign * step * np.eye(2)[k])["tip_x_m"][-1] for sign in (1, -1)
        ]
        assert slopes[k] == pytest.approx((ends[0] - ends[1]) / (2 * step), rel=1e-4)
    assert slopes[0] > 0.5
    assert pressed()["tip_x_m"][-1] > 5e-3
    off = scene.replace({"effects.wall": "off"})
    with pytest.raises(SpecError, match="effects that would are not included: wall"):
        compile(off, [DISTANCE], ["tip_x_m"])


# -- what tells of them -----------------------------------------------------------------


def test_the_schema_has_them() -> None:
    found = schema()
    jsonschema.Draft202012Validator.check_schema(found)
    spec = yaml.safe_load(resolved_yaml(with_wall("effects.wall=on")))
    jsonschema.validate(spec, found)
    for wrong in ({"distnce": 1}, {"distance": -1.0}, {"mode": "maybe"}, "maybe"):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate({**spec, "effects": {"wall": wrong}}, found)


def test_pages_and_completion_list_them(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["effects", "wall"]) == 0
    page = " ".join(capsys.readouterr().out.split())
    assert "effects.wall.distance From the clamp's axis, towards R; a length above 0 m" in page
    assert "default 0.02 m" in page
    assert main(["effects", "wall", "--json"]) == 0
    (found,) = json.loads(capsys.readouterr().out)["effects"]
    assert [own["key"] for own in found["options"]] == [DISTANCE, STIFFNESS, DEEPEST]
    assert found["options"][1]["unit"] == "N/m"
    monkeypatch.syspath_prepend(ROOT / "docs")
    rows = {
        row[0]: row
        for _, _, rows in importlib.import_module("keys_table").sections()
        for row in rows
    }
    assert rows[f"`{DISTANCE}`"][2:] == ("`m`", "0.02 m", "> 0", "`wall`")
    assert (f"{DISTANCE}=", "From the clamp's axis, towards R") in completion.override_keys(
        DISTANCE
    )
    assert [word for word, _ in completion.override_keys("effects.wall.mode=o")] == [
        "effects.wall.mode=on", "effects.wall.mode=off",
    ]  # fmt: skip


def test_every_option_has_a_default_and_none_is_the_mode() -> None:
    class Required(SpecPart):
        distance: Length

    class Mode(SpecPart):
        own: str = Field("on", alias="mode")

    for options, wrong in ((Required, "has no default"), (Mode, "is the key of the effect's mode")):
        with pytest.raises(UsageError, match=wrong):
            type("Wrong", (Effect,), {"options": options})
