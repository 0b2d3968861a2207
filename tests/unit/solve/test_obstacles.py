"""A failed run says which effects would carry it on; the effects themselves know."""

from __future__ import annotations

import pytest

from tests.scenes import leg, problem_of
from viscodesign.solve.branch_following import limit_point
from viscodesign.solve.branch_jumps import branch_jump
from viscodesign.solve.obstacles import Obstacle, advice


@pytest.mark.parametrize(
    ("measures", "remedies", "sentence"),
    [
        (("Raise the pressure",), (), "Raise the pressure."),
        (("Raise the pressure",), ("set x to auto",), "Raise the pressure, or set x to auto."),
        (("Wait", "push"), ("set x to on",), "Wait, push, or set x to on."),
    ],
)
def test_advice_joins_measures_and_remedies(
    measures: tuple[str, ...], remedies: tuple[str, ...], sentence: str
) -> None:
    assert advice({Obstacle.LIMIT_POINT: remedies}, Obstacle.LIMIT_POINT, *measures) == sentence
    assert advice({}, Obstacle.LIMIT_POINT, *measures).endswith(f"{measures[-1]}.")


def test_a_static_rod_is_told_of_inertia_and_damping() -> None:
    problem = problem_of(leg("effects.inertia=off"))
    for failure in (limit_point(problem, 1.0), branch_jump(problem, 1.0)):
        assert "set effects.inertia and effects.damping to auto or on" in failure.remedy


def test_a_curve_helps_a_bellow_only_where_there_is_one() -> None:
    remedies = problem_of(leg("effects={collapse: off, others: auto}")).remedies
    assert remedies[Obstacle.EMPTY_BELLOW] == ("set effects.collapse to auto",)
