"""The coupled problem by viscodesign: the published scene as it is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coupled import SCENE, CoupledCase
from ours import Ours

if TYPE_CHECKING:
    import numpy as np

    from viscodesign.results.motion_arrays import MotionArrays
    from viscodesign.scene.scene import Scene

LADDER = [(1, 1e-3), (1, 1e-4), (1, 2e-5), (2, 2e-5), (2, 1e-5), (4, 1e-6), (8, 1e-7)]
"""Edges per section and tolerance, refined together."""


class Viscodesign(Ours):
    """One of its solvers."""

    def __init__(self, case: CoupledCase) -> None:
        del case  # there is one

    def ladder(self) -> list[dict[str, Any]]:
        return [{"edges_per_section": edges, "tolerance": tol} for edges, tol in LADDER]

    def scene(self, *more: str) -> Scene:
        from viscodesign import load

        return load(SCENE, more)

    def values(self, motion: MotionArrays) -> np.ndarray:
        return motion.tip[:, :2]


class Idas(Viscodesign):
    """BDF of IDAS."""

    name = "viscodesign (IDAS)"
    solver = "idas"


class Rosenbrock(Viscodesign):
    """Rodas5P."""

    name = "viscodesign (Rodas5P)"
    solver = "rosenbrock"


class Called(Viscodesign):
    """Asked for an accuracy; effects, mesh, tolerance and solver are the program's choice."""

    name = "viscodesign (by accuracy)"
    solver = None
