"""Every check finds its own failure, and names it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from viscodesign.model.chain import Chain
from viscodesign.model.rod import Body
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.terminations import broken_balance, doubted_balance, first_termination
from viscodesign.results.trajectory import Invariants

TIME = np.linspace(0.0, 1.0, 5)


def problem(floor: float | None = None) -> Any:
    """Two bellows, one section, and what the checks read of a problem."""
    equations = SimpleNamespace(
        incompressible=floor is None, rest_amounts=np.array([1.0, 1.0]), rod_form=RodForm.STATIC
    )
    rod = Chain(Body(1.0, 1, 1.0, 1.0, 1.0), 4)
    return SimpleNamespace(
        equations=equations,
        rod=rod,
        bellows=("R1", "L1"),
        places=np.array([0, 1]),
        floor_volume=floor,
        rest_volume=1.0,
        drawing=None,
        remedies={},
    )


def rows(**changes: tuple[tuple[int, int], float]) -> dict[str, np.ndarray]:
    """Ordinary rows, single values changed."""
    found = {"pressure": np.zeros((5, 2)), "volume": np.ones((5, 2)), "angle": np.zeros((5, 4))}
    for name, (place, value) in changes.items():
        found[name][place] = value
    return found


def ended(problem: Any, values: dict[str, np.ndarray], stretch: np.ndarray | None = None) -> Any:
    return first_termination(
        problem, TIME, values, np.ones((5, 1)) if stretch is None else stretch, None
    )


def test_an_ordinary_run_is_complete() -> None:
    assert ended(problem(0.1), rows()) == (5, None)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_value_that_is_not_finite_ends_a_run_and_names_its_bellow(value: float) -> None:
    end, failure = ended(problem(), rows(pressure=((3, 1), value)))
    assert end == 3
    assert (failure.quantity, failure.where, failure.time_s) == ("pressure", "L1", 0.75)


def test_a_section_compressed_to_nothing_ends_a_run() -> None:
    stretch = np.array([[1.0], [0.5], [0.0], [-0.2], [0.1]])
    end, failure = ended(problem(), rows(), stretch)
    assert (end, failure.quantity, failure.where) == (2, "stretch", "section 1")


def test_a_gas_filled_bellow_at_its_floor_ends_a_run() -> None:
    end, failure = ended(problem(0.1), rows(volume=((2, 0), 0.09)))
    assert (end, failure.quantity) == (2, "volume")
    assert "minimum (collapsed) volume" in str(failure)
    assert ended(problem(None), rows(volume=((2, 0), 0.09))) == (5, None)


def test_an_angle_that_jumps_ends_a_run() -> None:
    values = rows()
    values["angle"][4:, 2:] = 3.5
    end, failure = ended(problem(), values)
    assert (end, failure.quantity, failure.where) == (4, "section angle", "section 1")


def test_the_earliest_cause_is_told() -> None:
    end, failure = ended(problem(0.1), rows(pressure=((3, 1), np.nan), volume=((1, 0), 0.0)))
    assert (end, failure.quantity) == (1, "volume")


def test_balances_that_do_not_hold_are_told() -> None:
    assert broken_balance(Invariants(1e-9, 1e-3), 1.0) is None
    assert broken_balance(Invariants(None, None), 1.0) is None
    for invariants, quantity in (
        (Invariants(2e-8, 0.0), "volume balance"),
        (Invariants(np.nan, 0.0), "volume balance"),
        (Invariants(0.0, 3.0), "energy balance"),
    ):
        broken = broken_balance(invariants, 1.0)
        assert broken is not None
        assert broken.quantity == quantity
    assert [n.code for n in doubted_balance(Invariants(0.0, 0.1))] == ["energy_imbalance"]
    assert not list(doubted_balance(Invariants(0.0, 1e-3)))
    assert broken_balance(Invariants(0.0, 0.09), 1.0) is None
