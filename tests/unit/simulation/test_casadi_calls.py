"""How often a run of a known scene calls CasADi: outputs and equilibria come from tapes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import casadi as ca
import pytest

from tests.scenes import ROOT
from viscodesign import load, simulate

MOST_CALLS = 20
"""Of a verified run of three solutions: sums at the start of stretches, mostly."""


def test_a_verified_run_of_a_known_scene_calls_casadi_rarely(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = load(ROOT / "configs" / "leg_16_straight_air.yaml")
    first = simulate(scene)
    calls: list[str] = []

    def counted(name: str, method: Callable[..., Any]) -> Callable[..., Any]:
        def count(function: ca.Function, *arguments: Any, **named: Any) -> Any:
            calls.append(f"{name} {function.name()}")
            return method(function, *arguments, **named)

        return count

    for name in ("call", "buffer"):
        monkeypatch.setattr(ca.Function, name, counted(name, getattr(ca.Function, name)))
    symbol = ca.SX.sym("x")
    ca.Function("probe", [symbol], [symbol]).call([1.0])
    assert calls == ["call probe"]  # they are counted
    again = simulate(scene)
    assert again.accuracy == first.accuracy
    assert len(calls) - 1 <= MOST_CALLS, calls
