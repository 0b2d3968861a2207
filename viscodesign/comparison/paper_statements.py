"""What the paper says of Figures 3 and 4, each statement a check of computed motions."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence

import numpy as np
import yaml

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.loop_part import LoopPart
from viscodesign.results.paper_figure import PaperCheck
from viscodesign.results.trajectory import Trajectory

Outcome = tuple[bool | None, str]
"""Whether it holds (None: errors hide it), and the numbers in words."""
Judge = Callable[..., Outcome]
MIN_M = 1e-9
"""Length below which there is rounding alone."""
CLEARLY_RAD = math.radians(10.0)
"""Tip angles that differ by more than this are called significantly different."""
NOTABLY = 0.05
"""Part by which one loop has to be narrower than another to be called so."""
PURELY = 0.2
"""Width over height up to which a motion is called almost purely axial."""
SAME_PATTERN = 0.05
"""Remaining distance, of the size of the path, up to which two paths have one pattern."""
A_THIRD = (7 / 24, 5 / 12)
"""Parts that are nearer to a third than to a quarter or a half."""
FIRST_FALL_S = 1.0
"""End of the first transition of the paper's pulse [s]."""
UNCHANGED = 1e-3
"""Change of a pressure, of the input's range, that counts as none."""


@dataclass(frozen=True)
class Statement:
    """A sentence of the paper about some scenes."""

    figure: int
    panel: str
    section: str
    words: str
    specs: tuple[str, ...]
    judge: Judge
    """Takes the runs of these specs in order."""

    def check(self, runs: Mapping[str, Trajectory]) -> PaperCheck:
        """Its outcome for these runs, by spec."""
        own = [runs[name] for name in self.specs]
        broken = [f"{run.name} {run.status}" for run in own if run.status != "complete"]
        if broken:
            return self._told(None, f"not checked: {', '.join(broken)}")
        outside = [run.name for run in own if run.violations]
        return self._told(*self.judge(*own), tuple(outside))

    def _told(self, agrees: bool | None, found: str, outside: tuple[str, ...] = ()) -> PaperCheck:
        told = self.figure, self.panel, self.section, self.words, agrees, found
        return PaperCheck(*told, outside)


def checks_of(figure: int, runs: Mapping[str, Trajectory]) -> tuple[PaperCheck, ...]:
    """All statements about a figure."""
    return tuple(s.check(runs) for s in STATEMENTS if s.figure == figure)


# -- what is measured -----------------------------------------------------------------------


def _mm(length: float) -> str:
    return f"{1e3 * length:.3g} mm" if abs(length) >= MIN_M else "0 mm"


def _error(run: Trajectory) -> float:
    """Stated error of the tip [m]; 0 where none is stated."""
    return run.accuracy.estimated_tip_error_m or 0.0


def _exceeds(difference: float, *runs: Trajectory) -> bool | None:
    """Whether a difference is positive; None where it is less than the stated errors."""
    margin = sum(_error(run) for run in runs)
    return None if abs(difference) <= margin else difference > 0


def _hidden(agrees: bool | None) -> str:
    return "" if agrees is not None else ", less than the stated errors"


def path_mean(run: Trajectory) -> np.ndarray:
    """Mean position (x, z) along the path, over the last period or the whole run [m]."""
    path = LoopPart.of(run.time, run.period).path.values(run.tip[:, :2])
    steps = np.hypot(*np.diff(path, axis=0).T)
    return np.asarray((path[1:] + path[:-1]).T @ steps / (2 * steps.sum()))


def _shift(run: Trajectory, plain: Trajectory, axis: int) -> float:
    return float((path_mean(run) - path_mean(plain))[axis])


def _steady_move(run: Trajectory) -> np.ndarray:
    """From the tip's place at rest to where it is in the end (x, z) [m]."""
    return np.asarray(run.tip[-1, :2] - (0.0, run.length))


def _without_input(run: Trajectory) -> dict[str, object]:
    spec = yaml.safe_load(run.spec_text)
    return {key: v for key, v in spec.items() if key not in ("name", "input", "inputs", "run")}


# -- Figure 3 ---------------------------------------------------------------------------------


def _starts_extended(run: Trajectory) -> Outcome:
    longer = float(run.tip[0, 1]) - run.length
    return longer > _error(run), f"the tip starts {_mm(longer)} below its place at rest"


def _wider(straight: Trajectory, crossed: Trajectory) -> Outcome:
    wide, narrow = (run.metrics["loop_width_m"] for run in (straight, crossed))
    agrees = _exceeds(wide - narrow, straight, crossed, straight, crossed)  # two ends each
    less = 1 - narrow / wide
    found = f"{_mm(wide)} wide straight, {_mm(narrow)} crossed, {100 * less:.2g} % narrower"
    if agrees is not None and abs(less) < NOTABLY:
        return None, f"{found}, less than the {100 * NOTABLY:g} % that a picture shows"
    return agrees, found + _hidden(agrees)


