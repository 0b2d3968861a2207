"""Hard cases of the network: timescales, contrasts, jumps, sealed and branching parts."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator

import numpy as np

from tests.hard.case import EXACT, Case, Finding, Judge, at_most, relative, true, warned
from tests.scenes import chain_order, leg
from tests.validation.test_network import exact_step_response, tubes
from viscodesign import Scene, Trajectory, simulate
from viscodesign.estimate.scene_quantities import SceneQuantities

ONE_WAY = "effects={pressure_distribution: on, others: off}"
CHAIN = chain_order(8)
STEP = "input={kind: step, value: 1e5}"
SWING = 1e-6
"""Tolerance of pressures in exact cases, as a fraction of the inlet's swing."""


def fluid(viscosity: float) -> str:
    """A fluid with the viscosity of the references."""
    return f"fluid={{name: own, viscosity: {viscosity!r}, density: 1.2}}"


AIR, WATER = fluid(2e-5), fluid(1e-3)


def until(duration: float, *times: float, start: str = "equilibrium") -> str:
    """A run with few output times."""
    told = (
        f", output_times: {[0.0, *times, duration]}"
        if times
        else f", output_times: [0, {duration!r}]"
    )
    return f"run={{duration: {duration!r}, start: {start}{told}}}"


def swing(run: Trajectory) -> float:
    """Range of all pressures of a run, at the inlets and inside [Pa]."""
    told = [run.pressure.ravel(), *run.inlet_pressure.values()]
    return float(np.ptp(np.concatenate(told)))


def pressures(
    run: Trajectory, time: float, share: float = SWING, **wanted: float
) -> Iterator[Finding]:
    """Pressures of named bellows at one time."""
    row = int(np.argmin(np.abs(run.time - time)))
    for name, value in wanted.items():
        found = float(run.pressure[row, run.bellows.index(name)])
        yield Finding(f"p {name}({time:g} s)", found, value, share * swing(run))


def at(time: float, share: float = SWING, **wanted: float) -> Judge:
    """The same as a criterion."""
    return lambda run: pressures(run, time, share, **wanted)


def custom(*ends: str, unit: float = 37.5) -> str:
    """A custom network from 'a b 1' triples: ends, and length in units of a tube of the paper."""
    entries = [entry.split() for entry in ends]
    return tubes(*(f"{a} {b} {unit * float(length)!r}" for a, b, length in entries))


LISTED = ["inlet R1 1", *(f"{a} {b} 1" for a, b in itertools.pairwise(CHAIN))]


def step_response(run: Trajectory) -> Iterator[Finding]:
    """Against the matrix exponential of the same graph."""
    scene = leg(*LOOPS)
    exact = exact_step_response(scene, run.time, 1e5)
    names = [n for n in scene.graph.components()[0].bellows]
    found = run.pressure[:, [run.bellows.index(n) for n in names]]
    yield at_most("p off, of the step", float(np.max(np.abs(found - exact))) / 1e5, SWING)


LOOPS = (
    "bellows.count=6",
    custom(
        "inlet R1 1",
        "R1 R2 0.5",
        "R2 R3 2",
        "R3 L3 1",
        "L3 L2 0.3",
        "L2 L1 1",
        "L1 R1 4",
        "R2 L2 1",
    ),
    STEP,
    ONE_WAY,
    AIR,
    EXACT,
    "run={duration: 0.5 s, output_interval: 0.05 s}",
)


def junction_flows(run: Trajectory) -> Iterator[Finding]:
    """What flows into a junction flows out."""
    flow = dict(zip(run.tubes, run.flow.T, strict=True))
    left = flow["inlet-j"] - flow["j-R1"] - flow["j-L1"]
    yield at_most(
        "flow lost at the junction", float(np.max(np.abs(left)) / np.max(np.abs(run.flow))), 1e-12
    )


def as_one_of(*changes: str, share: float = SWING) -> Judge:
    """Pressures are those of another spec."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        other = simulate(leg(*changes))
        row = [int(np.argmin(np.abs(other.time - t))) for t in run.time]
        apart = float(np.max(np.abs(run.pressure - other.pressure[row])))
        yield at_most("pressures apart, of the swing", apart / swing(run), share)

    return judge


def gain(name: str, frequency: float, wanted: float) -> Judge:
    """Amplitude of a bellow relative to the inlet's, in the last two periods."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        late = run.time >= run.time[-1] - 2 / frequency
        turn = 2 * np.pi * frequency * run.time[late]
        basis = np.column_stack((np.sin(turn), np.cos(turn), np.ones_like(turn)))
        found, *_ = np.linalg.lstsq(basis, run.pressure[late, run.bellows.index(name)], rcond=None)
        yield relative(f"gain of {name}", float(np.hypot(*found[:2])) / 1e4, wanted, 1e-5)

    return judge


