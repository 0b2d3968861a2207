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
    from viscodesign.checks.check import Check, check
    from viscodesign.checks.classify import classify
    from viscodesign.loading import load
    from viscodesign.pump.planning.plan import plan
    from viscodesign.pump.planning.result import PumpPlan
    from viscodesign.results.accuracy_study import AccuracyStudy
    from viscodesign.results.findings import Classification
    from viscodesign.results.trajectory import Trajectory
    from viscodesign.scene.scene import Scene
    from viscodesign.simulation.simulate import simulate
    from viscodesign.studies.accuracy import accuracy

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
    "AccuracyStudy": "results.accuracy_study",
    "Check": "checks.check",
    "Classification": "results.findings",
    "PumpPlan": "pump.planning.result",
    "Scene": "scene.scene",
    "Trajectory": "results.trajectory",
    "accuracy": "studies.accuracy",
    "check": "checks.check",
    "classify": "checks.classify",
    "load": "loading",
    "plan": "pump.planning.plan",
    "simulate": "simulation.simulate",
}


def __getattr__(name: str) -> object:
    """Import a public name when it is first asked for: `--help` needs none of them."""
    import importlib

    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    """What there is to import, whether it has been asked for or not."""
    return sorted(__all__)
