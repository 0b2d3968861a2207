"""A robot as a function of free numbers: how it stands, with derivatives, and how it walks."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence

import numpy as np

from viscodesign.compiled.batch import COMPLETE, Batch, Outputs, batch_of
from viscodesign.compiled.given_values import Values, listed_rows, names_of, values_in_order
from viscodesign.compiled.keyed_function import KeyedFunction
from viscodesign.errors import Fault, SolveError, SpecError, ViscodesignError, not_among
from viscodesign.results.walk_study import WalkStudy
from viscodesign.robot.build_robot import build_robot
from viscodesign.robot.robot_keys import RobotKeys
from viscodesign.robot.stance import Stance
from viscodesign.robot.stance_slopes import StanceSlopes
from viscodesign.robot.stand import own_stance
from viscodesign.robot.tip_stiffness import tip_stiffness
from viscodesign.robot.walk import standing, walk
from viscodesign.scene.robot_scene import RobotScene

SWAY_LIMIT = "sway_limit_n"
STANCE = ("height_m", "pitch_rad", "roll_rad", "tip_stiffness_n_per_m")
OF_LEGS = ("tip_x_m", "tip_z_m", "tip_angle_rad", "normal_force_n")
"""Outputs of each leg at the stance; its tip from its hip, along and across the unbent leg."""
GAIT: dict[str, Callable[[WalkStudy], float]] = {
    "advance_per_cycle_m": lambda study: study.advance_per_cycle_m,
    "speed_body_lengths_per_s": lambda study: study.speed_body_lengths_per_s,
    "pump_volume_m3": lambda study: study.pump_volume_m3,
    "pump_run_volume_m3": lambda study: study.pump_run_volume_m3,
    "pump_flow_m3_s": lambda study: max(pump.flow_m3_s for pump in study.pumps.values()),
}
NO_SLOPE = {
    SWAY_LIMIT: "it is found to a thousandth, and where contacts change it has a kink",
    **dict.fromkeys(
        GAIT,
        "feet land, stick and slide at times that the steps decide, so that its slope depends on "
        "the step where its value no longer does",
    ),
}
"""Outputs without derivatives, and why."""
INSTEAD = "take differences over a range that moves it by far more than its error, or `sweep`"


class CompiledRobot(KeyedFunction[RobotKeys]):
    """Numbers of a robot as a function of free numbers [SI].

    Outputs of the stance, as `stand` has it at the spec's gauge pressure and payload:
    ``height_m``, ``pitch_rad``, ``roll_rad``, ``tip_stiffness_n_per_m``, and of every leg
    ``LF.tip_x_m``, ``LF.tip_z_m``, ``LF.tip_angle_rad``, ``LF.normal_force_n``. They have exact
    derivatives, by the equations of the stance. ``sway_limit_n``, and the outputs of the gait,
    ``advance_per_cycle_m``, ``speed_body_lengths_per_s``, ``pump_volume_m3``,
    ``pump_run_volume_m3`` and ``pump_flow_m3_s``, have values alone: derivatives are refused, and
    the message says why.
    """

    def __init__(self, scene: RobotScene, free: Sequence[str], outputs: Sequence[str]) -> None:
        free, self.outputs = names_of("free", free), names_of("outputs", outputs)
        self._made_of = scene, free, self.outputs
        self._keys = RobotKeys(scene, free)
        of_legs = [f"{leg}.{name}" for leg in scene.robot.legs for name in OF_LEGS]
        known = [*STANCE, SWAY_LIMIT, *of_legs, *GAIT]
        if unknown := [name for name in self.outputs if name not in known]:
            raise SpecError([Fault(not_among(name, known), "outputs") for name in unknown])

    def __call__(self, values: Values | None = None) -> Outputs:
        """Every output, a number each, at values (f,), by default the spec's own.

        Raises `SpecError` for values that are out of range, `SolveError` where the robot does not
        stand, or where no speed is stated.
        """
        given = self._array(values)
        scene, found = self.scene(given), dict[str, float]()
        if any(name not in NO_SLOPE for name in self.outputs):
            found |= _stance_outputs(_stands(scene))
        if SWAY_LIMIT in self.outputs:
            found[SWAY_LIMIT] = own_stance(scene)[0].sway_limit_n
        if wanted := [name for name in self.outputs if name in GAIT]:
            study = walk(scene)
            if study.refusal:
                raise SolveError(f"no speed is stated: {study.refusal}", quantity="speed",
                                 where="gait")  # fmt: skip
            found |= {name: GAIT[name](study) for name in wanted}
        return {name: found[name] for name in self.outputs}

    def jacobian(self, values: Values | None = None) -> Outputs:
        """Derivatives (f,) of every output by the free numbers.

        Raises `SpecError` where an output has none.
        """
        given = self._array(values)
        if without := [name for name in self.outputs if name in NO_SLOPE]:
            raise SpecError(
                [Fault(f"has no derivative: {NO_SLOPE[n]}; {INSTEAD}", n) for n in without]
            )
        slopes = StanceSlopes(self._keys, given, _stands(self.scene(given)))
        return dict(zip(self.outputs, slopes.of(self.outputs), strict=True))

    def vjp(self, values: Values | None, weights: Mapping[str, float]) -> np.ndarray:
        """Gradient (f,) of the sum of weights times outputs; ``weights``: of some or all."""
        if unknown := [name for name in weights if name not in self.outputs]:
            raise SpecError([Fault(not_among(unknown[0], self.outputs), "weights")])
        slopes = self.jacobian(values)
        found = [float(weight) * slopes[name] for name, weight in weights.items()]
        return np.asarray(np.sum([np.zeros(len(self.names)), *found], axis=0))

    def batch(self, rows: Iterable[Values] | np.ndarray) -> Batch:
        """Outputs of many rows of values (N, f), one after the other.

        A row that fails is NaN, and `Batch.status` says why.
        """
        found: list[tuple[Outputs | None, str]] = []
        for values in listed_rows(rows, self.names):
            try:
                found.append((self(values), COMPLETE))
            except ViscodesignError as error:
                found.append((None, str(error)))
        return batch_of(found, dict.fromkeys(self.outputs, math.nan))

    def scene(self, values: Values | None = None) -> RobotScene:
        """The robot with these values. Raises `SpecError` where they make no valid spec."""
        given = self._array(values)
        faults = [n.fault(float(v)) for n, v in zip(self._keys.numbers, given, strict=True)]
        if any(faults):
            raise SpecError([fault for fault in faults if fault is not None])
        return self._keys.validated(given)

    def _array(self, values: Values | None) -> np.ndarray:
        """Values in order (f,)."""
        found = values_in_order(values, self.names, self.values)
        if found.shape != (len(self.names),):
            message = f"expected {len(self.names)} values, one for each free number"
            raise SpecError.plain(f"{message}; got an array of shape {found.shape}")
        return found


def _stands(scene: RobotScene) -> Stance:
    """The stance at the spec's gauge pressure. Raises `UnstableStanceError` where there is none."""
    model = build_robot(scene)
    pressures = np.full(len(model.source_names), scene.gauge_pressure)
    return standing(scene, model, pressures, "at the spec's gauge pressure")


def _stance_outputs(found: Stance) -> Outputs:
    """All outputs of a stance."""
    pitch, roll = found.place[2:4].tolist()
    height = float(np.mean(found.model.hip_heights(found.place)))
    outputs = dict(zip(STANCE, (height, pitch, roll, tip_stiffness(found)), strict=True))
    for group, legs in zip(found.model.groups, found.legs, strict=True):
        count = len(group.legs)
        tips, *_ = group.functions.hanging.rows(
            [legs.load, legs.pressure, legs.strains, np.zeros((count, 2))], count
        )
        for k, tip in zip(group.legs.tolist(), tips.tolist(), strict=True):
            own = (*tip, float(found.contact_forces[k]))
            name = found.model.leg_names[k]
            outputs |= {f"{name}.{o}": value for o, value in zip(OF_LEGS, own, strict=True)}
    return outputs