def long_swing(run: Trajectory) -> Iterator[Finding]:
    """The last of a thousand cycles has the exact phase, mean and amplitude."""
    yield from pressures(run, 1e5, 1e-9, R1=-5545.395082138, L1=-10226.98012285)
    scene, turn = leg(*LONG_SINE), 2 * np.pi * 0.01
    exact = steady_swing(scene, turn)
    for name, (cycle, wanted) in itertools.product(("R1", "L1"), ((500, exact), (999, exact))):
        told = (run.time >= 100.0 * cycle) & (run.time <= 100.0 * (cycle + 1))
        found = fitted(run.time[told], run.pressure[told, run.bellows.index(name)], turn)
        where = f"of {name} in cycle {cycle}"
        yield Finding(f"phase {where}", found[0], np.angle(wanted[name]), 1e-6)
        yield relative(f"amplitude {where}", found[1], abs(wanted[name]), 1e-7)
        yield at_most(f"mean {where}", found[2], 1e-4)
    early, late = (run.pressure[k : k + 21] for k in (10 * 20, 999 * 20))
    yield at_most("drift of a cycle, of the swing", np.max(np.abs(late - early)) / swing(run), 1e-8)


def fitted(time: np.ndarray, pressure: np.ndarray, turn: float) -> tuple[float, float, float]:
    """Phase [rad], amplitude and mean of a sine of ``turn`` radians a second."""
    basis = np.column_stack((np.sin(turn * time), np.cos(turn * time), np.ones_like(time)))
    (sine, cosine, mean), *_ = np.linalg.lstsq(basis, pressure, rcond=None)
    return float(np.arctan2(cosine, sine)), float(np.hypot(sine, cosine)), float(mean)


def steady_swing(scene: Scene, turn: float) -> dict[str, complex]:
    """Exact phasors of a chain's bellows under a sine of 50 kPa."""
    quantities = SceneQuantities(scene)
    (part,) = scene.graph.components()
    laplacian = quantities.laplacian(part)
    inlet = np.zeros(len(part.bellows))
    inlet[part.bellows.index("R1")] = 1 / quantities.resistances["inlet-R1"]
    storing = 1j * turn * quantities.bellow.compliance * np.eye(len(inlet))
    return dict(zip(part.bellows, 5e4 * np.linalg.solve(storing + laplacian, inlet), strict=True))


LONG_SINE = (
    ONE_WAY,
    WATER,
    EXACT,
    "input={kind: sine, amplitude: 50 kPa, frequency: 0.01 Hz}",
    "run={duration: 1e5 s, output_interval: 5 s}",
)


def settled(run: Trajectory) -> Iterator[Finding]:
    """Back where the pulse began, everywhere, and permanently."""
    late = run.pressure[run.time >= 2e3]
    yield at_most("pressure off 40410 Pa after the pulse", np.max(np.abs(late - 40410.0)), 1e-6)


def cycles_alike(run: Trajectory) -> Iterator[Finding]:
    """A cycle of the rod at the end of a long run equals an early one."""
    early, late = run.tip[20 * 900 : 20 * 901 + 1], run.tip[-21:]
    stated = run.accuracy.estimated_tip_error_m or np.nan
    apart = np.hypot(*(late - early)[:, :2].T)
    yield at_most("tip's drift over 1100 cycles", float(np.max(apart)), stated)


def reynolds(run: Trajectory) -> Iterator[Finding]:
    """The number in the warning of turbulent flow."""
    said = [n.message for n in run.warnings if n.code == "turbulent_flow"]
    found = re.search(r"reaches (\S+)", said[0]) if said else None
    yield relative("Reynolds number", float(found[1]) if found else np.nan, 22180, 0.01)


def shifted(run: Trajectory) -> Iterator[Finding]:
    """A gauge pressure shifts pressures and leaves the angle."""
    other = simulate(leg(*GAUGE[1:]))
    yield at_most("angle apart", float(np.max(np.abs(run.tip[:, 2] - other.tip[:, 2]))), 1e-10)
    yield at_most(
        "pressure apart, of 140 kPa",
        float(np.max(np.abs(run.pressure - other.pressure - 140e3))) / 140e3,
        1e-10,
    )