def _angles_differ(straight: Trajectory, crossed: Trajectory) -> Outcome:
    apart = np.abs(straight.tip[:, 2] - crossed.tip[:, 2])
    k = int(np.argmax(apart))
    angles = f"up to {math.degrees(apart[k]):.0f} degrees apart, at {straight.time[k]:.3g} s"
    return bool(apart[k] > CLEARLY_RAD), f"tip angles are {angles}"


def _alike(straight: Trajectory, crossed: Trajectory) -> Outcome:
    senses = [run.metrics["loop_area_m2"] for run in (straight, crossed)]
    orders = [_order(run) for run in (straight, crossed)]
    words = [("counter-clockwise" if sense > 0 else "clockwise") for sense in senses]
    return (
        words[0] == words[1] and orders[0] == orders[1],
        f"straight goes {orders[0]}, {words[0]}; crossed {orders[1]}, {words[1]}",
    )


def _order(run: Trajectory) -> str:
    right, left = run.metrics["tip_x_max_time_s"], run.metrics["tip_x_min_time_s"]
    return "right first, then left" if right < left else "left first, then right"


def _bends(side: int) -> Judge:
    def judge(run: Trajectory) -> Outcome:
        x, z = _steady_move(run)
        word = "right" if x > 0 else "left"
        return side * x > _error(run), f"{_mm(abs(x))} to the {word}, {_mm(abs(z))} {_up(z)}"

    return judge


def _lengthens(sense: int) -> Judge:
    def judge(run: Trajectory) -> Outcome:
        x, z = _steady_move(run)
        straight = abs(x) <= max(_error(run), MIN_M)
        word = "longer" if z > 0 else "shorter"
        return straight and sense * z > _error(run), f"{_mm(abs(z))} {word}, {_mm(abs(x))} aside"

    return judge


def _up(z: float) -> str:
    return "down" if z > 0 else "up"


# -- Figure 4 -----------------------------------------------------------------------------------


def _right_then_left(water: Trajectory) -> Outcome:
    x, known = water.tip[:, 0], water.metrics
    found = (
        f"{_mm(x.max())} to the right at {known['tip_x_max_time_s']:.3g} s, "
        f"{_mm(-x.min())} to the left at {known['tip_x_min_time_s']:.3g} s"
    )
    both = x.max() > _error(water) and x.min() < -_error(water)
    return both and _order(water) == "right first, then left", found


def _axial(air: Trajectory) -> Outcome:
    wide, high = air.metrics["loop_width_m"], air.metrics["loop_height_m"]
    return wide <= PURELY * high, f"{_mm(wide)} wide, {_mm(high)} high"


def _lies(axis: int, sign: int) -> Judge:
    """The mean of the first run's path is further along an axis than that of all others."""

    def judge(own: Trajectory, *others: Trajectory) -> Outcome:
        margin = _error(own) + max(_error(run) for run in others)
        mean, rest = path_mean(own), [path_mean(run)[axis] for run in others]
        name = "xz"[axis]
        found = f"mean {name} {_mm(mean[axis])}, the others {', '.join(map(_mm, rest))}"
        return all(sign * (mean[axis] - value) > margin for value in rest), found

    return judge


def _in_the_middle(own: Trajectory, *others: Trajectory) -> Outcome:
    mean, rest = path_mean(own)[0], [path_mean(run)[0] for run in others]
    found = f"mean x {_mm(mean)}, the others {', '.join(map(_mm, rest))}"
    return all(abs(mean) < abs(value) for value in rest), found


def _input_alone(*runs: Trajectory) -> Outcome:
    specs = [_without_input(run) for run in runs]
    differing = {key for spec in specs for key in spec if spec[key] != specs[0].get(key)}
    words = (
        f"the specs differ in {', '.join(sorted(differing))}"
        if differing
        else (f"all {len(runs)} specs are equal but for their inputs")
    )
    return not differing, words


def _less_flow(plain: Trajectory, tripled: Trajectory) -> Outcome:
    peaks = [float(np.abs(r.flow[:, r.tubes.index("R1-R2")]).max()) for r in (plain, tripled)]
    ratio = peaks[1] / peaks[0]
    found = f"the peak flow through R1-R2 falls by {100 * (1 - ratio):.0f} %"
    return A_THIRD[0] < 1 - ratio < A_THIRD[1], found


def _first_swings_more(plain: Trajectory, tripled: Trajectory) -> Outcome:
    first = plain.bellows.index("R1")
    swings = [np.ptp(run.pressure, axis=0) for run in (plain, tripled)]
    early = [np.ptp(run.pressure[run.time <= FIRST_FALL_S, first]) for run in (plain, tripled)]
    more = swings[1] - swings[0]
    others = np.delete(more, first)
    found = (
        f"over the cycle R1 swings by {more[first] / 1e3:+.2g} kPa, the others by "
        f"{others.min() / 1e3:+.2g} to {others.max() / 1e3:+.2g} kPa; until {FIRST_FALL_S:g} s, "
        f"while the far bellows lag, R1 swings by {(early[1] - early[0]) / 1e3:+.2g} kPa"
    )
    return bool(more[first] > 0 and np.all(others < more[first])), found


