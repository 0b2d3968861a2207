"""The band that a spec's `uncertainty` gives the tip: its size, its sources, and how often it holds."""

from __future__ import annotations

import json
import math
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import norm, qmc

from tests.scenes import LEG_EI, LEG_LENGTH, STILL, leg
from viscodesign import RunInterruptedError, Trajectory, check, load, simulate
from viscodesign.cli.texts.run_text import both_errors, summary_lines
from viscodesign.compiled.function import CompiledFunction
from viscodesign.errors import Fault, SpecError
from viscodesign.results.coefficient_band import COVERAGE_FACTOR, CoefficientBand, swept_ellipses
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.studies import coefficient_band as band_module
from viscodesign.studies.stated_uncertainty import stated_deviations
from viscodesign.studies.typical_uncertainties import TYPICAL

FORCE = 1e-3
PULLED = (STILL, f"loads.tip_force.x={FORCE}", "effects={others: off}",
          "run={duration: 1 s, output_interval: 0.5 s}")  # fmt: skip
BENT = FORCE * LEG_LENGTH**3 / (3 * LEG_EI)
SWING = ("run={duration: 2 s, output_interval: 0.1 s}", "effects={pressure_distribution: on, others: off}")  # fmt: skip


def run_of(*words: str) -> Trajectory:
    found = simulate(leg(*words), verify=False)
    assert found.status == "complete", found.failure
    return found


def band_of(*words: str) -> CoefficientBand:
    band = run_of(*words).uncertainty
    assert band is not None
    return band


@pytest.fixture(scope="module")
def swinging() -> Trajectory:
    """A run with typical deviations but for the radius, and a number that it does not contain."""
    return run_of(
        *SWING,
        "uncertainty={network.tube_radius: 1 %, actuator.damping_time: 10 %, others: typical}",
    )


# -- how wide -----------------------------------------------------------------


def test_a_load_is_as_uncertain_as_the_stiffness_that_carries_it() -> None:
    band = band_of(*PULLED, "uncertainty={actuator.bending_factor: 4 %}")
    assert band.deviation[:, 0] == pytest.approx(0.04 * BENT, rel=1e-5)
    assert band.half_width_m == pytest.approx(COVERAGE_FACTOR * 0.04 * BENT, rel=1e-5)


def test_independent_numbers_add_in_squares() -> None:
    words = "{actuator.bending_factor: 4 %, actuator.length: 1 %, loads.tip_force.x: 2e-5 N}"
    band = band_of(*PULLED, f"uncertainty={words}")
    parts = {"actuator.bending_factor": 0.04, "actuator.length": 0.03, "loads.tip_force.x": 0.02}
    whole = math.sqrt(sum(part**2 for part in parts.values()))
    assert band.deviation[-1, 0] == pytest.approx(whole * BENT, rel=1e-4)
    # Along z the length itself counts, far more than what bends.
    assert band.deviation[-1, 1] == pytest.approx(0.01 * LEG_LENGTH, rel=1e-3)
    assert sum(number.share for number in band.numbers) == pytest.approx(1.0)
    shares = [number.share for number in band.numbers]
    assert shares == sorted(shares, reverse=True)
    assert band.numbers[0].key == "actuator.length"


def test_a_range_counts_by_its_mean_square_about_the_value() -> None:
    low, high, value = 0.5, 0.64, 0.55
    band = band_of(*PULLED, f"uncertainty={{actuator.bending_factor: [{low}, {high}]}}")
    square = (high**3 - low**3) / 3 / (high - low) - value * (low + high) + value**2
    assert band.numbers[0].deviation == pytest.approx(math.sqrt(square), rel=1e-12)
    radius = "uncertainty={network.tube_radius: [0.30 mm, 0.35 mm]}"
    wide = band_of(*SWING, radius)
    assert wide.numbers[0].deviation == pytest.approx(0.05e-3 / math.sqrt(12), rel=1e-9)


def test_a_number_that_is_zero_may_be_uncertain_in_its_unit() -> None:
    words = (STILL, *SWING, "gauge_pressure=0")
    band = band_of(*words, "uncertainty={gauge_pressure: 500 Pa}")
    raised = run_of(STILL, *SWING, "gauge_pressure=1 Pa").tip - run_of(*words).tip
    assert band.deviation[-1, 1] == pytest.approx(500 * abs(raised[-1, 1]), rel=1e-4)
    assert band.deviation[-1, 1] > 1e-5


