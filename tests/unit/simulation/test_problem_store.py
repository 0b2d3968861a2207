"""What equal scenes share from one run to the next, and other scenes do not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects import gravity
from viscodesign.effects.effects_key import effects_key
from viscodesign.effects.gravity import Gravity
from viscodesign.effects.select import select_effects
from viscodesign.effects.tip_displacements import TipDisplacements
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.model.system import System
from viscodesign.scene.inputs.double_sigmoid import DoubleSigmoidInput
from viscodesign.simulation import simulate as simulate_module
from viscodesign.simulation import solve_once
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.solve_once import ProblemStore

SHORT = ("run={duration: 0.2 s, output_interval: 0.05 s}", "bellows.count=4")
CHANGES = (
    "network.tube_length=41 mm",
    "input.fall_time=0.6 s",
    "run.duration=0.3 s",
    "accuracy=0.4 %",
    "effects.gravity=on",
    "loads.tip_force={x: -0.0 N, z: 1e-12 N}",
    "fluid=water",
)


@pytest.mark.parametrize("change", CHANGES)
def test_only_equal_scenes_have_one_digest(change: str) -> None:
    assert leg(*SHORT).digest == leg(*SHORT).digest
    assert leg(*SHORT).digest != leg(*SHORT, change).digest


def test_an_equal_scene_builds_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    first = simulate(leg(*SHORT), verify=False)
    monkeypatch.setattr(solve_once, "build", None)
    monkeypatch.setattr(solve_once, "equilibrium", None)
    again = simulate(leg(*SHORT), verify=False)
    assert np.array_equal(first.tip, again.tip)


def test_an_equal_scene_estimates_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    first = select_effects(SceneQuantities(leg(*SHORT, "effects=auto")))
    monkeypatch.setattr(TipDisplacements, "between", None)
    again = select_effects(SceneQuantities(leg(*SHORT, "effects=auto")))
    assert first.verdicts == again.verdicts


def _heavier(self: Gravity, system: System) -> None:
    weight = system.parameter("gravity.acceleration", FACTOR * self.pulls[0][0])
    for point in system.rod.masses():
        system.load_potential -= point.mass * weight * point.position[0]


FACTOR = 3.0


def _replaced_method(patch: pytest.MonkeyPatch) -> None:
    patch.setattr(Gravity, "join", _heavier)


def _reloaded_class(patch: pytest.MonkeyPatch) -> None:
    members = {"join": _heavier, "name": "gravity", "__module__": gravity.__name__}
    patch.setattr(gravity, "Gravity", type("Gravity", (Gravity,), members))


def _changed_options(patch: pytest.MonkeyPatch) -> None:
    """Options that no spec states."""
    patch.setattr(Gravity, "of", classmethod(lambda cls, quantities: cls(((FACTOR * 9.81, 0.5),))))


def _changed_constant(patch: pytest.MonkeyPatch) -> None:
    """A number that a replaced method takes from its module."""
    patch.setattr(Gravity, "join", _heavier)
    simulate(LOADED, verify=False)
    patch.setitem(globals(), "FACTOR", 5.0)


def _replaced_input(patch: pytest.MonkeyPatch) -> None:
    value = DoubleSigmoidInput.expression

    def doubled(t: Any, piece: Any, functions: Any) -> Any:
        return 2 * value(t, piece, functions)

    patch.setattr(DoubleSigmoidInput, "expression", staticmethod(doubled))


LOADED = leg(*SHORT, "effects={gravity: on, others: off}", "loads.gravity=on")


@pytest.mark.parametrize(
    "change",
    [_replaced_method, _reloaded_class, _changed_options, _changed_constant, _replaced_input],
)
def test_what_was_defined_anew_is_not_answered_by_what_ran_before(
    monkeypatch: pytest.MonkeyPatch, change: Callable[[pytest.MonkeyPatch], None]
) -> None:
    before = simulate(LOADED, verify=False)
    change(monkeypatch)
    after = simulate(LOADED, verify=False)
    monkeypatch.setattr(simulate_module, "KEPT_PROBLEMS", ProblemStore(1))
    fresh = simulate(LOADED, verify=False)
    assert np.array_equal(after.tip, fresh.tip)
    assert not np.array_equal(after.tip, before.tip)


class _Foreign(Gravity):
    """An effect of another package."""

    def join(self, system: System) -> None:
        _heavier(self, system)


def test_an_effect_of_another_package_has_one_key_until_its_code_names_another_number(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first, second = (
        effects_key(SceneQuantities(scene), [_Foreign(((9.81, 0.0),))])
        for scene in (leg(*SHORT), leg(*SHORT))
    )
    assert first == second
    assert hash(first) == hash(second)
    monkeypatch.setitem(globals(), "FACTOR", 5.0)
    assert effects_key(SceneQuantities(leg(*SHORT)), [_Foreign(((9.81, 0.0),))]) != first


def test_a_choice_follows_the_code_that_it_was_made_with(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = leg(*SHORT, "effects=auto", "loads.gravity=on")
    before = select_effects(SceneQuantities(scene))
    pulled = EstimateTerm(acceleration=(9.81, 0.0))
    monkeypatch.setattr(Gravity, "estimate_term", lambda self: pulled)
    after = select_effects(SceneQuantities(scene))
    assert "gravity" in after.active - before.active


def test_a_start_cannot_be_changed_by_a_run() -> None:
    quantities = SceneQuantities(leg(*SHORT))
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    prepared = ProblemStore(2).problem(quantities, effects, settings)
    start = prepared.start(settings.tolerance, settings.solver)
    with pytest.raises(ValueError, match="read-only"):
        start.states[0] = 1.0
