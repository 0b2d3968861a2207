"""Outputs at the output times as a function of the unknowns, with derivatives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from viscodesign.compiled.endings import Endings
from viscodesign.compiled.problem_at import stretch_of
from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.symbols import Symbols, parameter_names
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.results.channels import CHANNELS, Channel, Per
from viscodesign.solve.problem import Problem

SX = ca.SX
STRAIGHT_TURN = 1e-3
"""Half turn of an arc [rad] below which its chord is taken from a series, exact to round-off."""


@dataclass(frozen=True)
class ReadColumns:
    """Columns, and what they were read from."""

    rows: list[np.ndarray]
    """Arguments of the reading."""
    columns: np.ndarray
    """(T, columns)"""


class Reading:
    """Chosen columns of `trajectory.csv` (T, columns) of unknowns at T times.

    Arguments of a row: states, algebraic unknowns, time, inlet coefficients; the parameters are
    shared by all rows.
    """

    def __init__(self, problem: Problem, members: Members, columns: Sequence[str]) -> None:
        symbols = Symbols.of(problem)
        own = _in_order(problem, symbols.outputs(problem), symbols.parameters)
        places = places_of(problem, members)
        result = ca.vertcat(SX(0, 1), *(own[places[c][0]][places[c][1]] for c in columns))
        self._function = RowFunction(symbols.row, result, shared=1)
        self._endings = Endings(problem)

    def __call__(
        self, problem: Problem, times: np.ndarray, numbers: ProblemNumbers, unknowns: np.ndarray
    ) -> ReadColumns:
        """Columns of a solved problem's unknowns (T, nx + nz) at times (T,).

        Raises `SolveError` where the motion has lost its meaning.
        """
        states = problem.equations.states.count
        x, z = unknowns[:, :states], unknowns[:, states:]
        rows = [x, z, times, numbers.pieces[stretch_of(times, numbers)], numbers.parameters]
        self._endings.check(problem, times, rows)
        return ReadColumns(rows, self._function(*rows))

    def pull_back(self, rows: Sequence[np.ndarray], weights: np.ndarray) -> list[np.ndarray]:
        """Slopes of weights (T, columns) times columns, one array per argument."""
        return self._function.pull_back(rows, weights)

    def push_forward(self, rows: Sequence[np.ndarray], rates: Sequence[np.ndarray]) -> np.ndarray:
        """Rates (T, columns) for the rates of all arguments."""
        return self._function.push_forward(rows, rates)


@dataclass(frozen=True)
class Members:
    """Names of what quantities have one value of."""

    inlets: tuple[str, ...]
    bellows: tuple[str, ...]
    tubes: tuple[str, ...]
    junctions: tuple[str, ...]

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Members:
        """Those of a scene."""
        graph, inlets = quantities.graph, tuple(quantities.scene.inputs)
        tubes = tuple(tube.name for tube in graph.tubes)
        return cls(inlets, graph.bellows, tubes, graph.junctions)

    def columns(self, channel: Channel) -> list[str]:
        """Columns of a quantity, in order."""
        own = {
            Per.INLET: self.inlets,
            Per.BELLOW: self.bellows,
            Per.TUBE: self.tubes,
            Per.JUNCTION: self.junctions,
        }
        if channel.per not in own or (channel.per is Per.INLET and len(self.inlets) == 1):
            return [channel.column()]
        return [channel.column(name) for name in own[channel.per]]


TIP = ("tip_x", "tip_z", "tip_angle")
"""Quantities of the last point of the axis."""
READ = ("inlet_pressure", "pressure", "volume", "junction_pressure", "flow")
"""Quantities that are outputs of the equations under the same name."""


def places_of(problem: Problem, members: Members) -> dict[str, tuple[str, int]]:
    """The columns that can be read: quantity and place in it."""
    found: dict[str, tuple[str, int]] = {}
    flows = problem.equations.network_form is NetworkForm.DISTRIBUTED
    for channel in CHANNELS:
        if channel.quantity in TIP:
            found[channel.column()] = "tip", TIP.index(channel.quantity)
        elif channel.quantity in READ and (flows or channel.quantity != "flow"):
            for k, column in enumerate(members.columns(channel)):
                found[column] = channel.quantity, k
    return found


def _in_order(problem: Problem, values: Mapping[str, SX], parameters: SX) -> dict[str, SX]:
    """Quantities by name, those of bellows in the order of the columns."""
    order = problem.places.tolist()
    own = {name: values[name] for name in READ}
    own |= {name: own[name][order] for name in ("pressure", "volume")}
    return own | {"tip": _tip(problem, values, parameters)}


def _tip(problem: Problem, values: Mapping[str, SX], parameters: SX) -> SX:
    """x, z [m] and angle [rad] of the tip (3,)."""
    if problem.equations.rod_form is not RodForm.ARCS:
        return ca.vertcat(values["position"][-2:], values["angle"][-1])
    length = parameters[parameter_names(problem.equations).index("section_length")]
    x, z, angle = SX(0), SX(0), SX(0)
    curvatures, stretches = values["intrinsic_curvature"], values["intrinsic_stretch"]
    for curvature, stretch in zip(ca.vertsplit(curvatures), ca.vertsplit(stretches), strict=True):
        half = curvature * length / 2
        chord = (1 + stretch) * length * _sinc(half)
        x += chord * ca.sin(angle + half)
        z += chord * ca.cos(angle + half)
        angle += 2 * half
    return ca.vertcat(x, z, angle)


def _sinc(half: SX) -> SX:
    """sin(half)/half, with all derivatives at zero."""
    square, is_straight = half**2, ca.fabs(half) < STRAIGHT_TURN
    safe = ca.if_else(is_straight, 1.0, half)
    return SX(ca.if_else(is_straight, 1 - square / 6 + square**2 / 120, ca.sin(safe) / safe))