def as_shifted(run: Trajectory) -> Iterator[Finding]:
    """The same for an integrated network, to its tolerance, which measurably is the whole error."""
    other = simulate(leg(ONE_WAY, EXACT, *GAUGE[2:]))
    yield at_most("angle apart", float(np.max(np.abs(run.tip[:, 2] - other.tip[:, 2]))), 1e-6)
    apart = float(np.max(np.abs(run.pressure - other.pressure - 140e3)))
    yield at_most("pressure apart, of 140 kPa", apart / 140e3, SWING)


GAUGE = (
    "gauge_pressure=140 kPa",
    "effects={others: off}",
    AIR,
    "run={duration: 2 s, output_interval: 0.1 s}",
)


def tree(count: int) -> str:
    """Every bellow is connected to the one with half its number."""
    names = [f"{side}{j}" for j in range(1, count // 2 + 1) for side in "RL"]
    return custom(
        "inlet R1 1", *(f"{names[(k - 1) // 2]} {names[k]} 1" for k in range(1, count)), unit=5.0
    )


PULSE_1_MS = "{kind: table, rows: [[0 s, 0], [30 s, 0], [30 s, 1e5], [30.001 s, 1e5], [30.001 s, 0], [60 s, 0]]}"

CASES: tuple[Case, ...] = (
    *(
        Case(
            f"1{letter}",
            f"viscosity {mu:g} Pa s, one-way",
            "the last bellow's pressure, few steps",
            (ONE_WAY, fluid(mu), EXACT, until(8.0, 0.5)),
            lambda run, p=p: [*pressures(run, 0.5, L1=p), at_most("steps", run.cost.steps, 2000)],
        )
        for letter, mu, p in (
            ("a", 2e-11, -30239.307099),
            ("b", 2e-8, -29547.189884),
            ("c", 2e-5, 39768.651320),
            ("d", 1e-3, 40261.520582),
            ("e", 1e3, 40261.520582),
        )
    ),
    Case(
        "1f",
        "viscosity 1 Pa s, one-way",
        "the first bellow's pressure",
        (ONE_WAY, fluid(1.0), EXACT, until(8.0, 2.0)),
        at(2.0, R1=39860.183824),
    ),
    Case(
        "3a",
        "one tube a million times as long",
        "the leakage through it, to 1e-6",
        (ONE_WAY, AIR, EXACT, "network.changes={R2-R3: {length: 37.5 km}}", until(10.0)),
        at(10.0, R1=40409.99984817, R3=40258.17257455, L1=40258.17158767),
    ),
    Case(
        "3b",
        "one tube a millionth as long",
        "as if its ends coincided",
        (ONE_WAY, AIR, EXACT, "network.changes={R2-R3: {length: 37.5 nm}}", until(10.0)),
        lambda run: [
            at_most(
                "pressure across it [Pa]",
                float(np.max(np.abs(np.diff(run.pressure[:, [1, 2]], axis=1)))),
                0.1,
            )
        ],
    ),
    Case(
        "3c",
        "tubes alternately 1 and a millionth as long",
        "complete",
        (
            ONE_WAY,
            AIR,
            custom(
                *(
                    f"{a} {b} {1 if k % 2 else 1e-6}"
                    for k, (a, b) in enumerate(zip(["inlet", *CHAIN], CHAIN, strict=False))
                )
            ),
            until(10.0),
        ),
    ),
    Case(
        "4",
        "an inlet 1e12 times as narrow",
        "no drift but the exact one",
        (ONE_WAY, AIR, EXACT, "network.changes={inlet-R1: {radius: 0.325 um}}", until(10.0)),
        at(10.0, 7e-9, R1=40261.52057907),
    ),
    Case(
        "5a",
        "a sealed chain beside a fed bellow",
        "its pressure stays",
        (
            ONE_WAY,
            AIR,
            custom("inlet R1 1", *LISTED[2:]),
            "gauge_pressure=6250",
            "input={kind: sine, amplitude: 1e4, frequency: 1}",
            until(2.0, 1.0),
        ),
        lambda run: [
            at_most("drift [Pa]", float(np.max(np.abs(run.pressure[:, 1:] - 6250))), 1e-6)
        ],
    ),
    Case(
        "5b",
        "a sealed network, two-way coupled",
        "its volume stays",
        (custom("inlet R1 1", *LISTED[2:]), "run={duration: 2 s, output_interval: 0.05 s}"),
    ),
    Case(
        "6",
        "a junction without volume",
        "flows into it sum to zero",
        (
            "bellows.count=2",
            custom("inlet j 1", "j R1 0.1", "j L1 2"),
            ONE_WAY,
            AIR,
            until(1.0, 0.1, 0.2),
        ),
        junction_flows,
    ),
    Case(
        "7a",
        "a tube without length",
        "refused",
        ("network.tube_length=0 mm",),
        ending="refused",
        says=("network.tube_length", "above 0 m"),
    ),
    Case(
        "7b",
        "a tube from a bellow to itself",
        "refused",
        (custom(*LISTED, "R1 R1 1"),),
        ending="refused",
        says=("R1 to itself",),
    ),
    Case(
        "7c",
        "two equal tubes side by side",
        "equivalent to one of half the length",
        (custom(*LISTED, "R3 R4 1"), ONE_WAY, AIR, EXACT, until(2.0, 0.5, 1.0)),
        as_one_of(
            "network.changes={R3-R4: {length: 18.75 mm}}", ONE_WAY, AIR, EXACT, until(2.0, 0.5, 1.0)
        ),
    ),
    Case(
        "7d",
        "an inlet from which no tube leads",
        "refused",
        (
            "inputs={inlet: {kind: constant, value: 0}, other: {kind: constant, value: 0}}",
            "input=null",
            custom(*LISTED),
        ),
        ending="refused",
        says=("other",),
    ),
    Case("8", "loops", "the matrix exponential's pressures", LOOPS, step_response),
    Case(
        "9a",
        "a step at t = 0",
        "no overshoot; correct initial pressures",
        (ONE_WAY, AIR, STEP, EXACT, until(0.1, 1e-3, start="rest")),
        lambda run: [
            *pressures(run, 1e-3, R1=8671.7196918497),
            *pressures(run, 0.1, R1=81825.180303972, L1=48.889886736441),
        ],
    ),
    Case(
        "9b",
        "a step within the run",
        "the same as a step at the start",
        (ONE_WAY, AIR, "input={kind: step, value: 1e5, time: 1}", EXACT, until(1.1, 1.0, 1.001)),
        lambda run: [
            *pressures(run, 1.001, R1=8671.7196918497),
            *pressures(run, 1.1, R1=81825.180303972, L1=48.889886736441),
        ],
    ),
    Case(
        "9c",
        "a pulse a million times as steep",
        "complete and monotone",
        (
            ONE_WAY,
            AIR,
            "input={kind: double_sigmoid, start: 40.41 kPa, drop: 141.3 kPa, fall_time: 0.5 s, rise_time: 4 s, transition: 6 us}",
            "run={duration: 2 s, output_interval: 0.01 s}",
        ),
        lambda run: [
            at_most(
                "rise while it falls [Pa]",
                float(np.max(np.diff(run.pressure, axis=0), initial=0.0)),
                141.3,
            )
        ],
    ),
    Case(
        "10",
        "a thousand jumps",
        "every half period is resolved",
        (
            ONE_WAY,
            AIR,
            EXACT,
            "input={kind: square, high: 70 kPa, low: -30 kPa, frequency: 100 Hz}",
            until(10.01, 10.0, 10.005, start="rest"),
        ),
        lambda run: [
            *pressures(run, 10.0, R1=9060.076897696, L1=19995.39796608),
            *pressures(run, 10.005, R1=30939.04908953),
        ],
    ),
    *(
        Case(
            f"11{letter}",
            f"{count} bellows",
            "the front's pressures",
            (ONE_WAY, AIR, STEP, EXACT, f"bellows.count={count}", until(1000.0, start="rest")),
            judge,
            converges=count < 1000,
        )
        for letter, count, judge in (
            ("a", 2, at(1000.0, R1=1e5)),
            ("b", 128, lambda run: ()),
            ("c", 1024, at(1000.0, R1=99817.04293794, R512=24079.20432191, L1=3761.960413943)),
        )
    ),
    Case(
        "12a",
        "a thousand slow swings, 1e5 s",
        "no drift, no phase error",
        LONG_SINE,
        long_swing,
        converges=False,
    ),
    Case(
        "12b",
        "the paper's pulse, then 1e5 s of rest",
        "exactly back where it began",
        (ONE_WAY, WATER, EXACT, "run={duration: 1e5 s, output_interval: 100 s}"),
        settled,
        converges=False,
    ),
    Case(
        "12c",
        "2000 swings at 1 Hz that uniform samples would all miss",
        "complete; the last cycle equals an early one",
        (
            ONE_WAY,
            WATER,
            "input={kind: sine, amplitude: 50 kPa, frequency: 1 Hz}",
            "run={duration: 2000 s, output_interval: 0.05 s}",
        ),
        cycles_alike,
        converges=False,
    ),
    Case(
        "13",
        "a run of a nanosecond",
        "the first flow fills the first bellow",
        (ONE_WAY, AIR, STEP, EXACT, until(1e-9, start="rest")),
        lambda run: [relative("p R1", run.pressure[-1, 0], 0.0095087456710893, 1e-6)],
    ),
    Case(
        "14a",
        "inertance, overdamped",
        "complete",
        (
            "effects={fluid_inertance: on, others: off}",
            WATER,
            "run={duration: 2 s, output_interval: 0.1 s}",
        ),
    ),
    Case(
        "14b",
        "inertance, underdamped: tubes of 2 mm",
        "it rings, and energy is conserved",
        (
            "effects={fluid_inertance: on, others: off}",
            "fluid=water",
            "network.tube_radius=2 mm",
            STEP,
            "run={duration: 2 s, output_interval: 2 ms, start: rest}",
        ),
        lambda run: [true("the pressure overshoots", run.pressure.max() > 1.2e5)],
    ),
    Case("15a", "a gauge pressure of 140 kPa", "pressures shift, angles stay", GAUGE, shifted),
    Case(
        "15c",
        "the same with a pressure distribution",
        "pressures shift, angles stay, to the stated error",
        (GAUGE[0], ONE_WAY, EXACT, *GAUGE[2:]),
        as_shifted,
    ),
    Case(
        "15b",
        "the same at rest",
        "exact length and volume, and a warning",
        (
            "gauge_pressure=140 kPa",
            "input={kind: constant, value: 0}",
            "effects={others: off}",
            until(1.0),
        ),
        lambda run: [
            relative("length", run.tip[-1, 1], 0.16748889, 1e-7),
            relative("volume of R1", run.volume[-1, 0], 10.76e-6, 1e-3),
            warned(run, "large_volume"),
        ],
    ),
    Case(
        "18",
        "water at the published amplitude",
        "a warning of turbulence with the Reynolds number",
        (ONE_WAY, "fluid={name: own water, viscosity: 1e-3, density: 1000}"),
        reynolds,
    ),
    Case(
        "35a",
        "the first bellow at its cut-off frequency",
        "3 dB",
        (
            ONE_WAY,
            AIR,
            EXACT,
            "input={kind: sine, amplitude: 1e4, frequency: 3.56679178}",
            "run={duration: 15 s, output_interval: 10 ms}",
        ),
        gain("R1", 3.56679178, 0.5**0.5),
        converges=False,
    ),
    Case(
        "35b",
        "the last bellow at its cut-off frequency",
        "3 dB",
        (
            ONE_WAY,
            AIR,
            EXACT,
            "input={kind: sine, amplitude: 1e4, frequency: 0.13506551}",
            "run={duration: 32 s, output_interval: 50 ms}",
        ),
        gain("L1", 0.13506551, 0.5**0.5),
    ),
    Case(
        "39",
        "a pulse of 1 ms in a run of 60 s",
        "never stepped over",
        (ONE_WAY, AIR, EXACT, f"input={PULSE_1_MS}", until(60.0, 30.001)),
        at(30.001, R1=8671.7196918497),
    ),
    Case(
        "40",
        "few outputs",
        "the same pressures as with many",
        (ONE_WAY, AIR, EXACT, until(4.0, 2.0)),
        as_one_of(ONE_WAY, AIR, EXACT, "run={duration: 4 s, output_interval: 10 ms}"),
    ),
    Case(
        "41",
        "tubes listed in another order",
        "the same pressures",
        (custom(*reversed(LISTED)), ONE_WAY, AIR, EXACT, until(2.0, 1.0)),
        as_one_of(ONE_WAY, AIR, EXACT, until(2.0, 1.0)),
    ),
    Case(
        "42",
        "a tree of 200 bellows",
        "complete",
        (
            "bellows.count=200",
            tree(200),
            "effects=auto",
            "run={duration: 8 s, output_interval: 0.1 s}",
        ),
        converges=False,
    ),
)
