"""One step through time: implicit Euler, with contact at the end of the step.

In flight, between steps at whose ends no foot touches the ground, that is the motion in a frame
that falls along: the centre of mass keeps to its parabola exactly.

Gaps and slips are those of the end of the step, not their rates: nothing drifts into the ground.
The bodies' coordinates, the legs' loads and pressures and the contact forces are solved together
by Newton's method; each of its steps solves the contacts of the linearised robot exactly.
Source: D. E. Stewart and J. C. Trinkle, An implicit time-stepping scheme for rigid body dynamics
with inelastic collisions and Coulomb friction, 1996, has this form of Moreau-Jean time stepping.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.friction_problem import OPEN, ContactError, FrictionProblem, States
from viscodesign.robot.leg_equations import LOAD
from viscodesign.robot.leg_pose import BODY, FOOT
from viscodesign.robot.robot_model import (
    LegGroup,
    LegStates,
    LinearisedLegs,
    RobotModel,
    linearised,
)


@dataclass(frozen=True, eq=False)
class Trend:
    """What the steps before tell of the next one, of the same length."""

    step: float
    """[s]"""
    faster: np.ndarray
    """Change of the velocity (size,)."""
    last: tuple[np.ndarray, ...]
    """Change of load and pressures in the last step, by group (l, m)."""
    expected: tuple[np.ndarray, ...]
    """The same in the next step, in line with the last two."""

    @classmethod
    def of(
        cls, step: float, faster: np.ndarray, last: tuple[np.ndarray, ...], before: Trend | None
    ) -> Trend:
        """After a step; ``before``: what was told at its beginning."""
        if before is None or before.step != step:
            return cls(step, faster, last, last)
        pairs = zip(last, before.last, strict=True)
        return cls(step, faster, last, tuple(2 * own - older for own, older in pairs))


@dataclass(frozen=True, eq=False)
class RobotState:
    """A robot at a time."""

    time: float
    place: np.ndarray
    """Body (x, z, pitch, roll), then every foot (x, z, rotation)."""
    velocity: np.ndarray
    legs: tuple[LegStates, ...]
    """By group."""
    contact_forces: np.ndarray
    """Normal, then tangential (2c,) [N]."""
    contact_states: States
    drawn: np.ndarray
    """Out of each source since the start, as volume at ambient density [m3]."""
    trend: Trend | None = None
    """None where no step led to it."""


MAX_STEP_ITERATIONS = 25
IMPLICITNESS = 0.5
"""Share of a step's flows that are those at its end: smooth flows are integrated to order 2."""
PLACE_TOLERANCE = 1e-6
"""Last Newton step of a place, rotations by `ROTATION_LENGTH` [m]; the error left is of the order
of its square."""
ROTATION_LENGTH = 0.02
"""About the radius of a foot [m]."""
PRESSURE_TOLERANCE = 1e-5
"""Last Newton step of a pressure, relative to the ambient pressure."""


@dataclass(frozen=True, eq=False)
class Step:
    """A step that was done."""

    solver: StepSolver
    begun: RobotState
    after: RobotState
    begin: np.ndarray
    """Gauge pressures of the sources as it begins (S,) [Pa]."""
    end: np.ndarray

    @property
    def fall(self) -> np.ndarray:
        """Velocity that gravity gives everything in flight, by which no energy is lost (size,)."""
        is_flight = is_in_air(self.begun) and is_in_air(self.after)
        return np.asarray(2 / self.solver.step * self.solver.fall * is_flight)

    def gas_imbalance(self) -> float:
        """As `StepSolver.gas_imbalance`."""
        return self.solver.gas_imbalance(self.begun, self.after, self.end)


