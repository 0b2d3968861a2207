"""Hard cases of a compressible gas, against an independent integrator of its mass balance."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from scipy.integrate import solve_ivp

from tests.hard.case import EXACT, Case, Finding, at_most, true, warned
from tests.hard.linear_cases import in_chain
from tests.hard.network_cases import CHAIN, pressures
from tests.scenes import leg
from tests.validation.rc_network import AMBIENT, COMPLIANCE, REST_VOLUME, resistance
from viscodesign import Trajectory
from viscodesign.effects.collapse import Collapse
from viscodesign.estimate.scene_quantities import SceneQuantities

VISCOSITY = 2e-5
Law = Callable[[np.ndarray], np.ndarray]


def pulse(drop: float) -> tuple[str, Callable[[float], float]]:
    """The paper's pulse with another drop [Pa], as an override and as a function."""
    words = (
        f"input={{kind: double_sigmoid, start: 40.41 kPa, drop: {drop!r}, fall_time: 0.5 s, "
        "rise_time: 4 s, transition: 0.875 s}"
    )
    rate = 6 / 0.875

    def value(t: float) -> float:
        fall, rise = ((1 + np.tanh(rate * (t - centre))) / 2 for centre in (0.5, 4.0))
        return float(40.41e3 - drop * (fall - rise))

    return words, value


def breathing(
    times: np.ndarray, inlet: Callable[[float], float], volume: Law, exponent: float
) -> np.ndarray:
    """Pressures (T, B) of the paper's chain from equilibrium.

    d/dt (rho V) = flow in - flow out, flow = integral of rho dp / R along a tube, with
    rho = (1 + p/p_a)^(1/n) over that at ambient pressure.
    """

    def density(p: np.ndarray) -> np.ndarray:
        return np.asarray((1 + p / AMBIENT) ** (1 / exponent))

    def driving(p: np.ndarray) -> np.ndarray:
        power = 1 + 1 / exponent
        return np.asarray(AMBIENT / power * (1 + p / AMBIENT) ** power)

    def stored_per_pressure(p: np.ndarray) -> np.ndarray:
        step = 1.0
        held = [density(q) * volume(q) for q in (p - 2 * step, p - step, p + step, p + 2 * step)]
        return np.asarray((held[0] - 8 * held[1] + 8 * held[2] - held[3]) / (12 * step))

    def rates(t: float, p: np.ndarray) -> np.ndarray:
        flow = -np.diff(driving(np.append(inlet(t), p))) / resistance(VISCOSITY)
        return np.asarray((flow - np.append(flow[1:], 0.0)) / stored_per_pressure(p))

    start = np.full(len(CHAIN), inlet(0.0))
    found = solve_ivp(
        rates, (0.0, times[-1]), start, method="Radau", t_eval=times, rtol=1e-9, atol=1e-5
    )
    assert found.success, found.message
    return np.asarray(found.y.T)


def linear(p: np.ndarray) -> np.ndarray:
    """Volume of a bellow that never empties [m3]."""
    return np.asarray(REST_VOLUME + COMPLIANCE * p)


def wall(changes: tuple[str, ...]) -> Law:
    """Volume of a collapsing bellow [m3]."""
    law = Collapse.of(SceneQuantities(leg(*changes)))
    return lambda p: np.asarray(REST_VOLUME + law.wall(p)[0])


def gas(number: str, drop: float, exponent: float, hard: str, **digits: float) -> Case:
    """A pulse through the paper's chain; ``digits``: pressures at 1.5 s [Pa]."""
    words, inlet = pulse(drop)
    emptied = drop > 75e3
    changes = (
        words,
        f"fluid={{name: own gas, viscosity: {VISCOSITY}, density: 1.2, gas_constant: 287.05, "
        f"polytropic_exponent: {exponent!r}}}",
        f"effects={{gas_compressibility: on, pressure_distribution: on, tube_compliance: off, collapse: {'on' if emptied else 'off'}, others: off}}",
        "run={duration: 8 s, output_interval: 0.1 s}",
        EXACT,
    )

    def judge(run: Trajectory) -> Iterator[Finding]:
        exact = breathing(run.time, inlet, wall(changes) if emptied else linear, exponent)
        apart = np.max(np.abs(in_chain(run) - exact)) / np.ptp(exact)
        yield at_most("p off, of the swing", float(apart), 1e-6)
        yield from pressures(run, 1.5, **digits)
        yield at_most("mass imbalance", run.invariants.volume_imbalance_rel or 0.0, 1e-10)

    return Case(
        number, hard, "another integrator's pressures; mass conserved to 1e-10", changes, judge
    )


CASES: tuple[Case, ...] = (
    Case(
        "16a",
        "near vacuum, with the effects that the scene needs",
        "no pressure below vacuum, no volume below the floor",
        ("effects=auto",),
        lambda run: [
            true("above vacuum", run.pressure.min() > -101325),
            true("volume stays", run.volume.min() > 0),
            warned(run, "near_vacuum"),
        ],
    ),
    Case(
        "16b",
        "near vacuum, gas without collapse",
        "ends at the minimum volume, with a message",
        ("effects={gas_compressibility: on, collapse: off, others: off}",),
        ending="failed",
        says=("minimum (collapsed) volume", "effects.collapse"),
    ),
    Case(
        "17",
        "gas, one-way",
        "mass conserved to 1e-10",
        (
            "effects={gas_compressibility: on, collapse: on, others: off}",
            "run={duration: 8 s, output_interval: 0.05 s}",
        ),
        lambda run: [at_most("mass imbalance", run.invariants.volume_imbalance_rel or 0.0, 1e-10)],
    ),
    gas(
        "17b",
        60e3,
        1.0,
        "an isothermal gas in a pulse that empties no bellow",
        R1=-14272.854,
        L1=25599.769,
    ),
    gas("17c", 60e3, 1.4, "an adiabatic gas in the same pulse", R1=-14964.508, L1=22622.218),
    gas(
        "16c",
        141.3e3,
        1.0,
        "an isothermal gas near vacuum, its bellows collapsing",
        R1=-66748.393,
        L1=14568.649,
    ),
)
