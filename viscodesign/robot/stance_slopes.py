"""How a stance moves with the numbers of a robot: the implicit function theorem.

A stance is where three things hold: every leg's rod meets its foot, all forces balance, and the
contacts stay as they are. Their derivatives with respect to the unknowns and the free numbers
give those of the unknowns; the code that makes the numbers of legs and body is run on numbers
that carry formulas.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.compiled.conditions import Tape
from viscodesign.compiled.traced import Traced, formula_of, free_numbers
from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.friction_problem import DIRECTION, OPEN, STICK
from viscodesign.robot.build_robot import body_masses, mount_of
from viscodesign.robot.leg_design import LegDesign, leg_design
from viscodesign.robot.leg_equations import LOAD, shot_rod
from viscodesign.robot.leg_pose import BODY, FOOT, Mount, foot_below, tip_seen_from_leg
from viscodesign.robot.leg_rod import STRAIN_POINTS
from viscodesign.robot.robot_keys import RobotKeys
from viscodesign.robot.stance import Stance
from viscodesign.scene.loads import STANDARD_GRAVITY
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.several import unlike
from viscodesign.scene.spec_part import copied

SX = ca.SX


@dataclass(frozen=True, eq=False)
class _Leg:
    """Formulas of a leg at a stance."""

    misses: SX
    """Rod's tip minus where the foot is (3,)."""
    reaction: SX
    """Generalised forces of body and foot that it takes (7,)."""
    tip: SX
    hangs_at: SX
    """Its foot below an upright body, unloaded (3,)."""
    stiffness: SX
    """Of its tip across, under its load along the leg."""


