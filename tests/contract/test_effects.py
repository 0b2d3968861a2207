"""The contract of effects: every member of the catalogue is held to it."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

from tests.scenes import CONFIGS, LEG_LENGTH, leg
from viscodesign import Scene, check, classify, effects, load_several, simulate
from viscodesign.cli.main import main
from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import _catalogue, catalogue
from viscodesign.effects.select import select_effects
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.model.chain import Chain
from viscodesign.model.dissipation import is_quadratic
from viscodesign.model.rod_equations import COORDINATES, RATES, STRAIN_RATES, RodForm
from viscodesign.model.system import System
from viscodesign.results.findings import Verdict
from viscodesign.simulation.build_problem import Settings, assemble, build
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import equilibrium

# Every effect of the catalogue has something to act on here.
LOADED = (
    "loads.gravity.tilt=30 deg",
    "loads.tip_force.x=0.1 N",
    "loads.payload=5 g",
    "network.tube_wall={youngs_modulus: 1 MPa, thickness: 0.3 mm}",
    "effects={others: on}",
)
CURVE = (
    "bellows.curve={rows: [[-20 kPa, -5e-5, -0.1, -0.3 mm], [0, 0, 0, 0], "
    "[30 kPa, 2e-4, 0.3, 2 mm], [60 kPa, 3e-4, 0.4, 3 mm]]}"
)


GROUND = "loads.ground={kind: line, point: {x: 40 mm}, normal: -90 deg, friction: 0.3}"


def every_effect() -> list[str]:
    """Names of those that have to keep the contract."""
    return sorted(catalogue())


EFFECTS = every_effect()


def scene_of(name: str, *overrides: str) -> Scene:
    """A scene in which the effect has something to act on; a curve would hide collapse."""
    own = [n for n, kind in catalogue().items() if n == name or (name == "all" and kind.own_rule)]
    curve = [CURVE] if name == "material_curve" else []
    ground = [GROUND] if name == "ground" else []
    return leg(*LOADED, *(f"effects.{n}=on" for n in own), *curve, *overrides, *ground)


def made(name: str) -> tuple[Effect, SceneQuantities]:
    quantities = SceneQuantities(scene_of(name))
    return catalogue()[name].of(quantities), quantities


def joined(name: str, quantities: SceneQuantities) -> list[Effect]:
    """The effect with what it needs, and inertia, which gives every term something to push."""
    names = {name, "inertia", *catalogue()[name].needs}
    return [kind.of(quantities) for other, kind in catalogue().items() if other in names]


def problem_with(*chosen: Effect, edges: int = 1) -> Problem:
    return build(SceneQuantities(leg(*LOADED)), list(chosen), Settings(edges, 1e-6))


def assembled(quantities: SceneQuantities, chosen: list[Effect]) -> System:
    return assemble(quantities, chosen, Chain(quantities.body, 1), quantities.body)


def values(problem: Problem, seed: int = 1) -> list[np.ndarray]:
    """A state away from rest: pressures, places and speeds disturbed, no symmetry left."""
    equations = problem.equations
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    random = np.random.default_rng(seed)
    x = start.states + 1e-2 * random.standard_normal(len(start.states))
    z = start.algebraics + 1e-2 * random.standard_normal(len(start.algebraics))
    return [x, z, np.array(0.3), problem.schedule.pieces[0], problem.numbers()] if equations else []


@pytest.mark.parametrize("name", EFFECTS)
def test_weight_is_finite_and_explained(name: str) -> None:
    effect, quantities = made(name)
    weight = effect.weight(quantities)
    assert math.isfinite(weight)
    assert weight >= 0
    assert effect.formula
    assert effect.reason(quantities)
    assert effect.validity
    assert effect.keys or effect.options
    assert len((type(effect).__doc__ or "").splitlines()[0]) in range(10, 100)


@pytest.mark.parametrize("name", EFFECTS)
def test_its_contribution_is_estimated(name: str) -> None:
    effect, quantities = made(name)
    term = effect.estimate_term()
    told = {v.name: v for v in check(scene_of(name)).effects}[name]
    if term is None:
        # Its weight, in actuator lengths, stands for what it may do.
        guess = effect.weight(quantities) * LEG_LENGTH
        assert told.contribution_m == pytest.approx(guess)
    assert term != EstimateTerm()
    assert math.isfinite(told.contribution_m)
    assert told.contribution_m > 0.0
    assert told.budget_share == pytest.approx(told.contribution_m / (0.005 * LEG_LENGTH))


@pytest.mark.parametrize("name", EFFECTS)
def test_verdict_obeys_the_spec(name: str) -> None:
    for mode, expected in (("on", True), ("off", False)):
        verdicts = {v.name: v for v in check(scene_of(name, f"effects.{name}={mode}")).effects}
        assert verdicts[name].taken is expected
        assert verdicts[name].mode == mode


@pytest.mark.parametrize("name", [*EFFECTS, "all"])
def test_jacobian_equals_differences(name: str) -> None:
    quantities = SceneQuantities(scene_of(name))
    chosen = select_effects(quantities).effects if name == "all" else joined(name, quantities)
    problem = build(quantities, chosen, Settings(1, 1e-6))
    e = problem.equations.formulas
    x, z = e.states.vector, e.algebraics.vector
    unknowns = ca.vertcat(x, z)
    rows = ca.vertcat(e.ode, e.alg)
    tail = [e.time, e.pieces, e.parameters]
    function = ca.Function("f", [x, z, *tail], [rows, ca.jacobian(rows, unknowns)])
    point = values(problem)

    def residual(w: np.ndarray) -> np.ndarray:
        count = len(point[0])
        result = function.call([ca.DM(a) for a in (w[:count], w[count:], *point[2:])])
        return np.array(result[0]).ravel()

    w = np.concatenate(point[:2])
    jacobian = np.array(ca.DM(function.call([ca.DM(a) for a in point])[1]).full())
    step = 1e-6
    for k in range(len(w)):
        forward, backward = w.copy(), w.copy()
        forward[k] += step
        backward[k] -= step
        difference = (residual(forward) - residual(backward)) / (2 * step)
        scale = max(1.0, float(np.max(np.abs(jacobian[:, k]))))
        assert np.max(np.abs(difference - jacobian[:, k])) <= 2e-6 * scale


@pytest.mark.parametrize("name", [n for n in EFFECTS if n not in ("gravity", "tip_load")])
def test_no_force_at_rest_but_steady_load(name: str) -> None:
    """Without pressure and load a straight rod stays where it is."""
    still = scene_of(name, "input={kind: constant, value: 0}", "loads={gravity: off}")
    quantities = SceneQuantities(still)
    problem = build(quantities, joined(name, quantities), Settings(1, 1e-6))
    equations = problem.equations
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    ode, alg = equations.function.call(
        [ca.DM(a) for a in (start.states, start.algebraics, *problem.tail(0.0, np.zeros(3)))]
    )
    assert np.max(np.abs(np.array(ode))) <= 1e-9
    assert np.max(np.abs(np.array(alg))) <= 1e-12


def test_damping_only_takes_and_spares_a_rigid_turn() -> None:
    problem = problem_with(made("inertia")[0], made("damping")[0], edges=2)
    equations = problem.equations
    e = equations.formulas
    loss_rate = e.quadrature[equations.rates.index("material_loss")] * equations.energy_size
    rates = e.algebraics.vector[e.algebraics.blocks[STRAIN_RATES].span]
    rows = e.alg[ca.jacobian(e.alg, rates).sparsity().row()]
    loss_rate = ca.substitute(loss_rate, rates, ca.substitute(rows, rates, 0))
    power = ca.Function("p", [e.states.vector, e.algebraics.vector, e.parameters], [loss_rate])
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    x = start.states.copy()
    position = equations.states.physical(COORDINATES, x).reshape(-1, 2)
    span = equations.states.blocks[RATES].span

    def loss(velocity: np.ndarray) -> float:
        x[span] = velocity.ravel()
        return float(power(ca.DM(x), ca.DM(start.algebraics), ca.DM(problem.numbers())))

    random = np.random.default_rng(0)
    assert all(loss(random.standard_normal(position.shape)) > 0 for _ in range(20))
    # A turn about the clamp as a whole bends the rod only where it is held.
    turning = np.column_stack((position[:, 1], -position[:, 0])) / LEG_LENGTH
    bending = turning * np.linspace(0, 1, len(position))[:, None]
    assert loss(np.zeros_like(position)) == 0.0
    stretch, curvature = _rates(problem, x, turning, span)
    assert np.max(np.abs(stretch)) <= 1e-12
    assert np.max(np.abs(curvature[1:])) <= 1e-9
    assert loss(bending) > 0


def _rates(
    problem: Problem, x: np.ndarray, velocity: np.ndarray, span: slice
) -> tuple[np.ndarray, np.ndarray]:
    """Strain rates of the chain, by differences of its own lengths and turns."""
    position = problem.equations.states.physical(COORDINATES, x).reshape(-1, 2)

    def measure(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        chords = np.diff(np.vstack([[0, 0], points]), axis=0)
        return np.hypot(*chords.T), np.diff(np.unwrap(np.arctan2(*chords.T)), prepend=0.0)

    step = 1e-7
    forward, backward = measure(position + step * velocity), measure(position - step * velocity)
    x[span] = velocity.ravel()
    return (forward[0] - backward[0]) / (2 * step), (forward[1] - backward[1]) / (2 * step)


@pytest.mark.parametrize(
    ("name", "override"),
    [
        ("gravity", "loads.gravity.acceleration=0"),
        ("damping", "actuator.damping_time=0"),
        ("feedback", "bellows={area_per_force: 0, area_per_moment: 0}"),
        ("tip_load", "loads={gravity: off, tip_force: {x: 0, z: 0}, payload: 0}"),
    ],
)
def test_vanishes_with_its_parameter(name: str, override: str) -> None:
    key = override.partition("=")[0]
    parts = {"bellows": ["bellows.area_per_force=0", "bellows.area_per_moment=0"]}
    quantities = SceneQuantities(leg(*LOADED, *parts.get(key, [override])))
    effect = catalogue()[name].of(quantities)
    assert effect.weight(quantities) == 0.0


def test_what_is_off_is_absent() -> None:
    """Fewer unknowns, not a multiplied zero."""

    def form(*modes: str) -> tuple[RodForm, int]:
        quantities = SceneQuantities(
            leg(*LOADED[:3], f"effects={{{', '.join(modes)}, others: off}}")
        )
        chosen = select_effects(quantities).effects
        equations = build(quantities, chosen, Settings(1, 1e-4)).equations
        return equations.rod_form, equations.states.count + equations.algebraics.count

    everything = form("inertia: on", "damping: on", "pressure_distribution: on")
    quasi_static = form("gravity: on", "pressure_distribution: on")
    uniform = form("gravity: on")
    assert everything[0] is RodForm.DYNAMIC
    assert quasi_static[0] is RodForm.STATIC
    assert everything[1] > quasi_static[1] > uniform[1]
    bare = SceneQuantities(leg("effects={others: off}"))
    chosen = select_effects(bare).effects
    equations = build(bare, chosen, Settings(1, 1e-4)).equations
    assert equations.rod_form is RodForm.ARCS
    assert equations.states.count + equations.algebraics.count == 0


NEW_EFFECT = '''
"""A drag on the tip, for a test."""
from viscodesign.effects.base import Effect
from viscodesign.errors import Fault
from viscodesign.postprocess.motion_limits import Limit
from viscodesign.results.findings import Notice

class TipDrag(Effect):
    """Drag of the air around the tip."""
    name = "tip_drag"
    formula = "d l^2 / (E I t_s)"
    needs = ("inertia",)
    validity = "A tip in the air."
    keys = ("ambient.density",)

    @classmethod
    def of(cls, quantities):
        return cls()

    def weight(self, quantities):
        return 0.125

    def reason(self, quantities):
        return "for a test"

    def refusals(self, quantities, active):
        if self.name in active and quantities.scene.accuracy < 1e-5:
            yield Fault("no drag law is so accurate", "accuracy")

    def warnings(self, quantities, active):
        if self.name in active:
            yield Notice("still_air", "the air is taken to be at rest")

    def limits(self, quantities, active):
        if self.name in active:
            notice = lambda peak: Notice("long_tip", f"{peak.value:.3g} long", "tip", peak.time_s)
            yield Limit(lambda block: block.section_stretch, 0.5, notice)

    def join(self, system):
        system.dissipation_power += 1e-6 * system.rod.velocity[0, -1] ** 2
'''


@pytest.fixture
def tip_drag(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """A catalogue with one file more; its name."""
    (tmp_path / "tip_drag.py").write_text(NEW_EFFECT)
    monkeypatch.setattr(effects, "__path__", [*effects.__path__, str(tmp_path)])
    _catalogue.cache_clear()
    yield "tip_drag"
    _catalogue.cache_clear()
    sys.modules.pop("viscodesign.effects.tip_drag", None)


def test_a_new_effect_is_one_new_file(tip_drag: str) -> None:
    """Verdicts tell of it, and the contract holds it to every promise."""
    assert tip_drag in {v.name for v in check(leg("effects.tip_drag=on")).effects}
    assert set(every_effect()) == {*EFFECTS, tip_drag}
    for promise in (
        test_weight_is_finite_and_explained,
        test_its_contribution_is_estimated,
        test_verdict_obeys_the_spec,
        test_jacobian_equals_differences,
        test_no_force_at_rest_but_steady_load,
    ):
        promise(tip_drag)
    test_a_dissipation_is_quadratic_in_the_rates()


def test_a_dissipation_is_quadratic_in_the_rates() -> None:
    """Then half its gradient is a force whose power it is."""
    dissipating = set()
    for name in every_effect():
        quantities = SceneQuantities(scene_of(name))
        system = assembled(quantities, joined(name, quantities))
        if terms := system.dissipation_power.terms:
            dissipating.add(name)
            assert is_quadratic(system, terms), name
    assert "damping" in dissipating


@pytest.mark.parametrize("exponent", [1, 2, 3])
def test_a_dissipation_of_another_degree_is_refused(exponent: int) -> None:
    """Of an effect from outside the package, by its name and with the contract."""
    own: dict[str, Any] = {"__name__": "outside"}
    law = f"(system.rod.velocity[0, -1] ** 2) ** ({exponent} / 2)"
    exec(NEW_EFFECT.replace("system.rod.velocity[0, -1] ** 2", law), own)
    effect = own["TipDrag"]()
    quantities = SceneQuantities(leg())
    if exponent == 2:
        assert assembled(quantities, [effect]).dissipation_power.terms
        return
    with pytest.raises(SpecError, match=r"effects.tip_drag: .* must be quadratic in the rates"):
        assembled(quantities, [effect])


def test_an_effect_on_one_tip_is_refused_where_there_are_several() -> None:
    own: dict[str, Any] = {"__name__": "outside"}
    exec(NEW_EFFECT.replace("system.rod.velocity[0, -1] ** 2", "system.rod.tip[0]"), own)
    (scene,) = load_several(CONFIGS / "two_legs.yaml").joined
    with pytest.raises(SpecError, match=r"effects.tip_drag: .* TipDrag in outside go through"):
        build(SceneQuantities(scene), [own["TipDrag"]()], Settings(1, 1e-4))


def test_a_new_effect_without_an_estimate_counts_by_its_weight(tip_drag: str) -> None:
    def told(*overrides: str) -> Verdict:
        return {v.name: v for v in check(leg("effects=auto", *overrides)).effects}[tip_drag]

    found = told()
    assert found.taken
    assert found.weight == 0.125
    assert found.contribution_m == pytest.approx(0.125 * LEG_LENGTH)
    assert found.budget_share == pytest.approx(25.0)
    without = told("effects.inertia=off")
    assert not without.taken
    assert "neglected with inertia" in without.reason
    run = simulate(
        leg(
            "bellows.count=4",
            "effects={tip_drag: on, inertia: on, others: off}",
            "run.duration=0.1 s",
        ),
        verify=False,
    )
    assert run.status == "complete", run.failure
    assert {v.name for v in run.effects if v.taken} == {tip_drag, "inertia"}


def test_a_new_effect_brings_its_warnings_limits_and_refusals(tip_drag: str) -> None:
    active = ("bellows.count=4", "effects={tip_drag: on, inertia: on, others: off}")
    short = "run.duration=0.1 s"
    for found in (check(leg(*active)), classify(leg(*active))):
        assert "still_air" in {notice.code for notice in found.warnings}
    run = simulate(leg(*active, short), verify=False)
    assert {"still_air", "long_tip"} <= {notice.code for notice in run.warnings}
    for attempt in (check, simulate):
        with pytest.raises(SpecError, match="accuracy: no drag law is so accurate"):
            attempt(leg(*active, short, "accuracy=1e-6"))
    without = simulate(leg("bellows.count=4", short, "effects={tip_drag: off}"), verify=False)
    assert not {"still_air", "long_tip"} & {notice.code for notice in without.warnings}


def test_a_new_effect_is_told_by_the_command_line(
    tip_drag: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["effects"]) == 0
    assert f"weight = {catalogue()[tip_drag].formula}" in capsys.readouterr().out
    assert main(["effects", tip_drag]) == 0
    page = " ".join(capsys.readouterr().out.split())
    assert page.startswith("tip_drag: Drag of the air around the tip.")
    assert "spec keys effects.tip_drag, ambient.density" in page
    assert "The estimate has no term for it" in page
    assert "Without inertia it is not applicable" in page


def test_the_file_is_gone_afterwards() -> None:
    assert every_effect() == EFFECTS
