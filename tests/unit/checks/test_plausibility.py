"""Numbers that are hardly meant are told once each, with the likely slip; no sound scene is."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.fuzz.commands import run_command
from tests.scenes import ACTUATOR_SPECS, CONFIGS, leg
from viscodesign import check, load
from viscodesign.checks.plausibility import plausibility_notices
from viscodesign.checks.plausible_ranges import RANGES
from viscodesign.errors import SpecError

OWN = "fluid={{name: own, viscosity: {}, density: {}, gas_constant: {}}}"
AIR = OWN.format("1.79e-5", 1.225, 287.05)
SLIPS = [
    # lengths
    (["actuator.length=109"], "actuator.length", "109 m is", "did you mean 109 mm?"),
    (["actuator.height=30"], "actuator.height", "30 m is", "30 mm?"),
    (["bellows.height=10"], "bellows.height", "10 m is", "10 mm?"),
    (["network.tube_radius=0.325"], "network.tube_radius", "325 mm is", "325 um?"),
    (["network.tube_length=37.5 km"], "network.tube_length", "37.5 km is", ""),
    (["network.feed_line={length: 500, radius: 1 mm}"], "network.feed_line.length", "500 m is", "500 mm?"),
    # moduli
    (["actuator.youngs_modulus=1.8 mPa"], "actuator.youngs_modulus", "1.8 mPa is", "1.8 MPa?"),
    (["actuator.youngs_modulus=1.8 GPa"], "actuator.youngs_modulus", "1.8 GPa is", "1.8 MPa?"),
    (["actuator.youngs_modulus=1.8"], "actuator.youngs_modulus", "1.8 Pa is", "MPa?"),
    (["actuator.youngs_modulus=1.8 kPa"], "actuator.youngs_modulus", "1.8 kPa is", "1.8 MPa?"),
    (["network.tube_wall={youngs_modulus: 10, thickness: 1 mm}"], "network.tube_wall.youngs_modulus", "10 Pa", ""),
    # fluids
    ([OWN.format("1.79e5", 1.225, 287.05)], "fluid.viscosity", "1.79e+05 Pa*s is", "1.79e-05 Pa*s?"),
    (["fluid={name: oil, viscosity: 1000, density: 950}"], "fluid.viscosity", "1000 Pa*s is", "1 Pa*s?"),
    ([OWN.format("1.79e-5", 1225, 287.05)], "fluid.density", "1e+03 times", "check density"),
    ([OWN.format("1.79e-5", "1.225e-3", 287.05)], "fluid.density", "0.001225", ""),
    ([OWN.format("1.79e-5", 1.225, 0.28705)], "fluid.gas_constant", "0.287", "287"),
    (["fluid={name: oil, viscosity: 0.01, density: 950, bulk_modulus: 2.2 kPa}"], "fluid.bulk_modulus", "2.2 kPa", ""),
    # surroundings
    ([AIR, "temperature=20"], "temperature", "20 K is", "did you mean 20 degC?"),
    ([AIR, "temperature=15"], "temperature", "15 K is", "15 degC?"),
    (["ambient_pressure=101.325"], "ambient_pressure", "101.3 Pa is", "101.3 kPa?"),
    (["ambient_pressure=10.13 MPa", AIR], "ambient_pressure", "10.13 MPa is", ""),
    (["actuator.density=0.95"], "actuator.density", "0.95 kg/m^3 is", "950 kg/m^3?"),
    (["actuator.density=950000"], "actuator.density", "9.5e+05 kg/m^3 is", "950 kg/m^3?"),
    (["actuator.damping_time=1000"], "actuator.damping_time", "1000 s is", "1 ms?"),
    # coefficients and loads beside the actuator
    (["bellows.area_per_pressure=3.413e-3 m^2/Pa"], "bellows.area_per_pressure", "0.003413 m^2/Pa is", "3.413e-09 m^2/Pa?"),
    (["bellows.area_per_pressure=3.413e-15 m^2/Pa"], "bellows.area_per_pressure", "far below", "3.413e-09 m^2/Pa?"),
    (["bellows.angle_per_pressure=-1e7 rad"], "bellows.angle_per_pressure", "far above", "-10 rad?"),
    (["bellows.extension_per_pressure=47 km"], "bellows.extension_per_pressure", "47 km is", "47 mm?"),
    (["bellows.area_per_force=0.3 m^2/N"], "bellows.area_per_force", "0.3 m^2/N is", "3e-07 m^2/N?"),
    (["bellows.area_per_moment=1.2 m^2/(N*m)"], "bellows.area_per_moment", "1.2 m^2/(N*m) is", "1.2e-06"),
    (["loads.payload=200 kg"], "loads.payload", "200 kg is", "did you mean 0.2 kg?"),
    (["loads.tip_force={x: -5 kN}"], "loads.tip_force.x", "-5000 N is", "-5 N?"),
    (["bellows.area_per_force=3e-7 mm^2/N"], "bellows.area_per_force", "3e-13 m^2/N is", "3e-07 m^2/N?"),
    (["loads.payload=20 kg"], "loads.payload", "20 kg is", "did you mean 0.02 kg?"),
    (["actuator.damping_time=1 s"], "actuator.damping_time", "1 s is", "did you mean 1 ms?"),
    (["network.tube_length=37.5 m"], "network.tube_length", "37.5 m is", "did you mean 37.5 mm?"),
    (["network.tube_length=37.5 um"], "network.tube_length", "37.5 um is", "did you mean 37.5 mm?"),
    (["network.changes={R1-R2: {length: 112.5}}"], "network.changes.R1-R2.length", "112.5 m is", "112.5 mm?"),
    (["loads.gravity={tilt: 90}"], "loads.gravity.tilt", "90 rad is", "did you mean 90 deg?"),
    # inputs and pumps
    (["input={kind: sine, amplitude: 141, frequency: 0.5}"], "input", "282 Pa in the bellows move the tip by", "another unit?"),
    (["input={kind: sine, amplitude: 20 kPa, frequency: 5 kHz}"], "input.frequency", "5000 Hz is", "did you mean 5 Hz?"),
    (["input={kind: sine, amplitude: 20 kPa, frequency: 1, phase: 90}"], "input.phase", "90 rad is", "90 deg?"),
    (["input={kind: step, value: 0.02, time: 1}"], "input", "0.02 Pa in the bellows", ""),
    (["pump={syringe_diameter: 34.9 mm, gear_play: 200}"], "pump.gear_play", "200 counts is", "2 counts?"),
    (["pump={syringe_diameter: 34.9}"], "pump.syringe_diameter", "34.9 m is", "34.9 mm?"),
    (["pump={syringe_diameter: 34.9 mm, max_pressure: 25 gauge}"], "pump.max_pressure", "25 Pa is", "25 kPa?"),
    # parts that do not fit
    (["bellows.height=40 mm"], "bellows.height", "a pair needs 80 mm", "actuator.height, 30 mm"),
    (["bellows.height=16 mm"], "bellows.height", "a pair needs 32 mm", ""),
    (["bellows.length=180 mm"], "bellows.length", "needs 180 mm", "actuator.width, 20 mm"),
    (["bellows.width=30 mm"], "bellows.width", "a row of 8 needs 240 mm", "actuator.length, 109 mm"),
    (["bellows.count=48"], "bellows.width", "a row of 24 needs 288 mm", ""),
    (["network.tube_radius=20 mm"], "network.tube_radius", "40 mm wide", "10 mm"),
    (["network.tube_radius=5.5 mm"], "network.tube_radius", "11 mm wide", ""),
    # outputs and pressures
    (["run.output_interval=1 us"], "run.output_interval", "8,000,001 outputs", "1 ms?"),
    (["run.duration=6 h"], "run.output_interval", "1,080,001 outputs", ""),
    (["input={kind: constant, value: 140 kPa}"], "input", "140 kPa is taken as gauge", "38.67 kPa gauge"),
]  # fmt: skip


@pytest.mark.parametrize(("overrides", "key", "number", "slip"), SLIPS)
def test_a_number_that_is_hardly_meant_is_told_once(
    overrides: list[str], key: str, number: str, slip: str
) -> None:
    found = list(plausibility_notices(leg(*overrides)))
    assert [notice.where for notice in found] == [key]
    assert number in found[0].message
    assert slip in found[0].message


@pytest.mark.parametrize(
    ("overrides", "words"),
    [
        (["run.duration=1 s"], "4 s must lie within the run, which ends at 1 s and is too short for a transition of 4 s"),
        (["run.duration=2 s"], "4 s must lie within the run, which ends at 2 s, and not before 1 s (a quarter of the transition)"),
        (["input.fall_time=4 ms"], "a quarter of the transition); did you mean 4 s?"),
        (["input.transition=4 ks"], "4000 s is far above what such a run shows, 2.5 ms to 560 s (from a twentieth"),
        (["input.transient_time=4 us"], "what belongs to this profile"),
    ],
)  # fmt: skip
def test_a_time_is_compared_with_the_run(overrides: list[str], words: str) -> None:
    """Not with actuators, and in words that hold where no time is allowed."""
    found = [notice.message for notice in plausibility_notices(leg(*overrides, config="leg_4_air"))]
    assert any(words in message for message in found), found
    assert not any("such actuators" in message for message in found)


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("network.tube_length=37.5 Mm", "at most 1 Mm; got 37.5 Mm; did you mean 37.5 mm?"),
        ("actuator.length=109 Mm", "did you mean 109 mm?"),
        ("actuator.youngs_modulus=1.8e15", "at most 2000 GPa"),
        ("bellows.width=1e7", "at most 1 Mm"),
        ("actuator.height=30 Gm", "at most 1 Mm"),
    ],
)
def test_what_no_matter_has_is_refused(override: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        check(leg(override))
    assert words in str(caught.value)


@pytest.mark.parametrize("config", ACTUATOR_SPECS, ids=lambda path: path.stem)
def test_no_bundled_scene_is_warned_about(config: Path) -> None:
    assert not list(plausibility_notices(load(config)))


@pytest.mark.parametrize(
    "override",
    [
        "actuator.length=1.2 m", "actuator.youngs_modulus=50 kPa", "actuator.youngs_modulus=60 MPa",
        "network.tube_radius=10 um", "network.tube_radius=4 mm", "network.tube_length=3 m",
        "fluid={name: hydrogen, viscosity: 8.8e-6, density: 0.0838, gas_constant: 4124}",
        "fluid={name: silicone oil, viscosity: 12.5, density: 970}",
        "fluid={name: gallium alloy, viscosity: 2.4 mPa*s, density: 6250}",
        "temperature=60 degC", "ambient_pressure=70 kPa", "actuator.damping_time=0", "run.duration=1 h",
    ],
)  # fmt: skip
def test_what_labs_have_is_not_warned_about(override: str) -> None:
    overrides = [override]
    if "ambient" in override or "temperature" in override:
        overrides.append("fluid=air")  # the paper's gas has the density of sea level and 15 degC
    found = [notice for notice in plausibility_notices(leg(*overrides))]
    assert not [n for n in found if "fluid=" not in override or n.code != "gas_density"]


def test_every_range_has_a_source_and_holds_its_paper() -> None:
    keys = [found.key for found in RANGES]
    assert len(keys) == len(set(keys))
    assert all(found.source and found.low < found.high for found in RANGES)
    assert all(f.possible[0] <= f.low and f.high <= f.possible[1] for f in RANGES)


def test_check_prints_and_json_carries_them() -> None:
    spec = str(CONFIGS / "leg_16_straight_air.yaml")
    args = ["check", spec, "--set", "actuator.youngs_modulus=1.8 GPa"]
    assert "did you mean 1.8 MPa?" in " ".join(run_command(args).out.split())
    document = json.loads(run_command([*args, "--json"]).out)
    codes = {notice["code"]: notice["where"] for notice in document["warnings"]}
    assert codes["implausible_value"] == "actuator.youngs_modulus"


@pytest.mark.parametrize("command", ["check", "simulate"])
def test_what_cannot_be_solved_names_the_number_that_it_follows_from(
    command: str, tmp_path: Path
) -> None:
    spec = str(CONFIGS / "leg_16_straight_air.yaml")
    folder = ["-o", str(tmp_path / "run")]
    found = run_command([command, spec, *folder, "--set", "actuator.youngs_modulus=1.8 mPa"])
    assert found.code == 2
    assert "actuator.youngs_modulus: 1.8 mPa" in found.err
    assert "did you mean 1.8 MPa?" in found.err
