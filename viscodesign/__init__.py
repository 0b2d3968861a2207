"""Design soft actuators that move by the viscosity of their fluid.

    from viscodesign import load, simulate
    trajectory = simulate(load("leg.yaml"))
    trajectory.frame()

`load` reads a spec, `check` and `classify` judge it without solving, `simulate`
follows its motion, `accuracy` measures what accuracy costs in time, `plan` turns its pressures
into a pump's motion. Nothing here prints.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from viscodesign._version import __version__

if TYPE_CHECKING:
    from viscodesign.checking import Check, check
    from viscodesign.classifying import classify
    from viscodesign.loading import load
    from viscodesign.planning.plan import plan
    from viscodesign.pumpplan import PumpPlan
    from viscodesign.scene.scene import Scene
    from viscodesign.simulating import simulate
    from viscodesign.studies.accuracy import accuracy
    from viscodesign.tradeoff import AccuracyStudy
    from viscodesign.trajectory import Classification, Trajectory

__all__ = [
    "AccuracyStudy",
    "Check",
    "Classification",
    "PumpPlan",
    "Scene",
    "Trajectory",
    "__version__",
    "accuracy",
    "check",
    "classify",
    "load",
    "plan",
    "simulate",
]

_HOMES = {
    "AccuracyStudy": "tradeoff",
    "Check": "checking",
    "Classification": "trajectory",
    "PumpPlan": "pumpplan",
    "Scene": "scene.scene",
    "Trajectory": "trajectory",
    "accuracy": "studies.accuracy",
    "check": "checking",
    "classify": "classifying",
    "load": "loading",
    "plan": "planning.plan",
    "simulate": "simulating",
}


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for: `--help` needs none of them."""
    import importlib

    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value