def test_the_band_is_that_of_its_widest_direction(swinging: Trajectory) -> None:
    band = swinging.uncertainty
    assert band is not None
    turned = np.linspace(0, math.pi, 721)
    along = np.stack([np.cos(turned), np.sin(turned)])
    xx, zz, xz = band.covariance.T
    every = np.einsum("nij,ik,jk->nk", np.array([[xx, xz], [xz, zz]]).T, along, along)
    assert band.half_width_m == pytest.approx(COVERAGE_FACTOR * np.sqrt(every.max()), rel=1e-4)
    ellipse = band.ellipse(band.worst_row)
    assert np.hypot(*ellipse.T).max() == pytest.approx(band.half_width_m, rel=1e-2)


def test_swept_ellipses_hold_both_ends_and_what_is_between() -> None:
    from matplotlib.path import Path as Outline

    tip = np.array([[0.0, 0.0], [3.0, 1.0], [3.0, 2.0]])
    covariance = np.array([[1e-2, 4e-2, 1e-2], [2e-2, 1e-2, -1e-2], [0.0, 1e-2, 0.0]])
    band = CoefficientBand(covariance, np.arange(3.0), ())
    parts = swept_ellipses(tip, band, most=9)
    assert len(parts) == 2
    for k, part in enumerate(parts):
        outline, middle = Outline(part), tip[k : k + 2].mean(axis=0)
        ends = [tip[j] + 0.98 * band.ellipse(j) for j in (k, k + 1)]
        assert outline.contains_points(np.concatenate([*ends, [middle]]), radius=1e-6).all()


def test_the_band_holds_as_many_actuators_as_it_says() -> None:
    """Drawn from what is stated, and solved: 95 %, of all times and both coordinates."""
    stated = (
        "{actuator.youngs_modulus: 5 %, bellows.angle_per_pressure: 5 %, network.tube_radius: 2 %}"
    )
    run = run_of(*SWING, "bellows.count=4", f"uncertainty={stated}")
    band = run.uncertainty
    assert band is not None
    keys = {number.key: number for number in band.numbers}
    function = CompiledFunction(leg(*SWING, "bellows.count=4"), list(keys), ("tip_x_m", "tip_z_m"))
    drawn = norm.ppf(qmc.Sobol(3, seed=np.random.default_rng(1)).random(128).clip(1e-6, 1 - 1e-6))
    spread = np.array([keys[name].deviation for name in function.names])
    found = function.batch(function.values + spread * drawn)
    tips = np.stack([found["tip_x_m"], found["tip_z_m"]], axis=2)
    moving = band.deviation > 1e-7
    inside = np.abs(tips - run.tip[:, :2]) <= COVERAGE_FACTOR * band.deviation
    assert moving.mean() > 0.8
    assert 0.93 <= inside[:, moving].mean() <= 0.97


# -- what is stated, and what is assumed --------------------------------------


def test_what_is_stated_replaces_what_is_typical(swinging: Trajectory) -> None:
    band = swinging.uncertainty
    assert band is not None
    numbers = {number.key: number for number in band.numbers}
    radius, modulus = numbers["network.tube_radius"], numbers["actuator.youngs_modulus"]
    assert (radius.assumed, modulus.assumed, band.is_assumed) == (False, True, True)
    assert radius.deviation == pytest.approx(0.01 * radius.value)
    assert modulus.deviation == pytest.approx(0.1 * modulus.value)


def test_numbers_that_move_nothing_are_left_out_with_their_reason(swinging: Trajectory) -> None:
    band = swinging.uncertainty
    assert band is not None
    told = dict(band.left_out)
    assert "actuator.damping_time" in told
    assert "nothing in this scene's equations depends on it" in told["actuator.damping_time"]
    assert set(told).isdisjoint(number.key for number in band.numbers)


