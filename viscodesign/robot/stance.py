"""A robot that stands: its equilibrium at given pressures, and whether it sways."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.linalg import null_space

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.friction_problem import (
    OPEN,
    STICK,
    ContactError,
    FrictionProblem,
    States,
)
from viscodesign.robot.leg_pose import BODY, FOOT
from viscodesign.robot.robot_model import (
    LegGroup,
    LegStates,
    LinearisedLegs,
    RobotModel,
    linearised,
)
from viscodesign.robot.time_step import RobotState

MAX_STANCE_ITERATIONS = 40
STANCE_TOLERANCE = 1e-10
"""Last Newton step [m, rad]."""
LARGEST_STANCE_MOVE = 2e-2
"""Largest move in one iteration, rotations by the length of a leg [m]: the weight bends legs far
before it is balanced."""
PROXIMAL_STIFFNESS = 1.0
"""Added to the matrix of an iteration, not to its balance [N/m]: a robot in the air is free to go
anywhere, and the contact forces need a stiffness."""
STILL = (0.0, 0.0)
"""Step and damping rate of statics."""


class UnstableStanceError(SolveError):
    """The robot has no stable equilibrium on its legs."""


@dataclass(frozen=True, eq=False)
class Stance:
    """A robot at rest on its legs."""

    model: RobotModel
    place: np.ndarray
    legs: tuple[LegStates, ...]
    contact_forces: np.ndarray
    contact_states: States
    sway_stiffness: float
    """Smallest eigenvalue of the stiffness with the feet where they are [N/m]; rotations count
    by the length of a leg."""

    @property
    def is_stable(self) -> bool:
        """Whether small motions raise the energy."""
        return self.sway_stiffness > 0.0

    def state(self, sources: int) -> RobotState:
        """As the first state of a motion."""
        still = np.zeros(self.model.size)
        return RobotState(
            0.0, self.place, still, self.legs, self.contact_forces, self.contact_states,
            np.zeros(sources),
        )  # fmt: skip


def unloaded_legs(group: LegGroup, pressures: np.ndarray) -> tuple[np.ndarray, LegStates]:
    """Tips (l, 3) and states of legs that hang free at uniform gauge pressures (l,) [Pa]."""
    functions, count = group.functions, len(group.legs)
    nodes = len(functions.design.nodes)
    pressure = np.tile(np.reshape(pressures, (-1, 1)), (1, nodes))
    load = np.zeros((count, 3))
    tip, _, content, strains = functions.hanging.rows(
        [load, pressure, np.zeros((count, group.strain_numbers)), np.zeros((count, 2))], count
    )
    still = np.zeros((count, nodes + 1))
    return tip, LegStates(load, pressure, strains, content, still)


def set_down(model: RobotModel, pressures: np.ndarray) -> tuple[np.ndarray, tuple[LegStates, ...]]:
    """The place of an upright body whose lowest foot just touches the ground, and its legs.

    ``pressures``: gauge, of every source [Pa].
    """
    place, states = np.zeros(model.size), []
    for group in model.groups:
        tip, own = unloaded_legs(group, pressures[group.sources])
        count = len(group.legs)
        (feet,) = group.functions.foot.rows([np.zeros((count, BODY)), tip, group.mounts], count)
        place[group.places[:, BODY:]] = feet
        states.append(own)
    shift = float(np.min(model.gaps(place)))
    place[[1, *range(BODY + 1, model.size, FOOT)]] += shift
    return place, tuple(states)


def stance(model: RobotModel, pressures: np.ndarray, near: Stance | None = None) -> Stance:
    """The equilibrium of a robot that is set down at given gauge pressures [Pa] of its sources.

    Feet roll and slide from where they touch the ground. ``near``: a stance at the same pressures
    with another weight, from which to begin. Raises `UnstableStanceError`.
    """
    return _StanceSolver(model, pressures, near).solve()


class _StanceSolver:
    """Newton's method from where the robot is set down, with the contacts solved in every step."""

    def __init__(self, model: RobotModel, pressures: np.ndarray, near: Stance | None) -> None:
        self.model = model
        self.start, self.legs = set_down(model, pressures)
        self.place = self.start
        self.states: States = (STICK,) * model.count
        if near is not None:
            self.place, self.legs, self.states = near.place, near.legs, near.contact_states
        self.sources = [pressures[group.sources][:, None] for group in model.groups]
        self.free: dict[States, np.ndarray] = {}
        self.lengths = np.ones(model.size)
        self.lengths[[2, 3, *range(BODY + 2, model.size, FOOT)]] = _leg_length(model)

    def solve(self) -> Stance:
        for _ in range(MAX_STANCE_ITERATIONS):
            around = self._around()
            force, stiffness = self.model.assembled(around)
            change, forces = self._change(force, stiffness)
            if self._sway_stiffness(stiffness) < 0.0:
                raise self._none()  # it gives way long before the balance is found
            if np.max(np.abs(change)) < STANCE_TOLERANCE:
                return self._found(stiffness, forces)
            largest = float(np.max(np.abs(change) * self.lengths))
            self._move(around, change * min(1.0, LARGEST_STANCE_MOVE / largest))
        raise self._none()

    def _around(self) -> list[LinearisedLegs]:
        return [
            linearised(group, self.place[group.places], own, own, given, STILL, hold_pressures=True)
            for group, own, given in zip(self.model.groups, self.legs, self.sources, strict=True)
        ]

    def _change(self, force: np.ndarray, stiffness: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Newton's step of the place, and the contact forces."""
        model, rows = self.model, self.model.contact_rows
        matrix = stiffness + np.diag(PROXIMAL_STIFFNESS * self.lengths**2)
        solved = np.linalg.solve(matrix, np.column_stack([model.weights - force, rows.T]))
        free = rows @ solved[:, 0] + rows @ (self.place - self.start)
        free[: model.count] = rows[: model.count] @ solved[:, 0] + model.gaps(self.place)
        friction = (model.feet.friction,) * model.count
        try:
            problem = FrictionProblem(rows @ solved[:, 1:], free, friction, tries_all=False)
            forces, self.states = problem.solve(self.states)
        except ContactError:
            raise self._none() from None
        return solved[:, 0] + solved[:, 1:] @ forces, forces

    def _move(self, around: list[LinearisedLegs], change: np.ndarray) -> None:
        self.place = self.place + change
        self.legs = tuple(
            replace(
                own,
                load=own.load
                + near.own
                + (near.own_by_place @ change[group.places][:, :, None])[:, :, 0],
            )
            for group, own, near in zip(self.model.groups, self.legs, around, strict=True)
        )

    def _found(self, stiffness: np.ndarray, forces: np.ndarray) -> Stance:
        legs = tuple(
            _settled(group, own) for group, own in zip(self.model.groups, self.legs, strict=True)
        )
        sway = self._sway_stiffness(stiffness)
        return Stance(self.model, self.place, legs, forces, self.states, sway)

    def _sway_stiffness(self, stiffness: np.ndarray) -> float:
        """Smallest eigenvalue of the stiffness where contacts stay as they are [N/m]."""
        free, scaled = self._free_motions(), stiffness / np.outer(self.lengths, self.lengths)
        symmetric = free.T @ (scaled + scaled.T) @ free / 2
        return float(np.linalg.eigvalsh(symmetric)[0])

    def _free_motions(self) -> np.ndarray:
        """Motions that leave all contacts as they are, one a column."""
        states = self.states
        if states not in self.free:
            held = [state != OPEN for state in states] + [state == STICK for state in states]
            self.free[states] = null_space(self.model.contact_rows[held] / self.lengths)
        return self.free[states]

    def _none(self) -> UnstableStanceError:
        return UnstableStanceError(
            "the robot finds no equilibrium on its legs", quantity="place", where="stance"
        )


def _leg_length(model: RobotModel) -> float:
    return max(group.functions.design.length for group in model.groups)


def _settled(group: LegGroup, legs: LegStates) -> LegStates:
    """Legs with the contents and strains that go with their loads."""
    count = len(group.legs)
    _, _, content, strains = group.functions.hanging.rows(
        [legs.load, legs.pressure, legs.strains, np.zeros((count, 2))], count
    )
    return replace(legs, strains=strains, content=content)