def _moves(axis: int, sign: int) -> Judge:
    def judge(plain: Trajectory, other: Trajectory) -> Outcome:
        shift = _shift(other, plain, axis)
        words = (("left", "right"), ("up", "down"))[axis][int(shift > 0)]
        agrees = _exceeds(sign * shift, plain, other)
        found = f"the mean of the path moves {_mm(abs(shift))} {words}"
        return agrees, found + _hidden(agrees)

    return judge


def _difference_stays(plain: Trajectory, *others: Trajectory) -> Outcome:
    half = plain.sections
    swing = float(np.ptp(plain["inlet_pressure"]))

    def apart(run: Trajectory) -> np.ndarray:
        return np.asarray(run.pressure[:, half:] - run.pressure[:, :half])

    largest = max(float(np.abs(apart(run) - apart(plain)).max()) for run in others)
    found = f"differences between columns change by {largest:.3g} Pa of {swing / 1e3:.4g} kPa"
    return largest <= UNCHANGED * swing, found


def _same_pattern(plain: Trajectory, *others: Trajectory) -> Outcome:
    size = float(np.ptp(plain.tip[:, :2], axis=0).max())
    left = []
    for run in others:
        apart = run.tip[:, :2] - plain.tip[:, :2]
        left.append(float(np.hypot(*(apart - apart.mean(axis=0)).T).max()))
    found = f"without their mean shift the paths are {_mm(max(left))} apart, of {_mm(size)}"
    return max(left) <= SAME_PATTERN * size, found


AIR, CROSSED, TRIPLED = "leg_16_straight_air", "leg_16_crossed_air", "leg_16_triple_tube"
MINUS, PLUS = "leg_16_gauge_minus_2kpa", "leg_16_gauge_plus_2kpa"
WORKSPACE = tuple(f"workspace_{name}" for name in ("middle", "right", "left", "lower"))


def _first_of(name: str, names: Sequence[str]) -> tuple[str, ...]:
    return (name, *(other for other in names if other != name))


STATEMENTS = (
    Statement(3, "A", "3.1", "the straight leg begins extended", (AIR,), _starts_extended),
    Statement(3, "B", "3.1", "the crossed leg begins extended", (CROSSED,), _starts_extended),
    Statement(
        3, "B", "3.1", "straight connectivity produces wide motion, a crossing narrower cycles",
        (AIR, CROSSED), _wider,
    ),
    Statement(
        3, "B", "3.1", "the trajectories of the tip appear qualitatively similar",
        (AIR, CROSSED), _alike,
    ),
    Statement(3, "B", "3.1", "significantly different tip angles", (AIR, CROSSED), _angles_differ),
    Statement(3, "C", "3.1", "(+) - (-) will bend to the right", ("steady_right",), _bends(1)),
    Statement(3, "C", "3.1", "(-) - (+) to the left", ("steady_left",), _bends(-1)),
    Statement(3, "D", "3.1", "(+) - (+) will extend", ("steady_extend",), _lengthens(1)),
    Statement(3, "D", "3.1", "(-) - (-) will contract", ("steady_contract",), _lengthens(-1)),
    Statement(
        4, "A", "3.2", "water: first on the right half of the workspace, then the left",
        ("leg_4_water",), _right_then_left,
    ),
    Statement(
        4, "A", "3.2", "air: almost pure axial extension and contraction", ("leg_4_air",), _axial
    ),
    Statement(
        4, "B", "3.3", "biased to the middle", _first_of(WORKSPACE[0], WORKSPACE[:3]),
        _in_the_middle,
    ),
    Statement(4, "B", "3.3", "to the right", _first_of(WORKSPACE[1], WORKSPACE), _lies(0, 1)),
    Statement(4, "B", "3.3", "to the left", _first_of(WORKSPACE[2], WORKSPACE), _lies(0, -1)),
    Statement(4, "B", "3.3", "to the lower part", _first_of(WORKSPACE[3], WORKSPACE), _lies(1, 1)),
    Statement(4, "B", "3.3", "by varying only the input signal", WORKSPACE, _input_alone),
    Statement(
        4, "C", "3.4", "a tube three times as long can reduce local mass flux by a third",
        (AIR, TRIPLED), _less_flow,
    ),
    Statement(
        4, "C", "3.4", "the first right bellow contracts and expands more, and only that",
        (AIR, TRIPLED), _first_swings_more,
    ),
    Statement(4, "C", "3.4", "the motion tilts down", (AIR, TRIPLED), _moves(1, 1)),
    Statement(4, "C", "3.4", "and to the left", (AIR, TRIPLED), _moves(0, -1)),
    Statement(
        4, "D", "3.4.1", "only the sum of pressures is changed, not the difference",
        (AIR, MINUS, PLUS), _difference_stays,
    ),
    Statement(4, "D", "3.4.1", "the same motion pattern", (AIR, MINUS, PLUS), _same_pattern),
    Statement(4, "D", "3.4.1", "-2 kPa shifts the cycle up", (AIR, MINUS), _moves(1, -1)),
    Statement(4, "D", "3.4.1", "+2 kPa shifts the cycle down", (AIR, PLUS), _moves(1, 1)),
)  # fmt: skip
"""Section and words as in the paper, shortened; thresholds that they need stand above."""
