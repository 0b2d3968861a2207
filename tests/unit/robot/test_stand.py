"""How a robot stands, against closed forms and the published numbers."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

from tests.robots import hexapod
from viscodesign import StandStudy, stand, walk
from viscodesign.cli.main import main
from viscodesign.errors import SolveError, SpecError, UsageError
from viscodesign.robot.build_robot import build_robot
from viscodesign.robot.stance import stance

EI, EA = 1.8e6 * 0.02 * 0.03**3 / 12 * 0.55, 1.8e6 * 0.03 * 0.02 * 0.53
SECTION = 0.109 / 8
UPRIGHT = [
    f"robot.legs.{name}.{key}=0"
    for name in ("LF", "RF", "LM", "RM", "LR", "RR")
    for key in ("splay", "lean")
]


@pytest.fixture(scope="module")
def study() -> StandStudy:
    return stand(hexapod())


@pytest.fixture(scope="module")
def plain() -> StandStudy:
    """Without pillars."""
    return stand(hexapod("robot.stiff_sections=[]"))


def test_the_height_is_that_of_loaded_legs(study: StandStudy) -> None:
    own = stand(hexapod(*UPRIGHT)).own
    grown = 6 * 2 * 0.047 * 38.7e3 / 1.8e6
    pressed = 6 * SECTION * (0.734 - 6 * 0.007) * 9.80665 / 6 / EA
    assert own.height_m == pytest.approx(0.109 + grown - pressed + 0.015, abs=1e-6)
    assert study.own.height_m < own.height_m
    heights = [row.height_m for row in study.by_gauge]
    assert np.all(np.diff(heights) > 0)


def test_balance_and_friction_of_a_stance() -> None:
    found = stance(
        build_robot(hexapod("robot.centre_of_mass={x: 20 mm, y: 10 mm}")), np.full(2, 38.7e3)
    )
    normal, along = found.contact_forces.reshape(2, -1)
    weight = 0.734 * 9.80665
    assert np.sum(normal) == pytest.approx(weight, rel=1e-6)
    assert abs(np.sum(along)) < 1e-6 * weight
    assert np.min(normal) > 0
    assert np.min(normal[[0, 1]]) > np.max(normal[[4, 5]])  # the front carries more
    assert np.max(np.abs(found.model.gaps(found.place))) < 1e-6


def test_more_gauge_is_taller_and_weaker(study: StandStudy) -> None:
    """By more than half from 0 to 139 kPa, as a prototype found."""
    first, last = study.by_gauge[0], study.by_gauge[-1]
    assert last.gauge_pressure_pa == pytest.approx(140e3)
    assert last.height_m > 1.2 * first.height_m
    assert last.tip_stiffness_n_per_m < 0.5 * first.tip_stiffness_n_per_m
    assert last.sway_limit_n < first.sway_limit_n


def test_tip_stiffness_is_that_of_a_cantilever(plain: StandStudy) -> None:
    """3 EI/l^3 without load; a thrust N reduces it by 6 N/(5 l) to first order."""
    found = plain.by_gauge[0]
    thrust = found.weight_n / 6
    expected = 3 * EI / 0.109**3 - 6 * thrust / (5 * 0.109)
    assert found.tip_stiffness_n_per_m == pytest.approx(expected, rel=0.02)


def test_the_published_crouch_needs_more_than_a_barrel(plain: StandStudy) -> None:
    """132 mL as a liquid and 235 mL as a gas for 85 %; a barrel of 100 mL gives 93 %."""
    by_ratio = {row.height_ratio: row for row in plain.crouch}
    assert 1e6 * by_ratio[0.85].liquid_volume_m3 == pytest.approx(132, abs=1)
    assert 1e6 * by_ratio[0.85].barrel_volume_m3 == pytest.approx(235, abs=1)
    assert 1e6 * by_ratio[0.93].barrel_volume_m3 == pytest.approx(100, abs=1)


def test_a_point_foot_sways_at_the_buckling_load_of_its_legs() -> None:
    """Clamped legs on points that are free to turn: pi^2 EI/(4 l^2) each, of incompressible rods."""
    own = stand(
        hexapod(
            *UPRIGHT, "robot.stiff_sections=[]", "robot.foot.radius=0", "gauge_pressure=0",
            "actuators.leg.actuator.extension_factor=500", "robot.foot.mass=0.1 g",
        )
    ).own  # fmt: skip
    assert own.sway_limit_n == pytest.approx(6 * np.pi**2 * EI / (4 * 0.109**2), rel=2e-3)


def test_crouch_ratios_are_checked() -> None:
    with pytest.raises(UsageError, match=r"above 0 and below 1; got 1.5"):
        stand(hexapod(), height_ratios=(1.5,))


def test_no_stance_below_vacuum() -> None:
    with pytest.raises(
        SpecError, match=r"gauge_pressure: -150 kPa gauge at .* is -48.67 kPa absolute"
    ):
        stand(hexapod("gauge_pressure=-150 kPa"))


def test_a_stance_beyond_sway_is_refused_with_the_weight(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    spec = "configs/hexapod.yaml"
    status = main(
        ["stand", spec, "--set", "robot.payload=9 kg", "-o", str(tmp_path), "--no-plots", "--json"]
    )
    out, err = capsys.readouterr()
    document = json.loads(out)
    assert status == 3
    assert document["height_m"] is None
    limit = document["sway_limit_n"]
    assert f"its legs bear {limit:.4g} N" in err
    assert (tmp_path / "stand.csv").exists()
    assert document["weight_n"] > limit > 0.734 * 9.80665


ONE_SIDE = tuple(f"robot.legs.{name}.y=60 mm" for name in ("LF", "LM", "LR"))
FALLS = [
    (("robot.foot.friction=0",), "slides: without friction nothing holds its feet"),
    (("robot.ground.slope=32 deg",), "slides: on a slope of 32 deg .* tan(slope) = 0.625; robot.foot.friction is 0.6"),
    (ONE_SIDE, "tips over: its weight acts at x = .* beside its feet"),
    (("robot.centre_of_mass.x=120 mm",), "tips over: its weight acts at x = "),
]  # fmt: skip


@pytest.mark.parametrize(("changes", "told"), FALLS)
def test_a_robot_that_slides_or_tips_over_does_not_sway(
    changes: tuple[str, ...], told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    overrides = [word for change in changes for word in ("--set", change)]
    spec = ["configs/hexapod.yaml", *overrides, "-o", str(tmp_path), "--no-plots"]
    assert main(["stand", *spec]) == 3
    out, err = capsys.readouterr()
    pattern = told.replace("(", r"\(").replace(")", r"\)")
    assert re.search(f"the robot {pattern}", err)
    assert "sways" not in out + err
    how, _, why = pattern.partition(": ")
    with pytest.raises(SolveError, match=f"the robot {how} at the start: {why}"):
        walk(hexapod(*changes, "run.duration=5 s"))


def test_a_slope_within_friction_is_no_slide() -> None:
    assert stand(hexapod("robot.ground.slope=30 deg"), height_ratios=(0.95,)).fall is None
    assert stand(hexapod("robot.payload=9 kg"), height_ratios=(0.95,)).fall is None


def test_a_crouch_that_is_too_deep_says_why() -> None:
    reached, beyond = stand(hexapod(), height_ratios=(0.7, 0.6)).crouch
    told = "at -81.1 kPa gauge, the lowest tried, the legs keep 69 %"
    assert (reached.reason, beyond.reason) == ("", told)
    assert reached.gauge_pressure_pa > -81.1e3


def test_a_crouch_out_of_reach_is_not_met(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["-o", str(tmp_path), "--no-plots", "-q", "--crouch"]
    assert main(["stand", "configs/hexapod.yaml", *words, "0.9"]) == 0
    assert main(["stand", "configs/hexapod.yaml", *words, "0.5"]) == 3
    assert "not met: no crouch to 50 %" in capsys.readouterr().err
    assert (tmp_path / "stand.json").exists()


def test_the_command_prints_its_numbers(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["stand", "configs/hexapod.yaml", "-o", str(tmp_path)]) == 0
    text = capsys.readouterr().out
    assert "sways from" in text
    assert {file.name for file in tmp_path.iterdir()} == {"stand.csv", "stand.json", "stand.png"}
    document = json.loads((tmp_path / "stand.json").read_text())
    assert {"height_m", "sway_limit_n", "tip_stiffness_n_per_m"} <= set(document)