class StepSolver:
    """Advances a robot by equal steps."""

    def __init__(self, model: RobotModel, step: float, halvings: int = 0) -> None:
        """``step`` [s]; ``halvings``: how often it was halved since it did not converge."""
        self.model, self.step, self.halvings = model, step, halvings
        self._numbers = (IMPLICITNESS * step, model.damping_time / step)
        self._inertia = np.diag(model.masses / step**2)
        self._lengths = np.ones(model.size)
        self._lengths[[2, 3, *range(BODY + 2, model.size, FOOT)]] = ROTATION_LENGTH
        self.fall = step**2 / 2 * model.weights / model.masses
        """Way of everything that falls from rest in a step (size,) [m]."""
        self.iterations = 0
        """Newton steps so far."""

    def advance(self, now: RobotState, sources: np.ndarray) -> RobotState:
        """The state a step later; ``sources``: their gauge pressures then [Pa]."""
        if is_in_air(now):
            found = self._advanced(now, sources, in_flight=True)
            if is_in_air(found):
                return found
        return self._advanced(now, sources, in_flight=False)

    def _advanced(self, now: RobotState, sources: np.ndarray, *, in_flight: bool) -> RobotState:
        """The same, in a frame that falls along or in that of the ground."""
        fall = self.fall if in_flight else np.zeros(self.model.size)
        begun = tuple(self._begun(own) for own in now.legs)
        place, legs = self._expected(now, begun)
        states, pressures = now.contact_states, [sources[g.sources][:, None] for g in self.groups]
        for _ in range(MAX_STEP_ITERATIONS):
            self.iterations += 1
            around = [
                linearised(group, place[group.places], own, before, source, self._numbers)
                for group, own, before, source in zip(
                    self.groups, legs, begun, pressures, strict=True
                )
            ]
            change, forces, states = self._contact_step(now, place, around, states, fall)
            place = place + change
            steps = [
                own.own + (own.own_by_place @ change[group.places][:, :, None])[:, :, 0]
                for group, own in zip(self.groups, around, strict=True)
            ]
            legs = tuple(_moved(own, step) for own, step in zip(legs, steps, strict=True))
            if self._is_done(change, steps):
                return self._after(now, begun, place, legs, sources, forces, states, fall)
        raise SolveError(
            "the step does not converge",
            quantity="place",
            where="robot",
            time_s=now.time,
            remedy="Legs may be near buckling; lower the payload or the gauge pressure",
        )

    def _expected(
        self, now: RobotState, begun: tuple[LegStates, ...]
    ) -> tuple[np.ndarray, tuple[LegStates, ...]]:
        """Place and legs from which to begin: they go on as in the step before."""
        trend = now.trend
        if trend is None or trend.step != self.step:
            return now.place + self.step * now.velocity, begun
        legs = tuple(_moved(own, change) for own, change in zip(begun, trend.expected, strict=True))
        return now.place + self.step * (now.velocity + trend.faster), legs

    def halved(self) -> StepSolver:
        """Steps of half the length."""
        return StepSolver(self.model, self.step / 2, self.halvings + 1)

    def gas_imbalance(self, now: RobotState, after: RobotState, sources: np.ndarray) -> float:
        """Largest part of a node's content in excess of what a step leaves there [1]."""
        worst = 0.0
        for group, own, before in zip(self.groups, after.legs, now.legs, strict=True):
            begun = replace(own, strains=before.strains, content=self._begun(before).content)
            arguments = self._arguments(group, after.place, begun, sources)
            residual, _ = group.functions.plain.rows(arguments, len(group.legs))
            design = group.functions.design
            excess = residual[:, LOAD : LOAD + design.bellows] * design.bellow.rest_volume
            held = own.content[:, : design.bellows]
            worst = max(worst, float(np.max(np.abs(excess / held))))
        return worst

    def _arguments(
        self, group: LegGroup, place: np.ndarray, legs: LegStates, sources: np.ndarray
    ) -> list[np.ndarray]:
        """Arguments of a group's functions, with strains and contents as the step begins."""
        numbers = np.tile(self._numbers, (len(group.legs), 1))
        own = sources[group.sources][:, None]
        return [
            *(place[group.places], legs.load, legs.pressure, group.mounts),
            *(legs.strains, legs.content, own, numbers),
        ]

    def _begun(self, legs: LegStates) -> LegStates:
        """Legs with what flows in by the rates at the step's beginning."""
        early = (1 - IMPLICITNESS) * self.step * legs.inflow[:, :-1]
        return replace(legs, content=legs.content + early)

    @property
    def groups(self) -> tuple[LegGroup, ...]:
        """Groups of legs."""
        return self.model.groups

    def _contact_step(
        self,
        now: RobotState,
        place: np.ndarray,
        around: Sequence[LinearisedLegs],
        guess: States,
        fall: np.ndarray,
    ) -> tuple[np.ndarray, np.ndarray, States]:
        """Newton's step of the place, with the contact forces and states that go with it."""
        model, rows = self.model, self.model.contact_rows
        force, stiffness = model.assembled(around)
        moved = place - now.place
        faster = (moved + fall) / self.step - now.velocity
        inertial = model.masses * faster / self.step
        right = np.column_stack([model.weights - inertial - force, rows.T])
        solved = np.linalg.solve(self._inertia + stiffness, right)
        free = rows @ solved[:, 0]
        free[: model.count] += model.gaps(place)
        free[model.count :] += rows[model.count :] @ moved
        friction = (model.feet.friction,) * model.count
        try:
            forces, states = FrictionProblem(rows @ solved[:, 1:], free, friction).solve(guess)
        except ContactError as error:
            raise SolveError(
                str(error), quantity="contact force", where="feet", time_s=now.time
            ) from None
        return solved[:, 0] + solved[:, 1:] @ forces, forces, states

    def _is_done(self, change: np.ndarray, steps: Sequence[np.ndarray]) -> bool:
        if np.max(np.abs(change) * self._lengths) > PLACE_TOLERANCE:
            return False
        ambient = self.groups[0].functions.design.fluid.ambient
        return all(np.max(np.abs(s[:, LOAD:])) <= PRESSURE_TOLERANCE * ambient for s in steps)

    def _after(
        self,
        now: RobotState,
        begun: Sequence[LegStates],
        place: np.ndarray,
        legs: Sequence[LegStates],
        sources: np.ndarray,
        forces: np.ndarray,
        states: States,
        fall: np.ndarray,
    ) -> RobotState:
        """The state at the end of the step: contents are what was there and what flowed in."""
        drawn, after = now.drawn.copy(), []
        for group, own, before in zip(self.groups, legs, begun, strict=True):
            arguments = self._arguments(group, place, own, sources)
            strains, inflow = group.functions.after.rows(arguments, len(group.legs))
            content = before.content + IMPLICITNESS * self.step * inflow[:, :-1]
            after.append(LegStates(own.load, own.pressure, strains, content, inflow))
            mean = IMPLICITNESS * inflow + (1 - IMPLICITNESS) * before.inflow
            np.add.at(drawn, group.sources, self.step * mean[:, -1])
        velocity = (place - now.place + fall) / self.step
        changes = tuple(
            np.hstack([own.load - older.load, own.pressure - older.pressure])
            for own, older in zip(after, now.legs, strict=True)
        )
        trend = Trend.of(self.step, velocity - now.velocity, changes, now.trend)
        return RobotState(
            now.time + self.step, place, velocity, tuple(after), forces, states, drawn, trend
        )


def is_in_air(state: RobotState) -> bool:
    """Whether no foot touches the ground."""
    return all(contact == OPEN for contact in state.contact_states)


def _moved(legs: LegStates, step: np.ndarray) -> LegStates:
    """Legs with their loads and pressures moved by a Newton step."""
    return replace(legs, load=legs.load + step[:, :LOAD], pressure=legs.pressure + step[:, LOAD:])
