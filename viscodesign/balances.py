"""Balances that must hold in every run: amount of fluid, and energy."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from viscodesign.model.graph import Component
from viscodesign.model.network_equations import NetworkForm
from viscodesign.solve.problem import Problem
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


def read_invariants(problem: Problem, solution: Solution, rows: Rows, end: int) -> Invariants:
    """Both balances over the first ``end`` solved times; ``rows``: named outputs (T, n)."""
    volume = _volume_imbalance(problem, solution, rows, end)
    energy, coupling = _energy_imbalance(problem, solution, rows, end)
    return Invariants(volume, energy, coupling)


def _volume_imbalance(problem: Problem, solution: Solution, rows: Rows, end: int) -> float:
    """Largest difference between what flowed in and what is stored, over what moved."""
    equations = problem.equations
    stored = rows["stored"][:end]
    # Where nothing moves, round-off is told against what is stored.
    moved = max(
        float(np.max(np.abs(stored - stored[0]))), STANDSTILL * float(np.max(np.abs(stored)))
    )
    worst = 0.0
    given = inflows(problem, solution)
    for component in equations.fed if given else ():
        own = [given[name][:end] for name in component.inlets if name in given]
        inflow = np.sum(own, axis=0)
        held = stored[:, holding_columns(problem, component)].sum(axis=1)
        scale = max(moved, float(np.max(np.abs(inflow))))
        worst = max(worst, float(np.max(np.abs(held - held[0] - inflow))) / scale)
    for component, filled in zip(equations.sealed, equations.sealed_volumes, strict=True):
        held = stored[:, holding_columns(problem, component)].sum(axis=1)
        reference = held[0] if equations.network_form is NetworkForm.DISTRIBUTED else filled
        worst = max(worst, float(np.max(np.abs(held - reference))) / moved)
    return worst


def inflows(problem: Problem, solution: Solution) -> dict[str, np.ndarray]:
    """What each inlet of given pressure let in since t = 0, at every solved edge [m3].

    Nothing where one pressure is shared: there no flow is followed.
    """
    equations = problem.equations
    if "inflow" not in equations.states.blocks:
        return {}
    rows = equations.states.physical("inflow", solution.states)
    return dict(zip(equations.driven, rows, strict=True))


def holding_columns(problem: Problem, component: Component) -> list[int]:
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
