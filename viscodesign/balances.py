"""Balances that must hold in every run: amount of fluid, and energy."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from viscodesign.model.graph import Component
from viscodesign.model.network_equations import NetworkForm
from viscodesign.solve.problem import Problem
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.transient import Solution
from viscodesign.trajectory import Invariants

STANDSTILL = 1e-3
"""Part of what is stored below which a motion counts as none in the balances."""
ENERGY_NOISE = 1e-4
"""Part of the work by which the output grid may misjudge a work integral and still be told."""

MOST_STEPS_BETWEEN = 20
"""Steps between two outputs, on average, up to which these show all that happens."""
FLOW_NOISE = 1e-6
"""Part of what flowed in by which its integral may differ from what it fills."""

ENERGIES = ("fluid_energy", "kinetic_energy", "load_energy", "elastic_energy")

Rows = Mapping[str, np.ndarray]


def _columns(problem: Problem, component: Component) -> list[int]:
    """Where a component's nodes stand among those that hold fluid."""
    own = set(component.nodes)
    names = [*problem.bellows_along_tubes, *problem.equations.storing]
    return [k for k, name in enumerate(names) if name in own]


def _energy_imbalance(
    problem: Problem, solution: Solution, rows: Rows, end: int
) -> tuple[float | None, float | None]:
    """Energy balance over the work done, and the work of unpaired coupling [J].

    Work that pressures do through an unpaired volume, and through the whole volume
    where one pressure is shared, is integrated over the solved times; where they are
    too coarse for it the balance is not told.
    """
    if end < 5:
        return None, None
    every = np.arange(0, end, 2)
    energies = [rows[name][every, 0] for name in ENERGIES if name in rows]
    stored = np.sum(energies, axis=0)
    pressure, unpaired = rows["pressure"][:end], rows["unpaired_volume"][:end]
    coupling, noise = _work(unpaired, pressure)
    carried, carried_noise = _work(rows["carried_energy"][:end], rows["stored"][:end])
    integrals = dict(zip(problem.equations.rates, solution.integrals[:, every], strict=True))
    if "pump_power" in integrals and _tells_flows(problem, solution, end):
        pump = integrals["pump_power"] - integrals["tube_loss"]
        scale = float(np.max(np.abs(integrals["pump_power"])))
    else:
        pump, pump_noise = _work(rows["specific_work"][:end], rows["stored"][:end])
        plunger, plunger_noise = _work(rows["plunger_pressure"][:end], rows["pushed"][:end])
        pump = pump + plunger
        noise = noise + pump_noise + plunger_noise
        scale = float(np.max(np.abs(pump)))
    lost = integrals.get("material_loss", np.zeros(len(every)))
    scale = max(
        scale,
        # Where nothing comes in, energies turn into each other.
        *(float(np.ptp(energy)) for energy in energies),
        float(np.max(np.abs(coupling))),
        STANDSTILL * float(np.max(np.abs(stored))),
        STANDSTILL**2 * _usual_energy(problem),
    )
    if scale == 0.0:
        return 0.0, 0.0
    coupled = float(coupling[-1]) if np.any(unpaired) else None
    noise = noise + carried_noise
    # Samples that are rarer than the swings look smooth and are not.
    rare = noise > 0.0 and solution.work.steps > MOST_STEPS_BETWEEN * end
    if rare or noise > ENERGY_NOISE * scale:
        return None, coupled
    imbalance = stored - stored[0] - pump + lost - coupling - carried
    return float(np.max(np.abs(imbalance))) / scale, coupled


def _usual_energy(problem: Problem) -> float:
    """What the bellows hold at the pressures that the scene is about [J]."""
    states, algebraics = problem.equations.states.blocks, problem.equations.algebraics.blocks
    if "volume" not in states or "pressure" not in algebraics:
        return 0.0
    return len(problem.bellows) * float(np.max(states["volume"].size * algebraics["pressure"].size))


def _tells_flows(problem: Problem, solution: Solution, end: int) -> bool:
    """Whether flows are more than round-off of the pressures that drive them.

    Through tubes that hardly resist, they follow from tiny differences of pressures: what
    they fill is known far better than they are themselves. The work is read from that, then,
    and the balance no longer sees an error of the pump's or the tubes': in a linear network
    it holds by itself.
    """
    equations = problem.equations
    if "inflow" not in equations.states.blocks:
        return True
    filled = equations.states.physical("inflow", solution.states)[:, :end].sum(axis=0)
    flowed = solution.integrals[list(equations.rates).index("flow"), :end]
    apart = np.max(np.abs(filled - filled[0] - (flowed - flowed[0])))
    return bool(apart <= FLOW_NOISE * np.max(np.abs(filled - filled[0]), initial=0.0))