def test_every_typical_number_is_a_key_of_some_scene() -> None:
    from viscodesign.compiled.free_keys import candidates

    known = set(candidates(leg("actuator.shear_factor=0.5")))
    assert set(TYPICAL) <= known


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("{network.tube_radus: 5 %}", "uncertainty.network.tube_radus: no such number"),
        ("{network.tube_radius: 5 Pa}", "uncertainty.network.tube_radius: "),
        ("{network.tube_radius: 120 %}", "above 0 and below 100 %"),
        ("{network.tube_radius: 0.05}", "write a standard deviation, such as 5 %"),
        ("{network.tube_radius: [0.3 mm]}", "a range has two ends"),
        ("{network.tube_radius: [0.4 mm, 0.5 mm]}", "leaves out the value itself"),
        ("{network.tube_radius: [0.4 mm, 0.3 mm]}", "a range ascends"),
        ("{run.duration: 5 %}", "uncertainty.run.duration: "),
        ("{others: some}", "must be one of typical, none"),
        ("5 %", "must be typical, none or a mapping"),
        ("{network.tube_radius: 5}", "write a standard deviation, such as 5 %"),
        ("{network.tube_radius: 2 kg}", "expected a standard deviation"),
        ("{network.tube_radius: [-1 mm, 0.5 mm]}", "a range has values that are possible"),
    ],
)
def test_what_is_no_uncertainty_is_refused_before_anything_is_solved(
    words: str, message: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.studies.simulate.simulate_once", lambda *_, **__: 1 / 0)
    for takes in (simulate, check):
        with pytest.raises(SpecError) as caught:
            takes(leg(f"uncertainty={words}"))
        assert message in str(caught.value)


UNKNOWN = """
uncertainty:
  network:
    tube_radus: 5 %
  network.tube_radius: 2 %
"""
IMPOSSIBLE = """
uncertainty:
  actuator.length: [90 mm, 100 mm]
  "network.tubes[*].length": 2 kg
"""
SHAPELESS = """
uncertainty:
  network:
    tube_length: 5
"""


def test_its_errors_name_file_and_line_what_was_given_and_what_is_allowed(tmp_path: Path) -> None:
    spec, plain = tmp_path / "leg.yaml", resolved_yaml(leg()).rstrip()
    first = len(plain.splitlines()) + 1

    def faults(text: str, *words: str) -> list[Fault]:
        spec.write_text(plain + text)
        with pytest.raises(SpecError) as caught:
            check(load(spec, words))
        return caught.value.faults

    (unknown,) = faults(UNKNOWN)
    assert (unknown.file, unknown.line) == (str(spec), first + 2)
    assert (unknown.key, unknown.given) == ("uncertainty.network.tube_radus", "5 %")
    assert "did you mean 'network.tube_radius'" in unknown.message
    assert "a standard deviation" in unknown.allowed
    wrong = faults(IMPOSSIBLE)
    assert {own.line for own in wrong} == {first + 1, first + 2}
    assert {own.file for own in wrong} == {str(spec)}
    assert wrong[0].given == ["90 mm", "100 mm"]
    (shapeless,) = faults(SHAPELESS)
    assert (shapeless.line, shapeless.given) == (first + 2, 5)
    override = "uncertainty={run.duration: 5 %}"
    (instead,) = faults(IMPOSSIBLE, override)
    assert (instead.file, instead.line) == (f"--set {override}", None)


def test_sizes_of_all_tubes_that_are_stated_one_by_one_are_not_assumed_as_well() -> None:
    words = "uncertainty={'network.tubes[*].radius': 2 %, others: typical}"
    stated = stated_deviations(leg(words))
    assert "network.tube_radius" not in stated
    assert not stated["network.tubes[inlet-R1].radius"].assumed


def test_it_may_be_written_nested_and_is_written_resolved() -> None:
    nested = leg("uncertainty={network: {tube_radius: 5 %}, actuator.length: [0.1 m, 0.12 m]}")
    dotted = leg("uncertainty={network.tube_radius: 5 %, actuator.length: [0.1 m, 0.12 m]}")
    assert nested == dotted
    again = load(resolved_yaml(nested))
    assert again.uncertainty == nested.uncertainty
    assert load(nested.model_dump()).uncertainty == nested.uncertainty
    typical = load(resolved_yaml(leg("uncertainty=typical")))
    assert typical.uncertainty == leg("uncertainty=typical").uncertainty


# -- when there is one ----------------------------------------------------------


def test_without_the_key_nothing_more_is_computed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(band_module, "coefficient_band", lambda *_: 1 / 0)
    assert run_of(*PULLED).uncertainty is None
    stated = leg(*PULLED, "uncertainty=typical")
    assert simulate(stated, verify=False, uncertainty=False).uncertainty is None


def test_it_moves_nothing_but_the_band() -> None:
    plain, stated = run_of(*SWING), run_of(*SWING, "uncertainty={network.tube_radius: 5 %}")
    assert np.array_equal(plain.tip, stated.tip)
    assert plain.cost.steps == stated.cost.steps


def test_a_run_outlives_the_band_that_fails_or_is_interrupted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = leg(*PULLED, "uncertainty={actuator.bending_factor: 4 %}")

    def fails(*_: object) -> None:
        raise SpecError.plain("there are no derivatives")

    monkeypatch.setattr(band_module, "_slopes", fails)
    run = simulate(scene, verify=False)
    assert (run.status, run.uncertainty) == ("complete", None)
    (told,) = (w for w in run.warnings if w.code == "no_band")
    assert "there are no derivatives" in told.message

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(band_module, "coefficient_band", interrupted)
    with pytest.raises(RunInterruptedError) as caught:
        simulate(scene, verify=False)
    assert caught.value.trajectory is not None
    assert caught.value.trajectory.status == "complete"


# -- what is told -----------------------------------------------------------------


def test_the_folder_of_a_run_keeps_it(swinging: Trajectory, tmp_path: Path) -> None:
    swinging.save(tmp_path, plots=False, report=False)
    told, band = json.loads((tmp_path / "summary.json").read_text()), swinging.uncertainty
    assert band is not None
    assert told["uncertainty"]["half_width_95_m"] == pytest.approx(band.half_width_m)
    again = Trajectory.read(tmp_path).uncertainty
    assert again is not None
    assert again.covariance == pytest.approx(band.covariance, rel=1e-12)
    assert (again.numbers, again.left_out) == (band.numbers, band.left_out)
    run_of(*PULLED).save(tmp_path, plots=False, report=False)
    assert not (tmp_path / "uncertainty.csv").exists()


def test_both_errors_are_told_in_one_line(swinging: Trajectory, tmp_path: Path) -> None:
    text = "\n".join(summary_lines(swinging, tmp_path, ()))
    band = swinging.uncertainty
    assert band is not None
    assert f"from the coefficients +-{1e3 * band.half_width_m:.3g} mm (95 %" in text
    assert f"s), some assumed; validity {swinging.validity}" in text
    assert f"{band.numbers[0].key} {100 * band.numbers[0].share:.0f} %" in text
    bare = "\n".join(summary_lines(run_of(*PULLED), tmp_path, ()))
    assert "numerical not estimated; from the coefficients unknown" in bare


def test_a_check_takes_it_as_it_is() -> None:
    assert check(leg("uncertainty=typical")).name


@pytest.mark.parametrize("word", ["none", "off"])
def test_none_states_nothing(word: str) -> None:
    scene = leg(*PULLED, f"uncertainty={word}")
    assert stated_deviations(scene) == {}
    assert load(resolved_yaml(scene)).uncertainty == scene.uncertainty
    assert simulate(scene, verify=False).uncertainty is None


@pytest.mark.parametrize(
    "stated", ["{bellows.collapse_fraction: 50 %}", "{ambient_pressure: 1 kPa}"]
)
def test_what_moves_nothing_gives_a_band_without_width(stated: str) -> None:
    """Whether the equations have the number, or have it without effect."""
    run = run_of(*PULLED, f"uncertainty={stated}")
    assert run.uncertainty is not None
    assert run.uncertainty.half_width_m == 0.0
    assert "from the coefficients none: no stated number moves the tip" in both_errors(run)


def test_a_band_that_was_left_out_is_not_advised_and_is_null_in_the_summary() -> None:
    scene = leg(*PULLED, "uncertainty={actuator.bending_factor: 4 %}")
    run = simulate(scene, verify=False, uncertainty=False)
    assert "from the coefficients left out" in both_errors(run)
    told = run.summary()
    assert "uncertainty" in told
    assert told["uncertainty"] is None


def test_a_band_wider_than_it_was_tested_is_warned_of() -> None:
    run = run_of(*PULLED, "uncertainty={actuator.length: [0.03 m, 40 m]}")
    (told,) = (w for w in run.warnings if w.code == "wide_band")
    assert "of the first order" in told.message
    assert not any(w.code == "wide_band" for w in run_of(*PULLED, "uncertainty=typical").warnings)
