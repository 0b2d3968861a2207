"""Hard cases of bellows whose pressure falls as they swell: they snap one after another."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator

from tests.hard.case import EXACT, Case, Finding, Judge, at_most, relative, true, warned
from tests.hard.network_cases import tubes
from tests.validation.rc_network import LENGTH, resistance
from viscodesign import Trajectory

AREA = np.array([-60, -30, 0, 20, 40, 60, 90, 130, 180, 240, 320]) * 1e-6
PRESSURE = np.array([-30, -14, 0, 12, 20, 23, 19, 14, 16, 26, 45]) * 1e3
"""A balloon-like bellow [m2, Pa]: it snaps at 23 kPa, and back at 14 kPa."""
CURVE = f"bellows.curve={{rows: {np.column_stack([PRESSURE, AREA, 300 * AREA, AREA]).tolist()}}}"
COUNT = 4
ORDER = ["R1", "R2", "L2", "L1"]
VISCOSITY = 1e-3
FLUID = f"fluid={{name: own, viscosity: {VISCOSITY}, density: 1000}}"
ALONE = "effects={pressure_distribution: on, material_curve: on, others: off}"
LAW = PchipInterpolator(LENGTH * AREA, PRESSURE)
SLOPE = LAW.derivative()

Source = Callable[[float], float]


def law(swelling: np.ndarray) -> np.ndarray:
    """Pressure of a swelling, straight beyond the rows."""
    inside = np.clip(swelling, LENGTH * AREA[0], LENGTH * AREA[-1])
    return np.asarray(LAW(inside) + SLOPE(inside) * (swelling - inside))


def ramp(*points: tuple[float, float]) -> tuple[str, Source]:
    """An input through points, as an override and as a function."""
    rows = ", ".join(f"[{t!r} s, {p!r}]" for t, p in points)
    times, values = zip(*points, strict=True)
    return f"input={{kind: table, rows: [{rows}]}}", lambda t: float(np.interp(t, times, values))


def swollen(times: np.ndarray, source: Callable[[float, float], float]) -> np.ndarray:
    """Swellings (T, B) of a chain from rest; ``source``: (t, volume delivered) -> pressure."""
    resist = resistance(VISCOSITY)

    def rates(t: float, y: np.ndarray) -> np.ndarray:
        pressure = np.append(source(t, y[0]), law(y[1:]))
        flow = -np.diff(pressure) / resist
        return np.concatenate([flow[:1], flow - np.append(flow[1:], 0.0)])

    found = solve_ivp(
        rates,
        (0.0, times[-1]),
        np.zeros(1 + COUNT),
        method="Radau",
        t_eval=times,
        rtol=1e-9,
        atol=1e-15,
        max_step=0.01,
    )
    assert found.success, found.message
    return np.asarray(found.y[1:].T)


def followed(run: Trajectory, exact: np.ndarray) -> Iterator[Finding]:
    """Volumes and pressures against swellings (T, B) in the order of the chain."""
    columns = [run.bellows.index(name) for name in ORDER]
    volume, pressure = run.volume[:, columns], run.pressure[:, columns]
    apart = np.max(np.abs(volume - volume[0] - exact)) / np.ptp(exact)
    yield at_most("volume off, of the swing", float(apart), 1e-6)
    off = np.max(np.abs(pressure - law(exact))) / np.ptp(law(exact))
    yield at_most("p off, of the swing", float(off), 1e-6)
    yield warned(run, "snapping_curve")


def under(source: Source) -> Judge:
    """The chain is driven by a pressure."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        exact = swollen(run.time, lambda t, given: source(t))
        yield from followed(run, exact)
        late = exact.max(axis=0) > BEYOND
        yield true("some bellows snap", bool(late.any()))

    return judge


SPEED, BORE, BARREL = 2e-3, 0.02, 0.1
"""Speed of a syringe's plunger [m/s], diameter and length of its barrel [m]."""
BULK = 2e9
"""Bulk modulus of its liquid [Pa]."""
BEYOND = LENGTH * 1.5e-4
"""A swelling beyond the last falling part [m3]."""


