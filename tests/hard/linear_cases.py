"""Hard cases of linear networks, against exact solutions of the same equations."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

import numpy as np
import scipy.linalg
from scipy.integrate import solve_ivp

from tests.hard.case import EXACT, Case, Finding, at_most
from tests.hard.network_cases import AIR, CHAIN, ONE_WAY, STEP, custom
from tests.hard.rod_words import STILL, L
from tests.scenes import leg
from tests.validation.rc_network import COMPLIANCE, LENGTH, resistance, step_response
from tests.validation.test_inertance import chain_rates
from tests.validation.test_network import exact_step_response
from viscodesign import Trajectory

AMPLITUDE = 1e4
RESOLVED = 1e-10
"""Amplitude relative to the inlet's down to which pressures have a relative tolerance."""


def chain_matrix(count: int, *, sealed: bool = False) -> np.ndarray:
    """Rates of the paper's chain in air (count, count) [1/s], relative to the inlet's pressure."""
    rates = np.diag(np.full(count - 1, 1.0), 1) + np.diag(np.full(count - 1, 1.0), -1)
    rates -= np.diag(rates.sum(axis=1))
    rates[0, 0] -= 0.0 if sealed else 1.0
    return np.asarray(rates / (resistance(2e-5) * COMPLIANCE))


def in_chain(run: Trajectory, names: list[str] = CHAIN) -> np.ndarray:
    """Pressures (T, B) in the order of the chain."""
    return run.pressure[:, [run.bellows.index(name) for name in names]]


# -- 5c: sealed and nonuniform ---------------------------------------------------------

FORCE = 100.0
ISLAND = CHAIN[1:]
BENDS_VOLUME = LENGTH * 1.2e-6
"""Volume of a bellow per moment of its section [m3/(N m)]."""


def relaxing(run: Trajectory) -> Iterator[Finding]:
    """Fluid that the moments of a force displace from some bellows flows to the others."""
    middle = (np.arange(8) + 0.5) * L / 8
    pressed = BENDS_VOLUME / COMPLIANCE * FORCE * (L - middle)
    begun = {
        f"{side}{k + 1}": sign * pressed[k]
        for side, sign in (("R", 1), ("L", -1))
        for k in range(8)
    }
    start = np.array([begun[name] for name in ISLAND])
    rates = chain_matrix(len(ISLAND), sealed=True)
    exact = np.array([scipy.linalg.expm(rates * t) @ start for t in run.time])
    found = in_chain(run, ISLAND)
    yield at_most(
        "p off, of the first swing", float(np.max(np.abs(found - exact)) / np.ptp(start)), 1e-8
    )
    total = found.sum(axis=1)
    yield at_most("sum of p drifts, of the swing", float(np.ptp(total) / np.ptp(start)), 1e-9)


# -- 14: resistor, inductor, capacitor --------------------------------------------------


def pulse(t: float) -> float:
    """The paper's pulse [Pa]."""
    fall, rise = ((1 + np.tanh(6.857 * (t - centre))) / 2 for centre in (0.5, 1.5))
    return float(40.41e3 - 141.3e3 * (fall - rise))


PULSE = (
    "input={kind: double_sigmoid, start: 40.41 kPa, drop: 141.3 kPa, fall_time: 0.5 s, "
    f"rise_time: 1.5 s, transition: {6 / 6.857!r} s}}"
)


def rung(radius: float, step: bool) -> tuple[tuple[str, ...], np.ndarray]:
    """Spec of a chain of 16 with inertance, and the rates of its pressures and flows."""
    words = (
        "effects={fluid_inertance: on, pressure_distribution: on, others: off}",
        "fluid={name: own, viscosity: 1e-3, density: 1000}",
        f"network.tube_radius={radius!r}",
        STEP if step else PULSE,
        EXACT,
        f"run={{duration: 2 s, output_interval: 0.05 s, start: {'rest' if step else 'equilibrium'}}}",
    )
    return words, chain_rates(radius, len(CHAIN))[0]


def ringing(radius: float, step: bool) -> Case:
    """One such case: after a step by the matrix exponential, in the pulse by Radau at 1e-12."""
    words, rates = rung(radius, step)
    count = len(CHAIN)
    drive = chain_rates(radius, count)[1] / 1e4  # per pascal

    def judge(run: Trajectory) -> Iterator[Finding]:
        if step:
            exact = step_response(rates, drive * 1e5, run.time)[:, :count]
        else:
            start = np.concatenate([np.full(count, pulse(0.0)), np.zeros(count)])
            exact = (
                solve_ivp(
                    lambda t, y: rates @ y + drive * pulse(t),
                    (0.0, 2.0),
                    start,
                    method="Radau",
                    jac=rates,
                    t_eval=run.time,
                    rtol=1e-12,
                    atol=1e-9,
                )
                .y[:count]
                .T
            )
        apart = np.max(np.abs(in_chain(run) - exact)[1:]) / np.ptp(exact)
        yield at_most("p off, of the swing", float(apart), 1e-6)

    kind = "over" if radius < 1e-3 else "under"
    return Case(
        {("over", False): "14c", ("under", False): "14d", ("under", True): "14e"}[kind, step],
        f"inertance, {kind}damped, {'after a step' if step else 'in a smooth pulse'}",
        "the matrix exponential's pressures" if step else "another integrator's, at 1e-12",
        words,
        judge,
    )


