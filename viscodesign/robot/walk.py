"""The gait of a robot: `walk`."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.errors import Fault, SolveError, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.friction_problem import OPEN
from viscodesign.results.stand_study import Fall
from viscodesign.results.walk_study import WalkStudy
from viscodesign.robot.build_robot import build_robot, start_pressures
from viscodesign.robot.falls import slide, tip_over
from viscodesign.robot.gait_numbers import foot_uses, invariants, pump_uses
from viscodesign.robot.gait_warnings import emptied, gait_warnings
from viscodesign.robot.leg_pose import BODY, FOOT
from viscodesign.robot.march import Progress, RecordedWalk, StepPlan, march
from viscodesign.robot.robot_model import RobotModel
from viscodesign.robot.stance import Stance, UnstableStanceError, set_down, stance
from viscodesign.robot.stated_speed import STEPS, refusal, relative_change
from viscodesign.robot.time_step import RobotState
from viscodesign.robot.vacuum import refuse_sources_in_vacuum
from viscodesign.scene.reading.write import part_yaml
from viscodesign.scene.robot_scene import RobotScene

COMPARED_CYCLES = 2
"""Whose advances are compared."""


def walk(
    scene: RobotScene, *, steps_per_cycle: int | None = None, progress: Progress | None = None
) -> WalkStudy:
    """The gait of a robot under its inputs.

    The step is halved until the advance per cycle changes by less than the scene's accuracy;
    where it still changes by 3 % or more, from step to step or from cycle to cycle, no speed is
    stated, and the study says why. So it does where Ctrl-C or a failure ends a later solution; of
    the first one, it keeps the part that was solved.
    ``steps_per_cycle``: steps of a cycle at first; ``progress`` is told the fraction done of each
    solution.

    Raises `SpecError` for inputs without a common period or below vacuum, and for runs of less
    than two cycles, `SolveError` where the robot does not stand at the start or a step does not
    converge right at the start.
    """
    began = clock.perf_counter()
    refuse_sources_in_vacuum(scene)
    model = build_robot(scene)
    gait = _Gait(scene, model, steps_per_cycle or STEPS.per_cycle)
    levels = gait.refined(progress)
    study = _study(scene, model, levels, clock.perf_counter() - began)
    return study if gait.stop is None else _ended(study, gait.stop, levels[0].recording.stop)


def _ended(study: WalkStudy, stop: BaseException, early: BaseException | None) -> WalkStudy:
    """A study whose solutions ended with ``stop``; ``early``: what ended the first of them."""
    is_interrupt = isinstance(stop, KeyboardInterrupt)
    why = "interrupted" if is_interrupt else str(stop)
    if early is not None:
        end = "interrupted" if is_interrupt else "failed"
        time = study.motion.time[-1]
        return replace(study, end=end, refusal=f"{why}; the gait ends at t = {time:.4g} s")
    step = 1e3 * study.steps_s[-1]
    return replace(study, refusal=f"{why}, in the solution with half of {step:.3g} ms")


@dataclass(frozen=True, eq=False)
class _Level:
    """A solution with one step."""

    recording: RecordedWalk
    solve_cpu_s: float

    @property
    def advance(self) -> float:
        """In the last cycle [m]; NaN where there is none."""
        advances = self.recording.motion.advances
        return float(advances[-1]) if len(advances) else math.nan


class _Gait:
    """Solutions of one gait with smaller and smaller steps."""

    def __init__(self, scene: RobotScene, model: RobotModel, per_cycle: int) -> None:
        self.scene, self.model, self.per_cycle = scene, model, per_cycle
        self.period = _period(scene)
        self.cycles = _cycles(scene, self.period)
        self.start = start_state(scene, model)
        self.stop: BaseException | None = None
        """Why the step was not halved to the end."""

    def refined(self, progress: Progress | None) -> list[_Level]:
        """Solutions until halving the step hardly moves the advance."""
        levels = [self._solved(self.per_cycle, progress)]
        self.stop = levels[0].recording.stop
        for k in range(1, STEPS.most_halvings + 1 if self.stop is None else 1):
            try:
                finer = self._solved(self.per_cycle << k, progress)
                self.stop = finer.recording.stop
            except (SolveError, KeyboardInterrupt) as stop:
                self.stop = stop
            if self.stop is not None:
                break
            levels.append(finer)
            change = step_change(levels, self.scene.robot.body_length)
            is_damped = _is_resolved(self.model, levels[-1])
            if change <= self.scene.accuracy and is_damped:
                break
            if not is_damped and self.model.damping_time == 0.0 and k > 1:
                break  # no step is small enough
        return levels

    def _solved(self, per_cycle: int, progress: Progress | None) -> _Level:
        plan = StepPlan(self.period, per_cycle, self.cycles, self._every(per_cycle))
        if plan.count > self.scene.run.max_steps:
            raise _fault(
                self.scene,
                "run.max_steps",
                f"the gait needs {plan.count} steps; at most {self.scene.run.max_steps} are "
                "allowed. Use a shorter run.duration",
            )
        began = clock.process_time()
        pressures = _pressures(self.scene)
        recording = march(self.model, self.start, pressures, plan, progress)
        return _Level(recording, clock.process_time() - began)

    def _every(self, per_cycle: int) -> int:
        """Steps of an output interval."""
        steps = self.scene.run.output_interval * per_cycle / self.period
        return max(1, round(steps))


def step_change(levels: Sequence[_Level], body_length: float) -> float:
    """Relative change of the advance per cycle when the step was last halved."""
    if len(levels) < 2:
        return math.nan
    before, last = levels[-2].advance, levels[-1].advance
    return relative_change(before, last, body_length)


def path_errors(levels: Sequence[_Level]) -> tuple[float, float]:
    """Largest distance of the paths of body and feet with the last two steps [m]; else NaN.

    What halving the step moves a path by is the error that a solution of first order has left.
    """
    if len(levels) < 2:
        return math.nan, math.nan
    coarse, fine = (level.recording.motion for level in levels[-2:])
    count = min(len(coarse.time), (len(fine.time) + 1) // 2)
    same = slice(0, 2 * count - 1, 2)
    body = coarse.body[:count, :2] - fine.body[same, :2]
    feet = coarse.feet[:count, :, :2] - fine.feet[same, :, :2]
    body_error, feet_error = (
        float(np.max(np.hypot(*np.moveaxis(own, -1, 0)))) for own in (body, feet)
    )
    return body_error, feet_error


def start_state(scene: RobotScene, model: RobotModel) -> RobotState:
    """A robot that stands, or that is held above the ground and let go."""
    pressures, sources = start_pressures(scene), len(model.source_names)
    if scene.robot.hip_height is not None:
        place, legs = set_down(model, pressures)
        lift = scene.robot.hip_height - float(np.mean(model.hip_heights(place)))
        place[[1, *range(BODY + 1, model.size, FOOT)]] -= lift
        still, contacts = np.zeros(model.size), np.zeros(2 * model.count)
        states = (OPEN,) * model.count
        return RobotState(0.0, place, still, legs, contacts, states, np.zeros(sources))
    return standing(scene, model, pressures, "at the start").state(sources)


def standing(scene: RobotScene, model: RobotModel, pressures: np.ndarray, when: str) -> Stance:
    """The stable stance at gauge pressures of the sources [Pa]; ``when``: that is, in words.

    Raises `UnstableStanceError` where there is none, and says how the robot falls.
    """
    if (fall := slide(model)) is not None:
        raise _falls(scene, fall, when)
    try:
        found = stance(model, pressures)
    except UnstableStanceError:
        raise _sway(scene, model, pressures, when) from None
    if not found.is_stable:
        raise _sway(scene, model, pressures, when)
    return found


def _falls(scene: RobotScene, fall: Fall, when: str) -> UnstableStanceError:
    return UnstableStanceError(
        f"{scene.name}: the robot {fall.how} {when}: {fall.why}",
        quantity="place",
        where="stance",
        time_s=0.0,
    )


def _sway(
    scene: RobotScene, model: RobotModel, pressures: np.ndarray, when: str
) -> UnstableStanceError:
    if (fall := tip_over(model, pressures)) is not None:
        return _falls(scene, fall, when)
    return UnstableStanceError(
        f"{scene.name}: the robot sways on its legs {when}, under its weight of "
        f"{model.weight:.4g} N",
        quantity="place",
        where="stance",
        time_s=0.0,
        remedy="`viscodesign stand` shows how much they bear",
    )


def _pressures(scene: RobotScene) -> Callable[[np.ndarray], np.ndarray]:
    def at(times: np.ndarray) -> np.ndarray:
        values = [source.values(times) for source in scene.sources.values()]
        return scene.gauge_pressure + np.column_stack(values)

    return at


def _period(scene: RobotScene) -> float:
    if scene.period is None:
        problem = scene.no_period().replace("run.start: equilibrium", "`viscodesign stand`")
        raise _fault(scene, "inputs", f"a gait needs inputs that repeat; {problem}")
    return scene.period


def _cycles(scene: RobotScene, period: float) -> int:
    cycles = math.floor(scene.run.duration / period * (1 + 1e-12))
    if cycles < COMPARED_CYCLES:
        raise _fault(
            scene,
            "run.duration",
            f"{scene.run.duration:g} s is less than {COMPARED_CYCLES} cycles of {period:g} s, "
            f"whose advances are compared; use at least {COMPARED_CYCLES * period:g} s",
        )
    return cycles


def _fault(scene: RobotScene, key: str, message: str) -> SpecError:
    return SpecError([Fault(message, key, scene.source.file)])


def _is_resolved(model: RobotModel, level: _Level) -> bool:
    """Whether the legs' damping is that of the spec, not that of the steps."""
    return model.damping_time >= STEPS.damping_ratio * level.recording.motion.step / 2


