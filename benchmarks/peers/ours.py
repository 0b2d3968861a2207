"""viscodesign as a contestant: by a solver at given settings, or by the accuracy alone.

`prepare` reads the scene and solves it once, as whoever works with it does; measured is
a whole further solution. Asked for an accuracy, that is `simulate(scene, verify=False)`; with a
given solver, building the problem again, the equilibrium at the start, the steps through time,
and reading all outputs, shapes and balances.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar

if TYPE_CHECKING:
    import numpy as np

    from viscodesign.results.motion_arrays import MotionArrays
    from viscodesign.scene.scene import Scene

ACCURACIES = [1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-5, 1e-6]


class Ours(ABC):
    """One way to use it, down a ladder of settings."""

    name: ClassVar[str]
    solver: ClassVar[str | None]
    """None: effects, mesh, tolerance and solver as the program chooses for an accuracy."""

    @abstractmethod
    def ladder(self) -> list[dict[str, Any]]:
        """Settings of a given solver, coarse to fine."""

    @abstractmethod
    def scene(self, *more: str) -> Scene:
        """The case's scene with further overrides."""

    @abstractmethod
    def values(self, motion: MotionArrays) -> np.ndarray:
        """What is compared (T, k)."""

    def settings(self) -> list[dict[str, Any]]:
        """Coarse to fine."""
        if self.solver is not None:
            return self.ladder()
        return [{"accuracy": accuracy} for accuracy in ACCURACIES]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Read, choose, and solve once."""
        from viscodesign.effects.select import select_effects
        from viscodesign.estimate.scene_quantities import SceneQuantities
        from viscodesign.simulation.build_problem import Settings, suggest_settings
        from viscodesign.simulation.simulate import simulate
        from viscodesign.simulation.solve_once import solve

        asked = setting.get("accuracy")
        changes = [] if asked is None else [f"accuracy={asked}"]
        quantities = SceneQuantities(self.scene(*changes))
        effects = select_effects(quantities).effects
        settings = suggest_settings(quantities, effects)
        if self.solver is not None:
            settings = Settings(**{"edges_per_section": 1} | setting, solver=self.solver)

        def run() -> np.ndarray:
            if self.solver is None:
                called = simulate(quantities.scene, verify=False)
                if called.status != "complete":
                    raise RuntimeError(str(called.failure))
                return self.values(called)
            found = solve(quantities, effects, settings)
            if not found.is_complete:
                raise RuntimeError(str(found.motion.failure))
            assert len(found.motion.shape)
            assert found.motion.invariants
            return self.values(found.motion)

        run()
        return run
