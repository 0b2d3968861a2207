"""The examples run and print something; the parts of `examples/extending` work as parts."""

from __future__ import annotations

import json
import os
import runpy
import shutil
import subprocess
import sys
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from tests.contract import test_effects as contract
from tests.scenes import CONFIGS, ROOT
from viscodesign import effects
from viscodesign.effects.catalogue import _catalogue

EXTENDING = ROOT / "examples" / "extending"
LEVEL, RAMP = 10e3, 0.5
"""Pressure [Pa] that the left inlet reaches, and the time [s] that it takes; the right: minus that."""
WALL, STIFFNESS = 0.02, 500.0
"""Where the wall stands [m], and its force per depth [N/m]."""
STATED_ERROR = 0.005 * 0.109
"""Accuracy of the scene times the actuator's length [m]."""


@pytest.mark.parametrize("example", sorted(p.name for p in (ROOT / "examples").glob("*.py")))
def test_example_runs(example: str, capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(ROOT / "examples" / example))
    assert len(capsys.readouterr().out.splitlines()) >= 2


@dataclass(frozen=True)
class Installation:
    """An environment in which the package of `examples/extending` is installed."""

    site: Path
    runs: Path

    def python(self, *arguments: str) -> subprocess.CompletedProcess[str]:
        """What Python does in this environment."""
        paths = [str(ROOT), str(self.site), str(EXTENDING)]
        return subprocess.run(
            [sys.executable, *arguments],
            capture_output=True,
            text=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(paths)},
            cwd=self.runs,
            check=False,
        )

    def viscodesign(self, *arguments: str) -> str:
        """Standard output of a command that has to succeed."""
        done = self.python("-m", "viscodesign", *arguments)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def json(self, *arguments: str) -> Any:
        """The document that a command prints."""
        return json.loads(self.viscodesign(*arguments, "--json"))

    def motion(self, name: str, *changes: str) -> pd.DataFrame:
        """`trajectory.csv` of a leg that two ramps bend to the right."""
        ramps = (
            f"inputs.{inlet}={{kind: ramp_hold, level: {sign}{LEVEL} Pa, ramp: {RAMP} s}}"
            for inlet, sign in (("left", ""), ("right", "-"))
        )
        words = [word for change in (*ramps, *changes) for word in ("--set", change)]
        leg = str(CONFIGS / "steady_right.yaml")
        self.viscodesign("simulate", leg, *words, "-o", name, "--quiet")
        return pd.read_csv(self.runs / name / "trajectory.csv")


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Installation:
    """What `pip install examples/extending` leaves: its metadata, beside its modules."""
    project = tomllib.loads((EXTENDING / "pyproject.toml").read_text())["project"]
    site = tmp_path_factory.mktemp("site")
    metadata = site / f"{project['name'].replace('-', '_')}-{project['version']}.dist-info"
    metadata.mkdir()
    (metadata / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: {project['name']}\nVersion: {project['version']}\n"
    )
    (metadata / "entry_points.txt").write_text(
        "".join(
            f"[{group}]\n" + "".join(f"{name} = {module}\n" for name, module in points.items())
            for group, points in project["entry-points"].items()
        )
    )
    return Installation(site, tmp_path_factory.mktemp("runs"))


def test_an_installed_effect_is_listed(installed: Installation) -> None:
    listed = {effect["name"] for effect in installed.json("effects")["effects"]}
    assert {"wall", "gravity"} <= listed


@pytest.fixture(scope="module")
def free(installed: Installation) -> pd.DataFrame:
    return installed.motion("free")