def _study(
    scene: RobotScene, model: RobotModel, levels: Sequence[_Level], total_s: float
) -> WalkStudy:
    last = levels[-1]
    motion, length = last.recording.motion, scene.robot.body_length
    body_error, feet_error = path_errors(levels)
    before, after = ([math.nan, math.nan, *motion.advances.tolist()])[-2:]
    study = WalkStudy(
        name=scene.name,
        body_length_m=length,
        motion=motion,
        steps_s=tuple(level.recording.motion.step for level in levels),
        advances_by_step_m=tuple(level.advance for level in levels),
        advances_by_cycle_m=tuple(motion.advances.tolist()),
        body_path_error_m=body_error,
        feet_path_error_m=feet_error,
        step_halving_change=step_change(levels, length),
        cycle_change=relative_change(before, after, length),
        refusal="",
        end="",
        feet=foot_uses(motion),
        pumps=pump_uses(motion, scene.robot.pump),
        invariants=invariants(model, last.recording),
        energy=last.recording.energy,
        warnings=tuple(gait_warnings(model, last.recording)),
        spec_text=part_yaml(scene),
        solve_cpu_s=last.solve_cpu_s,
        total_s=total_s,
    )
    return replace(
        study,
        refusal=refusal(
            study, is_damped=_is_resolved(model, last), emptied=emptied(model, last.recording)
        ),
    )
