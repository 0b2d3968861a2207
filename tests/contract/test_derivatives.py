"""Derivatives of a motion are those of its solution, for every sum of effects."""

from __future__ import annotations

import random

import numpy as np
import pytest

from tests.contract.test_local_form import CONFIGS_TRIED, SEED
from tests.scenes import CONFIGS
from viscodesign import load
from viscodesign.compiled.reading import Members, places_of
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.solution import MotionFunction
from viscodesign.compiled.symbols import parameter_names
from viscodesign.effects.allowed_sets import AllowedSets
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.rod import MINIMUM_EDGES
from viscodesign.simulation.build_problem import Settings, build, pieces_between, stops_of
from viscodesign.solve.problem import Problem

REL_TOL = 1e-6
"""Of the largest rate of any column: differences of solutions with the same steps."""
DUAL_REL_TOL = 1e-8
CHANGES = (1e-3, 1e-4, 1e-5)
"""Parts of a direction for differences: the best is neither cut off nor round-off."""
SETS_PER_CONFIG = 1
AT_ONCE = {"syringe_water": ["input.speeds=[[0 s, 0.2 mm/s], [0.1 s, 0.4 mm/s]]"]}
"""Changes to inputs that rest at first: without any motion, there is nothing to compare."""
ANY_ERROR = 1e30
"""Tolerance at which the sizes of steps depend on the times alone."""


@pytest.mark.parametrize("config", CONFIGS_TRIED)
def test_derivatives_equal_differences_and_each_other(config: str) -> None:
    for quantities, problem in problems(config):
        start = quantities.scene.run.start
        members = Members.of(quantities)
        columns = list(places_of(problem, members))
        function = MotionFunction(problem, ANY_ERROR, members, columns, start=start)
        check(function, numbers_of(quantities, problem), problem)


def problems(config: str) -> list[tuple[SceneQuantities, Problem]]:
    """A scene with all of its effects, and with random ones of them."""
    short = "run={duration: 0.2 s, output_interval: 7 ms}"
    changes = [short, "effects.shear=auto", *AT_ONCE.get(config, [])]
    scene = load(CONFIGS / f"{config}.yaml", changes)
    quantities = SceneQuantities(scene)
    sets = AllowedSets(quantities)
    names, chance = sorted(sets.everything), random.Random(f"{SEED} {config}")
    found = [sets.everything]
    for _ in range(SETS_PER_CONFIG):
        left_out = chance.sample(names, chance.randint(1, len(names) - 1))
        found.append(sets.without(sets.everything, *left_out))
    settings = Settings(-(-MINIMUM_EDGES // quantities.body.sections), 1e-4)
    every = {own: [e for n, e in sets.effects.items() if n in own] for own in found}
    return [(quantities, build(quantities, effects, settings)) for effects in every.values()]


def numbers_of(quantities: SceneQuantities, problem: Problem) -> ProblemNumbers:
    stops = stops_of(quantities.scene)
    pieces, initial = pieces_between(quantities.scene, stops)
    return ProblemNumbers(problem.equations.parameter_values, pieces, initial, stops)


def check(function: MotionFunction, numbers: ProblemNumbers, problem: Problem) -> None:
    chance = np.random.default_rng(SEED)
    solved = function.solve(numbers)
    sizes = sizes_of(function.columns, solved.columns)
    directions = [direction(numbers, problem, chance, name) for name in ("parameters", "pieces")]
    every = ProblemNumbers(*(np.array(parts) for parts in zip(*directions, strict=True)))
    rates = function.push_forward(solved, numbers, every)
    weights = chance.standard_normal(solved.columns.shape) / sizes
    bars = function.pull_back(solved, numbers, weights)
    for own, rate in zip(directions, rates, strict=True):
        along = sum(np.sum(bar * part) for bar, part in zip(bars, own, strict=True))
        known = np.sum(weights * rate)
        spread = np.sum(np.abs(weights * rate))
        assert abs(along - known) <= DUAL_REL_TOL * spread
        plain = [k for k, name in enumerate(function.columns) if not name.startswith("flow")]
        apart = min(distance(function, numbers, own, rate, change, plain) for change in CHANGES)
        assert apart <= REL_TOL


def distance(
    function: MotionFunction,
    numbers: ProblemNumbers,
    own: ProblemNumbers,
    rate: np.ndarray,
    change: float,
    columns: list[int],
) -> float:
    """Of some columns' rates from a central difference, over the largest one."""
    moved = [
        ProblemNumbers(*(a + s * b for a, b in zip(numbers, own, strict=True)))
        for s in (change, -change, 2 * change, -2 * change)
    ]
    ends = [function.solve(each) for each in moved]
    assert len({end.steps for end in ends}) == 1
    check_side_by_side(function, moved, [end.columns for end in ends])
    sizes = sizes_of(function.columns, ends[0].columns)
    near, far = (ends[k].columns - ends[k + 1].columns for k in (0, 2))
    found = (8 * near - far) / (12 * change)  # without the error of second order
    apart = (np.abs(found - rate) / sizes)[:, columns]
    return float(np.max(apart) / np.max((np.abs(rate) / sizes)[:, columns]))


def check_side_by_side(
    function: MotionFunction, moved: list[ProblemNumbers], alone: list[np.ndarray]
) -> None:
    """Rows that are solved at once have the columns that each has alone."""
    if function.side_by_side is not None:
        rows = ProblemNumbers(*(np.array(parts) for parts in zip(*moved, strict=True)))
        solved = function.side_by_side.solve(rows)
        assert len(solved.rows) == len(moved)
        np.testing.assert_array_equal(solved.columns, alone)


def sizes_of(names: tuple[str, ...], columns: np.ndarray) -> np.ndarray:
    """By which columns are divided: the largest value of their kind; angles by one."""
    kinds = np.array([name.split("_")[-2 if name.startswith("tip") else 0] for name in names])
    found = np.max(np.abs(columns), axis=0)
    largest = {kind: np.max(found[kinds == kind]) for kind in np.unique(kinds)}
    return np.array(
        [largest["z"] if k == "x" else 1.0 if k == "angle" else largest[k] for k in kinds]
    )


def direction(
    numbers: ProblemNumbers, problem: Problem, chance: np.random.Generator, which: str
) -> ProblemNumbers:
    """Relative changes of the parameters but for scalings, or of the inputs."""
    found = ProblemNumbers(*(np.zeros_like(part) for part in numbers))
    if which == "parameters":
        names = parameter_names(problem.equations)
        free = np.array([not name.startswith("size.") for name in names])
        found.parameters[:] = 0.1 * numbers.parameters * chance.standard_normal(len(names)) * free
    else:
        found.pieces[:] = 0.1 * numbers.pieces * chance.standard_normal(numbers.pieces.shape)
        found.initial_piece[:] = 0.1 * numbers.initial_piece
    return found
