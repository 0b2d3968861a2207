"""`init --measure`: a spec of one's own sizes, its coefficients estimated and marked."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from viscodesign import check, load, simulate
from viscodesign.cli.first_spec import first_spec
from viscodesign.cli.first_values import FORMATS
from viscodesign.errors import ViscodesignError

from .conftest import Call

OWN = (
    "actuator.youngs_modulus=0.3 MPa", "actuator.length=60 mm", "bellows.count=6",
    "bellows.angle_per_pressure=5 rad", "loads.gravity.tilt=90 deg", "fluid=water",
    "temperature=25 degC",
)  # fmt: skip


def marked(text: str) -> set[str]:
    return set(re.findall(r"(?m)^ *(\w+):[^#\n]*# ESTIMATE", text))


def test_it_runs_as_it_is_and_marks_every_estimate(call: Call, tmp_path: Path) -> None:
    path = tmp_path / "mine.yaml"
    outcome = call("init", path, "--measure")
    assert (outcome.status, outcome.out, outcome.err) == (0, f"{path}\n", "")
    assert marked(path.read_text()) == {key.split(".")[1] for key in FORMATS}
    scene = load(path)
    assert scene.name == "mine"
    assert check(scene).warnings == ()
    run = simulate(scene, verify=False)
    assert (run.status, run.validity, run.warnings) == ("complete", "inside", ())


def test_what_is_given_is_kept_and_not_an_estimate(call: Call, tmp_path: Path) -> None:
    path = tmp_path / "leg.yaml"
    words = [word for change in OWN for word in ("--set", change)]
    assert call("init", path, "--measure", "--wall", "0.8 mm", "--fold", "2 mm", *words).status == 0
    text, scene = path.read_text(), load(path)
    assert scene.actuator.length == pytest.approx(0.06)
    assert scene.bellows.count == 6
    assert scene.bellows.angle_per_pressure == 5.0
    assert scene.fluid.name == "water"
    assert scene.temperature == pytest.approx(298.15)
    assert scene.loads.gravity is not None
    assert re.search(r"angle_per_pressure: 5 rad +# given$", text, re.MULTILINE)
    assert marked(text) == {key.split(".")[1] for key in FORMATS} - {"angle_per_pressure"}
    assert "a wall of 0.8 mm with folds 2 mm deep" in text
    assert check(scene).warnings == ()


@pytest.mark.parametrize("modulus", ["30 kPa", "2 MPa", "100 MPa"])
@pytest.mark.parametrize("sizes", [(), ("bellows.height=6 mm", "network.tube_radius=0.6 mm")])
def test_the_pulse_suits_the_bellows(modulus: str, sizes: tuple[str, ...]) -> None:
    scene = load(first_spec("leg", [f"actuator.youngs_modulus={modulus}", *sizes], "1 mm", None))
    highest = scene.input.start  # type: ignore[union-attr]
    grown = scene.bellows.area_per_pressure * highest
    assert 0.0 < grown <= 0.4 * scene.bellows.height * scene.bellows.width
    assert highest <= 0.5 * scene.ambient_pressure
    check(scene)


def test_a_whole_section_may_be_given() -> None:
    scene = load(first_spec("leg", ["input={kind: constant, value: 5 kPa}"], "1 mm", "0 mm"))
    assert scene.input is not None
    assert scene.input.name == "constant"


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--wall", "9 mm"], "walls of 9 mm take 56 mm; actuator.height is 30 mm"),
        (["--wall", "0 mm"], "--wall 0 mm: must be above 0 m"),
        (["--fold=-1 mm"], "--fold -1 mm: must not be negative"),
        (["--wall", "thin"], "--wall thin: 'thin' has no number; expected a length"),
        (["--set", "bellows.width=40 mm"], "longer than actuator.length 109 mm"),
        (["--set", "bellows.length=19 mm"], "take 21 mm; actuator.width is 20 mm"),
        (["--set", "bellows.lenth=1 mm"], "did you mean 'length'?"),
        (["--set", "bellows.length"], "must have the form key.path=value"),
        (["--set", "bellows.angle_per_pressure=0"], "must be above 0 with --measure"),
        (["--template", "leg_4_air"], "--measure and --template are mutually exclusive"),
    ],
)
def test_what_cannot_be_is_refused(
    call: Call, tmp_path: Path, words: list[str], message: str
) -> None:
    outcome = call("init", tmp_path / "leg.yaml", "--measure", *words)
    assert outcome.status == 2
    assert message in outcome.err
    assert not (tmp_path / "leg.yaml").exists()


def test_sizes_without_measure_are_refused(call: Call, tmp_path: Path) -> None:
    outcome = call("init", tmp_path / "leg.yaml", "--wall", "1 mm")
    assert outcome.status == 2
    assert "belong to --measure" in outcome.err


def test_estimates_do_no_net_work() -> None:
    """The coupling of volumes and loads, while a pulse moves the leg."""
    text = first_spec("leg", ["fluid=water", "bellows.count=4"], "1 mm", None)
    pinned = (
        "effects={pressure_distribution: on, feedback: on, inertia: on, damping: on, others: off}"
    )
    wrong = f"bellows.area_per_moment={0.5 * load(text).bellows.area_per_moment}"
    works = [
        simulate(load(text, [pinned, *changes]), verify=False).invariants.coupling_work_j
        for changes in ((), (wrong,))
    ]
    assert works[0] is not None
    assert works[1] is not None
    assert abs(works[0]) < 1e-2 * abs(works[1])


def test_an_unknown_key_is_told() -> None:
    with pytest.raises(ViscodesignError, match="no such key"):
        first_spec("leg", ["colour=red"], "1 mm", None)