# -- 35: all frequencies ----------------------------------------------------------------


def sine_response(frequency: float, times: np.ndarray) -> np.ndarray:
    """Pressures (T, B) of the chain from zero under A sin(w t), by its modes."""
    rates, modes = np.linalg.eigh(chain_matrix(len(CHAIN)))
    drive = modes[0] * AMPLITUDE / (resistance(2e-5) * COMPLIANCE)
    w, t = 2 * np.pi * frequency, times[:, None]
    shape = w * np.exp(rates * t) - rates * np.sin(w * t) - w * np.cos(w * t)
    return np.asarray((drive * shape / (rates**2 + w**2)) @ modes.T)


def heard(frequency: float) -> Case:
    """A case of one frequency, over a little more than two periods from rest."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        found, exact = in_chain(run), sine_response(frequency, run.time)
        apart, size = (np.max(np.abs(a), axis=0) / AMPLITUDE for a in (found - exact, exact))
        yield at_most("p off, of the amplitude", float(np.max(apart)), 1e-6)
        clear = size > RESOLVED
        yield at_most("p off, of its own size", float(np.max((apart / size)[clear])), 1e-4)

    letter = {1e-4: "c", 1e-2: "d", 1.0: "e", 30.0: "f", 1e3: "g"}[frequency]
    return Case(
        f"35{letter}",
        f"all bellows at {frequency:g} Hz",
        "amplitudes down to 1e-10 of the inlet's, each to 1e-4",
        (
            ONE_WAY,
            AIR,
            EXACT,
            f"input={{kind: sine, amplitude: {AMPLITUDE!r}, frequency: {frequency!r}}}",
            f"run={{duration: {2.2 / frequency!r}, output_interval: {0.1 / frequency!r}}}",
        ),
        judge,
    )


# -- 3: contrast ------------------------------------------------------------------------


ALTERNATE = custom(
    *(
        f"{a} {b} {1 if k % 2 else 1e-6}"
        for k, (a, b) in enumerate(zip(["inlet", *CHAIN], CHAIN, strict=False))
    )
)
CONTRAST = (
    ONE_WAY,
    AIR,
    ALTERNATE,
    STEP,
    EXACT,
    "run={duration: 2 s, output_interval: 0.1 s, start: rest}",
)


def as_exponential(run: Trajectory) -> Iterator[Finding]:
    """Against the matrix exponential of the same graph."""
    scene = leg(*CONTRAST)
    exact = exact_step_response(scene, run.time, 1e5)
    names = list(scene.graph.components()[0].bellows)
    apart = np.max(np.abs(in_chain(run, names) - exact)[1:]) / 1e5
    yield at_most("p off, of the step", float(apart), 1e-6)


CASES: tuple[Case, ...] = (
    Case(
        "3d",
        "tubes alternately 1 and a millionth as long, after a step",
        "the matrix exponential's pressures",
        CONTRAST,
        as_exponential,
    ),
    Case(
        "5c",
        "a sealed chain under a force, with nonuniform pressures",
        "they equalise as the matrix exponential says; their sum stays",
        (
            STILL,
            custom("inlet R1 1", *(f"{a} {b} 1" for a, b in itertools.pairwise(ISLAND))),
            AIR,
            "effects={pressure_distribution: on, feedback: on, others: off}",
            # Stiff and unaffected by pressure, so that the moments are those of the straight rod.
            *(f"actuator.{way}_factor=1e6" for way in ("bending", "extension")),
            *(
                f"bellows.{what}=0"
                for what in ("angle_per_pressure", "extension_per_pressure", "area_per_force")
            ),
            f"loads.tip_force.x={FORCE!r}",
            "run={duration: 1 s, start: rest, output_times: [0, 0.001, 0.01, 0.1, 1]}",
            EXACT,
        ),
        relaxing,
        converges=False,
    ),
    ringing(3.25e-4, step=False),
    ringing(2e-3, step=False),
    ringing(2e-3, step=True),
    *(heard(frequency) for frequency in (1e-4, 1e-2, 1.0, 30.0, 1e3)),
    *(
        Case(
            f"11{letter}",
            f"{count} bellows: work",
            "as many steps as for few bellows, linear work per step",
            (
                ONE_WAY,
                AIR,
                STEP,
                EXACT,
                f"bellows.count={count}",
                "run={duration: 10 s, output_times: [0, 10], start: rest}",
            ),
            lambda run, count=count: [
                at_most("steps", run.cost.steps, 1500),
                at_most(
                    "unknowns over bellows",
                    run.settings["states"] + run.settings["algebraic_unknowns"],
                    2 * count + 2,
                ),
            ],
            converges=False,
        )
        for letter, count in (("d", 16), ("e", 128))
    ),
)
