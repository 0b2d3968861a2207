"""Failures on the way to an equilibrium, with their remedies."""

from __future__ import annotations

from viscodesign.errors import SolveError
from viscodesign.model.rod_equations import RodForm
from viscodesign.solve.numerics.newton import NewtonError
from viscodesign.solve.obstacles import Obstacle, advice
from viscodesign.solve.problem import Problem


def no_pressures(problem: Problem, time: float) -> SolveError:
    if problem.equations.statics.multivalued:
        return SolveError(
            f"no steady state can be reached at t = {time:.6g} s: on the way from the rest state "
            "of bellows.curve to the first pressure, a bellow snaps through",
            quantity="swelling",
            where="network",
            time_s=time,
            remedy="Start at a pressure below that of the first snap and raise it, or set "
            "run.start: rest.",
        )
    return SolveError(
        f"the steady pressures of the network cannot be found at t = {time:.6g} s",
        quantity="pressure",
        where="network",
        time_s=time,
        remedy="Check for tubes whose resistances differ by many orders of magnitude, for material "
        "curves that are nearly flat, and for turbulent flow.",
    )


def step_limit_reached(problem: Problem, load: float, time: float) -> SolveError:
    return SolveError(
        f"the limit of {problem.max_steps} steps was reached on the way to the equilibrium at "
        f"t = {time:.6g} s, at {100 * load:.3g} % of the loads",
        quantity="work",
        where="rod",
        time_s=time,
        remedy="Raise run.max_steps, lower the loads, or ask for less accuracy.",
    )


def no_equilibrium(problem: Problem, failure: NewtonError, time: float) -> SolveError:
    percent = 100 * failure.reached
    form = problem.equations.rod_form
    remedy = (
        advice(problem.remedies, Obstacle.NO_EQUILIBRIUM, "Lower the loads or the pressure")
        if form is not RodForm.ARCS
        else "Check the network's tubes and pressures."
    )
    return SolveError(
        f"no stable equilibrium: the branch from the unloaded shape ends at {percent:.3g} % "
        "of the loads",
        quantity="equilibrium",
        where="rod" if form is not RodForm.ARCS else "network",
        time_s=time,
        remedy=remedy,
    )