def test_the_wall_keeps_the_contract_of_effects(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As if its file stood in the family's folder."""
    shutil.copy(EXTENDING / "wall.py", tmp_path)
    monkeypatch.setattr(effects, "__path__", [*effects.__path__, str(tmp_path)])
    _catalogue.cache_clear()
    try:
        contract.test_weight_is_finite_and_explained("wall")
        contract.test_its_contribution_is_estimated("wall")
        contract.test_jacobian_equals_differences("wall")
        contract.test_no_force_at_rest_but_steady_load("wall")
    finally:
        _catalogue.cache_clear()


def test_the_wall_holds_the_tip_back(installed: Installation, free: pd.DataFrame) -> None:
    held = installed.motion("held", "effects.wall=on")
    apart = (free.tip_x_m - held.tip_x_m).to_numpy()
    touching = held.tip_x_m.to_numpy() > WALL
    assert np.max(np.abs(apart[~touching])) <= STATED_ERROR
    assert held.tip_x_m.max() < WALL + 0.2 * (free.tip_x_m.max() - WALL)
    # The wall's force as a load on a free tip leads to the same place.
    depth = held.tip_x_m.iloc[-1] - WALL
    pushed = installed.motion("pushed", f"loads.tip_force.x={-STIFFNESS * depth} N")
    for column in ("tip_x_m", "tip_z_m"):
        assert pushed[column].iloc[-1] == pytest.approx(held[column].iloc[-1], abs=STATED_ERROR)


def test_there_is_no_wall_unless_the_spec_asks_for_it(installed: Installation) -> None:
    leg = str(CONFIGS / "leg_4_air_auto.yaml")
    verdicts = {effect["name"]: effect for effect in installed.json("check", leg)["effects"]}
    assert not verdicts["wall"]["present"]


def test_the_wall_stands_where_its_options_say(installed: Installation) -> None:
    """And a run warns where the tip is too deep in it, by the effect's own limit."""
    options = "effects.wall={mode: on, distance: 10 mm, stiffness: 0.1 N/mm, deepest: 1 mm}"
    installed.motion("soft", options)
    found = json.loads((installed.runs / "soft" / "summary.json").read_text())
    (told,) = [own for own in found["warnings"] if own["code"] == "deep_in_wall"]
    depth = found["metrics"]["tip_x_max_m"] - 0.01
    assert f"{1e3 * depth:.3g} mm inside the wall" in told["message"]
    assert "distance: 0.01 m" in (installed.runs / "soft" / "spec.yaml").read_text()
    wrong = installed.python(
        *("-m", "viscodesign", "check", str(CONFIGS / "steady_right.yaml")),
        *("--set", "effects.wall.distance=3 kg"),
    )
    assert wrong.returncode == 2
    assert "effects.wall.distance: '3 kg' is a mass; expected a length" in wrong.stderr


def test_the_ramp_reaches_its_level_and_holds_it(free: pd.DataFrame) -> None:
    expected = LEVEL * np.minimum(free.time_s.to_numpy() / RAMP, 1.0)
    assert free.inlet_pressure_left_pa.to_numpy() == pytest.approx(expected, abs=1e-6)
    assert free.inlet_pressure_right_pa.to_numpy() == pytest.approx(-expected, abs=1e-6)


STEPPER = "pump={kind: stepper, syringe_diameter: 34.9 mm, home: 60000}"
AREA = np.pi * 0.0349**2 / 4
"""Cross section of its barrel [m2]."""


def test_a_stepper_driven_syringe_is_planned_with_the_plunger_of_the_package(
    installed: Installation,
) -> None:
    """Barrel, bellows and tubes are one closed vessel of gas (Boyle)."""
    pressure, count = 12e3, 4
    changes = (
        STEPPER,
        "fluid=air",
        "temperature=20 degC",
        f"input={{kind: constant, value: {pressure} Pa}}",
        "run={duration: 1 s}",
        f"bellows.count={count}",
        "effects={feedback: off, others: auto}",
    )
    words = [word for change in changes for word in ("--set", change)]
    leg = str(CONFIGS / "leg_4_air_auto.yaml")
    plan = installed.json("pump", "plan", leg, *words, "-o", "stepper", "--no-plots")
    table = pd.read_csv(installed.runs / "stepper" / "plan.csv")

    step = 2e-3 / 3200
    ratio, barrel = 1.0 + pressure / 101325.0, AREA * (0.1045 - 60000 * step) + 5e-6
    walls = count * 18e-3 * 3.413e-9 * pressure
    others = count * (10e-3 * 12e-3 * 18e-3 + np.pi * 0.325e-3**2 * 37.5e-3)
    swept = barrel - ((barrel + others) / ratio - others - walls)
    last = table.iloc[-1]
    assert last.wanted_volume_m3 == pytest.approx(swept, rel=1e-6)
    assert last.wanted_step == pytest.approx(60000 + swept / AREA / step, rel=1e-6)
    # It holds without friction, and at most loses steps at its thrust.
    assert last.wanted_force_n == pytest.approx(pressure * AREA)
    assert last.wanted_stall_share == pytest.approx(pressure * AREA / 120.0)
    verdicts = {verdict["name"]: verdict for verdict in plan["verdicts"]}
    assert verdicts["stall"]["wanted"] == pytest.approx(pressure * AREA + 5.0)
    assert verdicts["stall"]["unit"] == "N"
    assert verdicts["resolution"]["unit"] == "steps"
    assert plan["stepper"] == "a stepper motor with 3200 steps per turn"
    assert plan["numbers"]["inlet"]["volume_per_step_m3"] == pytest.approx(AREA * step)
    assert {"battery", "one_fifth", "speed_register"}.isdisjoint(verdicts)


def test_a_stepper_driven_syringe_needs_nothing_of_the_servos(installed: Installation) -> None:
    code = "import sys, stepper_pump; print([m for m in sys.modules if 'pump.ax' in m])"
    assert installed.python("-c", code).stdout == "[]\n"


def test_a_kind_that_is_only_planned_is_refused_where_something_would_move(
    installed: Installation,
) -> None:
    leg = str(CONFIGS / "leg_16_pump.yaml")
    done = installed.python("-m", "viscodesign", "pump", "stream", leg, "--set", STEPPER)
    assert done.returncode == 2
    assert "a pump of kind stepper can only be planned" in done.stderr
    assert "Traceback" not in done.stderr