def _work(force: np.ndarray, path: np.ndarray) -> tuple[np.ndarray, float]:
    """Running integral of force d(path), summed over columns, at every second row.

    The trapezoidal rule on all rows and on every second one, extrapolated to nothing
    between them (Richardson); the second value is how far that still is uncertain, by
    the next doubling.
    """
    fine, coarse = (_trapezoids(force, path, step) for step in (1, 2))
    coarsest = _trapezoids(force, path, 4)
    best = (4 * fine[::2] - coarse) / 3
    worse = (4 * coarse[::2] - coarsest) / 3
    return best, float(np.max(np.abs(best[::2] - worse))) / 15


def _trapezoids(force: np.ndarray, path: np.ndarray, step: int) -> np.ndarray:
    some, way = force[::step], path[::step]
    parts = np.sum((some[1:] + some[:-1]) / 2 * np.diff(way, axis=0), axis=1)
    return np.concatenate([[0.0], np.cumsum(parts)])


@dataclass(frozen=True)
class Block:
    """Consecutive solved edges: scaled unknowns (n, m), integrals (nq, m), named outputs (m, n)."""

    first: int
    """Number of the first edge."""
    states: np.ndarray
    algebraics: np.ndarray
    integrals: np.ndarray
    rows: Rows


class Ledger:
    """Both balances of a run, told block by block."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._fluid = FluidLedger(problem)
        self._kept: list[Block] = []
        self._edges = 0

    def add(self, block: Block) -> None:
        """Take in the edges that follow those before."""
        self._fluid.add(block)
        self._edges += block.states.shape[1]
        told = {name: block.rows[name] for name in ASKED_FOR if name in block.rows}
        # Of what is more than can be held the balance of energy is not told.
        is_held = self._edges <= MOST_EDGES
        self._kept = [*self._kept, replace(block, rows=told)] if is_held else []

    def invariants(self, steps: int) -> Invariants:
        """What holds over all edges told, to which an integrator came in ``steps``."""
        if not self._kept:
            return Invariants(self._fluid.imbalance(), None, None)
        kept = self._kept
        states = np.concatenate([block.states for block in kept], axis=1)
        integrals = np.concatenate([block.integrals for block in kept], axis=1)
        rows = {n: np.concatenate([block.rows[n] for block in kept]) for n in kept[0].rows}
        solution = Solution(states, states[:0], integrals, self._edges, Work(steps=steps))
        energy, coupling = _energy_imbalance(self._problem, solution, rows, self._edges)
        return Invariants(self._fluid.imbalance(), energy, coupling)


MOST_EDGES = 50_000
"""Edges over which work is summed up at once."""
ASKED_FOR = (
    *ENERGIES,
    "pressure",
    "unpaired_volume",
    "carried_energy",
    "stored",
    "specific_work",
    "plunger_pressure",
    "pushed",
)


class FluidLedger:
    """Largest difference between what flowed in and what is stored, over what moved."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        equations = problem.equations
        self._fed = [_columns(problem, c) for c in equations.fed]
        self._sealed = [_columns(problem, c) for c in equations.sealed]
        self._start: np.ndarray | None = None
        self._apart = np.zeros(len(self._fed) + len(self._sealed))
        self._inflow = np.zeros(len(self._fed))
        self._moved = self._held = 0.0

    def add(self, block: Block) -> None:
        """Take in the edges that follow those before."""
        stored = block.rows["stored"]
        if not stored.size:
            return
        if self._start is None:
            self._start = stored[0]
        self._moved = max(self._moved, float(np.max(np.abs(stored - self._start))))
        self._held = max(self._held, float(np.max(np.abs(stored))))
        self._add_fed(block, stored)
        self._add_sealed(stored)

    def _add_fed(self, block: Block, stored: np.ndarray) -> None:
        states = self._problem.equations.states
        if "inflow" not in states.blocks:
            return
        inflows = states.physical("inflow", block.states)
        for k, (own, inflow) in enumerate(zip(self._fed, inflows, strict=True)):
            self._inflow[k] = max(self._inflow[k], float(np.max(np.abs(inflow))))
            self._note(k, stored, own, inflow)

    def _add_sealed(self, stored: np.ndarray) -> None:
        equations = self._problem.equations
        distributed = equations.network_form is NetworkForm.DISTRIBUTED
        filled = zip(self._sealed, equations.sealed_volumes, strict=True)
        for k, (own, volume) in enumerate(filled, start=len(self._fed)):
            assert self._start is not None
            reference = 0.0 if distributed else volume - float(self._start[own].sum())
            self._note(k, stored, own, reference)

    def _note(self, k: int, stored: np.ndarray, own: list[int], came: np.ndarray | float) -> None:
        assert self._start is not None
        gained = stored[:, own].sum(axis=1) - self._start[own].sum()
        self._apart[k] = max(self._apart[k], float(np.max(np.abs(gained - came))))

    def imbalance(self) -> float:
        """Over all edges told."""
        # Where nothing moves, round-off is told against what is stored.
        moved = max(self._moved, STANDSTILL * self._held)
        scale = np.full(len(self._apart), moved)
        scale[: len(self._fed)] = np.maximum(moved, self._inflow)
        return float(np.max(self._apart / scale, initial=0.0)) if moved else 0.0