class StanceSlopes:
    """Derivatives of a stance at the spec's gauge pressure by free numbers."""

    def __init__(self, keys: RobotKeys, values: np.ndarray, found: Stance) -> None:
        """``found``: the stance with these values (f,)."""
        self._found, self._values = found, values
        self._symbols, traced = free_numbers(keys.names, values, Tape())
        self._spec, self._base = keys.with_values(traced), keys.scene
        model = found.model
        self._place = SX.sym("place", model.size)
        self._loads = SX.sym("loads", LOAD, model.count)
        self._forces = SX.sym("forces", 2 * model.count)
        self._legs = [self._leg(name, k) for k, name in enumerate(model.leg_names)]

    def outputs(self) -> dict[str, SX]:
        """Formulas of all outputs in unknowns and free numbers."""
        robot, place = self._spec.robot, self._place
        heights, stiffness = [], [leg.stiffness for leg in self._legs]
        for name in self._found.model.leg_names:
            x, y, z, *_ = self._mount(name)
            below = z * ca.cos(place[3]) + y * ca.sin(place[3])
            heights.append(x * ca.sin(place[2]) - below * ca.cos(place[2]) - place[1])
        found = {
            "height_m": ca.sum1(ca.vertcat(*heights)) / len(heights),
            "pitch_rad": place[2],
            "roll_rad": place[3],
            "tip_stiffness_n_per_m": ca.sum1(ca.vertcat(*stiffness)) / len(stiffness),
        }
        for k, (name, leg) in enumerate(zip(robot.legs, self._legs, strict=True)):
            for j, axis in enumerate(("x_m", "z_m", "angle_rad")):
                found[f"{name}.tip_{axis}"] = leg.tip[j]
            found[f"{name}.normal_force_n"] = self._forces[k]
        return found

    def of(self, names: Sequence[str]) -> np.ndarray:
        """Derivatives (n, f) of outputs by the free numbers."""
        unknowns = ca.vertcat(self._place, ca.vec(self._loads), self._forces)
        outputs, balance = self.outputs(), self._balance()
        wanted = ca.vertcat(*(outputs[name] for name in names))
        pairs = itertools.product((wanted, balance), (unknowns, self._symbols))
        slopes = ca.Function("slopes", [unknowns, self._symbols], [ca.jacobian(*p) for p in pairs])
        by_unknowns, by_free, of_balance, moved = (
            np.array(part) for part in slopes(self._unknowns(), self._values)
        )
        return np.asarray(by_free - by_unknowns @ np.linalg.solve(of_balance, moved))

    def _unknowns(self) -> np.ndarray:
        found, loads = self._found, np.zeros((self._found.model.count, LOAD))
        for group, own in zip(found.model.groups, found.legs, strict=True):
            loads[group.legs] = own.load
        return np.concatenate([found.place, loads.ravel(), found.contact_forces])

    def _balance(self) -> SX:
        """All of which is zero at a stance."""
        model, place = self._found.model, self._place
        force = self._weights()
        for k, leg in enumerate(self._legs):
            at = [*range(BODY), *range(BODY + FOOT * k, BODY + FOOT * (k + 1))]
            for j, row in enumerate(at):
                force[row] -= leg.reaction[j]
            normal, along = self._forces[k], self._forces[model.count + k]
            x, z, turn = at[BODY:]
            force[z] -= normal
            force[x] += along
            force[turn] += self._radius * along
        misses = [leg.misses for leg in self._legs]
        contacts = [self._contact(k, place[BODY + FOOT * k : BODY + FOOT * (k + 1)])
                    for k in range(model.count)]  # fmt: skip
        return ca.vertcat(force, *misses, *contacts)

    def _contact(self, k: int, foot: SX) -> SX:
        """What holds of a contact that stays as it is (2,)."""
        state = self._found.contact_states[k]
        normal, along = self._forces[k], self._forces[self._found.model.count + k]
        if state == OPEN:
            return ca.vertcat(normal, along)
        gap = -foot[1] - self._radius
        if state == STICK:
            start = self._legs[k].hangs_at
            slip = foot[0] - start[0] + self._radius * (foot[2] - start[2])
            return ca.vertcat(gap, slip)
        friction = formula_of(self._spec.robot.foot.friction)
        return ca.vertcat(gap, along + DIRECTION[state] * friction * normal)

    @property
    def _radius(self) -> SX:
        return formula_of(self._spec.robot.foot.radius)

    def _weights(self) -> SX:
        """Generalised force of gravity (size,)."""
        robot = self._spec.robot
        slope, foot = formula_of(robot.ground.slope), formula_of(robot.foot.mass)
        pull = -STANDARD_GRAVITY * ca.sin(slope), STANDARD_GRAVITY * ca.cos(slope)
        found = SX.zeros(self._found.model.size)
        for axis in range(2):
            found[axis] = formula_of(body_masses(robot)[0]) * pull[axis]
            for k in range(self._found.model.count):
                found[BODY + FOOT * k + axis] = foot * pull[axis]
        return found

    def _mount(self, leg: str) -> list[SX]:
        robot = self._spec.robot
        return [formula_of(number) for number in mount_of(robot, robot.legs[leg])]

    def _leg(self, name: str, k: int) -> _Leg:
        design = self._design(self._spec.robot.legs[name].actuator)
        mount, load = Mount.of(ca.vertcat(*self._mount(name))), self._loads[:, k]
        local, force = SX.sym("place", BODY + FOOT), SX.sym("load", LOAD)
        tip, loaded, hanging = self._tips(design, force)
        seen = tip_seen_from_leg(local[:BODY], local[BODY:], mount)
        work = ca.vertcat(force[0], force[1], force[2] - force[0] * seen[1] + force[1] * seen[0])
        own = ca.Function(
            "leg",
            [local, force, self._symbols],
            [
                tip - seen,
                ca.jtimes(seen, local, work, True),
                tip,
                foot_below(SX.zeros(BODY), hanging, mount),
                loaded,
            ],
        )
        place = ca.vertcat(self._place[:BODY], self._place[BODY + FOOT * k : BODY + FOOT * (k + 1)])
        return _Leg(*own.call([place, load, self._symbols]))

    def _tips(self, design: LegDesign, load: SX) -> tuple[SX, SX, SX]:
        """The tip under a load (3,), its stiffness across, and where it hangs unloaded."""
        pressure = formula_of(self._spec.gauge_pressure)
        pressures = ca.repmat(pressure, len(design.nodes), 1)
        before = SX.zeros(2 * STRAIN_POINTS * len(design.free_sections))
        given = SX.sym("given", LOAD)
        tip = shot_rod(design, given, pressures, before, SX(0)).tip
        flexibility = ca.jacobian(tip, given)
        at = ca.Function("tip", [given, self._symbols], [tip, flexibility])
        along = ca.vertcat(0, load[1], 0)
        straight, soft = at.call([along, self._symbols])
        # As in `tip_stiffness`: the moment at the tip stays zero.
        arm = (straight[1] - load[1] * soft[0, 0]) / (1 + load[1] * soft[0, 2])
        stiffness = 1 / (soft[0, 0] + soft[0, 2] * arm)
        return (
            at.call([load, self._symbols])[0],
            stiffness,
            at.call([SX.zeros(LOAD), self._symbols])[0],
        )

    def _design(self, actuator: str) -> LegDesign:
        """The numbers of a design as formulas."""
        found: LegDesign = _in_formulas(leg_design(traced_leg(self._base, self._spec, actuator)))
        return found


def traced_leg(base: RobotScene, spec: RobotScene, actuator: str) -> Any:
    """An actuator by itself in a spec that differs from another in numbers alone."""
    design = unlike(spec.actuators)[actuator]
    return copied(
        base.leg_scene(actuator),
        {
            "actuator": design.actuator,
            "bellows": design.bellows,
            "network": design.network,
            "fluid_choice": spec.fluid_choice,
            "temperature": spec.temperature,
            "gauge_pressure": spec.gauge_pressure,
            "ambient_pressure": spec.ambient_pressure,
        },
    )


def _in_formulas(part: Any) -> Any:
    """A dataclass whose numbers with formulas are these formulas."""
    if isinstance(part, Traced):
        return part.formula
    if isinstance(part, tuple):
        return tuple(_in_formulas(own) for own in part)
    if is_dataclass(part) and not isinstance(part, type):
        return replace(part, **{f.name: _in_formulas(getattr(part, f.name)) for f in fields(part)})
    return part
