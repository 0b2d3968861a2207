"""Every sum of effects, taken apart into local terms, is the same equations."""

from __future__ import annotations

import random

import casadi as ca
import numpy as np
import pytest

from tests.scenes import CONFIGS, leg, problem_of
from viscodesign import load
from viscodesign.effects.allowed_sets import AllowedSets
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.elements.kinds import Elements, value_of
from viscodesign.model.elements.local_form import LocalForm
from viscodesign.model.rod import MINIMUM_EDGES
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import rest

SEED = 16
SETS_PER_CONFIG = 2
CONFIGS_TRIED = (
    "leg_4_water_auto",
    "leg_16_straight_water_auto",
    "leg_16_gauge_minus_2kpa_auto",
    "branched_tree",
    "horizontal_payload",
    "antagonistic_two_inlets",
    "measured_bellow",
    "syringe_water",
)
REL_TOL = 1e-11
"""Of the largest residual of a kind: round-off, of sums in another order."""


@pytest.mark.parametrize("config", CONFIGS_TRIED)
def test_residuals_equal_those_of_the_whole_formulas(config: str) -> None:
    for problem in problems(config):
        check(problem)


def test_a_single_constraint_is_taken_apart() -> None:
    """The pressure of an inlet's line, and nothing that moves."""
    problem = problem_of(leg("effects={others: off}", config="syringe_water"))
    assert (problem.equations.states.count, problem.equations.algebraics.count) == (0, 1)
    check(problem)


def problems(config: str) -> list[Problem]:
    """A scene with all of its effects, and with random ones of them."""
    quantities = SceneQuantities(load(CONFIGS / f"{config}.yaml", ["effects.shear=auto"]))
    sets = AllowedSets(quantities)
    names, chance = sorted(sets.everything), random.Random(f"{SEED} {config}")
    found = [sets.everything]
    for _ in range(SETS_PER_CONFIG):
        left_out = chance.sample(names, chance.randint(1, len(names) - 1))
        found.append(sets.without(sets.everything, *left_out))
    fewest = -(-MINIMUM_EDGES // quantities.body.sections)
    settings = Settings(fewest + chance.choice((0, 1, 2)), 1e-4)
    every = {own: [e for n, e in sets.effects.items() if n in own] for own in found}
    return [build(quantities, effects, settings) for effects in every.values()]


def check(problem: Problem) -> None:
    equations, local = problem.equations, problem.equations.local
    assert local is not None
    chance = np.random.default_rng(SEED)
    piece, time = problem.schedule.pieces[0], 0.4 * problem.schedule.edges[-1]
    start = rest(problem, problem.schedule.initial_piece)
    x = start.states + 1e-2 * chance.standard_normal(len(start.states))
    z = start.algebraics + 1e-2 * chance.standard_normal(len(start.algebraics))
    numbers = problem.numbers()
    sums = np.array(local.start(x, z, time, piece, numbers)).ravel()
    integrals = np.zeros(equations.integrals)
    found = residual(local.form, np.concatenate([x, z, sums, integrals]), time, piece, numbers)
    ode, alg = (np.array(v).ravel() for v in equations.function(x, z, *problem.tail(time, piece)))
    e = equations.formulas
    given = [e.states.vector, e.algebraics.vector, e.time, e.pieces, e.parameters]
    powers = ca.Function("powers", given, [e.quadrature])
    powers = np.array(powers(x, z, time, piece, numbers)).ravel()
    parts = np.split(found, np.cumsum([len(x), len(z), len(sums)]))
    for part, expected in zip(parts, (ode, alg, np.zeros(len(sums)), powers), strict=True):
        size = max(1.0, np.max(np.abs(expected), initial=0.0))
        assert part == pytest.approx(expected, abs=REL_TOL * size)


def residual(
    form: LocalForm, y: np.ndarray, time: float, piece: np.ndarray, parameters: np.ndarray
) -> np.ndarray:
    """The sum over all elements, kernel by kernel in CasADi."""
    numbers = np.array(form.numbers(parameters)).ravel()
    values = np.concatenate([y, np.zeros(form.drives), [time], piece, [1.0]])
    drives, found = np.zeros(form.drives), np.zeros(form.size)
    for kind in form.sources:
        add(kind, values, numbers, drives)
    values[form.size : form.time] = drives
    for kind in form.kinds:
        add(kind, values, numbers, found)
    return found


def add(kind: Elements, values: np.ndarray, numbers: np.ndarray, to: np.ndarray) -> None:
    for variables, own, rows in zip(kind.variables, kind.numbers, kind.rows, strict=True):
        result = value_of(kind.law)(values[list(variables)], numbers[list(own)])
        np.add.at(to, list(rows), np.array(result).ravel())


def test_another_graph_needs_no_new_kernel() -> None:
    """Kinds are told apart by their formulas: a longer chain has the same ones."""

    def laws(sections: int) -> set[object]:
        scene = load(CONFIGS / "leg_16_straight_air.yaml", [f"bellows.count={2 * sections}"])
        quantities = SceneQuantities(scene)
        sets = AllowedSets(quantities)
        effects = [e for n, e in sets.effects.items() if n in sets.everything]
        local = build(quantities, effects, Settings(1, 1e-4)).equations.local
        assert local is not None
        return {kind.law for kind in local.form.kinds}

    assert laws(8) == laws(12)