def pushed(run: Trajectory) -> Iterator[Finding]:
    """The chain is driven by a plunger, which prescribes its volume."""
    section = np.pi * BORE**2 / 4

    def barrel(t: float, given: float) -> float:
        left = section * (BARREL - SPEED * t)
        return BULK * ((section * BARREL - given) / left - 1)

    yield from followed(run, swollen(run.time, barrel))
    pressure = run.pressure[:, run.bellows.index("R1")]
    fall = float(np.max(np.maximum.accumulate(pressure) - pressure))
    yield true("the pressure falls while the plunger pushes on", fall > 1e3)


def one_after_another(run: Trajectory) -> Iterator[Finding]:
    """When each passes the area of the last falling part: no two at once."""
    columns = [run.bellows.index(name) for name in ORDER]
    swelling = run.volume[:, columns] - run.volume[0, columns]
    big = swelling > BEYOND
    first = [float(run.time[int(np.argmax(big[:, k]))]) for k in range(COUNT) if big[:, k].any()]
    yield relative("bellows that snapped", len(first), COUNT, 0.0)
    yield true("one after another", bool(np.min(np.diff(np.sort(first))) > 0.05))


def slow_ramp(name: str, *points: tuple[float, float]) -> Case:
    words, source = ramp(*points)
    duration = points[-1][0]
    return Case(
        name,
        "a pressure raised and lowered through the snaps of a chain",
        "another integrator's volumes and pressures",
        (
            f"bellows.count={COUNT}",
            CURVE,
            words,
            FLUID,
            ALONE,
            EXACT,
            f"run={{duration: {duration!r}, output_interval: 0.1 s}}",
        ),
        under(source),
    )


CASES: tuple[Case, ...] = (
    slow_ramp("43a", (0.0, 0.0), (4.0, 3e4), (6.0, 3e4), (8.0, 0.0)),
    Case(
        "43b",
        "a syringe pushes a chain through its snaps",
        "prescribed volumes; another integrator's pressures, falling and rising",
        (
            f"bellows.count={COUNT}",
            CURVE,
            ALONE,
            # The pressures behind a plunger are less accurate than the tip.
            "accuracy=0.00002 %",
            f"fluid={{name: own, viscosity: {VISCOSITY}, density: 1000, bulk_modulus: {BULK!r}}}",
            f"input={{kind: syringe, diameter: {BORE!r}, start: {BARREL!r}, speeds: [[0, {SPEED!r}]]}}",
            "run={duration: 12 s, output_interval: 0.1 s}",
        ),
        pushed,
    ),
    Case(
        "43c",
        "the same with all effects that the scene needs",
        "bellows snap one after another",
        (
            f"bellows.count={COUNT}",
            CURVE,
            "effects=auto",
            FLUID,
            ramp((0.0, 0.0), (20.0, 3e4))[0],
            "run={duration: 80 s, output_interval: 0.1 s}",
        ),
        one_after_another,
    ),
    Case(
        "43d",
        "a run that begins above the snap",
        "refused: no steady state is reached without a snap",
        (CURVE, FLUID, ALONE, "input={kind: constant, value: 30 kPa}"),
        ending="refused",
        says=("snaps", "run.start: rest"),
    ),
    Case(
        "43e",
        "one pressure for a network that snaps",
        "refused: only flow determines how fast it snaps",
        (CURVE, "effects={material_curve: on, others: off}"),
        ending="refused",
        says=("bellows.curve", "effects.pressure_distribution"),
    ),
    Case(
        "43f",
        "sealed bellows, filled up to near the snap, beside a fed one",
        "their pressure and volume stay",
        (
            f"bellows.count={COUNT}",
            CURVE,
            FLUID,
            ALONE,
            EXACT,
            "gauge_pressure=15 kPa",
            tubes("inlet R1 37.5", "R2 L2 37.5", "L2 L1 37.5"),
            ramp((0.0, 0.0), (2.0, 1e4))[0],
            "run={duration: 2 s, output_interval: 0.1 s}",
        ),
        lambda run: [
            at_most("drift [Pa]", float(np.max(np.abs(run.pressure[:, [1, 2, 3]] - 15e3))), 1e-3)
        ],
    ),
)
