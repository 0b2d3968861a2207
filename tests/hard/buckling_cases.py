"""Hard cases of columns: buckling, postbuckling, and snap-through."""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from tests.hard.case import EXACT, Case, Finding, Judge, true
from tests.hard.rod_words import (
    CRITICAL,
    FINE,
    IN_MOTION,
    INEXTENSIBLE,
    STATIC,
    L,
    as_stated,
    bent,
    compressed,
    stiffness_ratio,
    tip,
)
from tests.validation import elastica
from tests.validation.rc_network import COMPLIANCE, columns, resistance
from viscodesign import Trajectory

ETA = 152.65
"""EA L2/EI of the paper's leg, to five digits."""


def fold(run: Trajectory, first: float, speed: float, wanted: float) -> Iterator[Finding]:
    """Curvature at which the branch is reported to end."""
    said = re.search(r"after t = ([\d.]+) s", run.failure or "")
    found = first + speed * float(said[1]) if said else np.nan
    yield Finding("kappa0 L at the fold", found, wanted, 1e-4)


def as_column(load: float, eta: float = np.inf) -> Judge:
    """The tip is that of the boundary-value problem; ``load`` in Euler's loads."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        end = elastica.column(load * elastica.EULER, ASIDE, eta)
        yield from tip(run, 1e-4, x=end.x, z=end.z, phi=end.phi)

    return judge


def late_fold(run: Trajectory) -> Iterator[Finding]:
    """The fluid lags behind its ramp: kappa0 L = 0.5 - t + RC (1 - exp(-t/RC)) at the fold."""
    said = re.search(r"after t = ([\d.]+) s", run.failure or "")
    t, lag = float(said[1]) if said else np.nan, resistance(1e-3) * COMPLIANCE
    found = 0.5 - t + lag * (1 - np.exp(-t / lag))
    yield Finding("kappa0 L at the fold", found, -0.403760611117087, 1e-4)


STEADY = 0.98
"""A load below Euler's, in Euler's loads."""
LENGTHENING = "{kind: table, rows: [[0 s, 0], [2 s, 20 kPa]]}"
PER_STRETCH = 1.8e6 / (0.047 * 16 / L)
"""Pressure in all bellows per stretch of the column [Pa]."""


def too_long(run: Trajectory) -> Iterator[Finding]:
    """It buckles where P (1 + zeta - P/EA) = pi2/4 EI/L2."""
    said = re.search(r"after t = ([\d.]+) s", run.failure or "")
    t, lag = float(said[1]) if said else np.nan, resistance(1e-3) * COMPLIANCE
    pressure = 1e4 * (t - lag * (1 - np.exp(-t / lag)))
    stretch = 1 + pressure / PER_STRETCH - STEADY * elastica.EULER / ETA
    yield Finding("load over the critical one", STEADY * stretch, 1.0, 1e-3)


ASIDE = 1e-3
"""Imperfection: a lateral force [EI/L2]."""
SLOPES = (20, 40, 60, 80, 100, 120)
"""End slopes of the perfect elastica [deg]."""
BUCKLED = [elastica.buckled(np.radians(slope))[0] / elastica.EULER for slope in SLOPES]
"""Loads at which it has them [Euler's loads]: 1.015 to 1.885."""
SNAPPING = (
    *bent((0, 0.5), (3, -2.5)),
    f"loads.tip_force.z={-1.5 * CRITICAL!r}",
    INEXTENSIBLE,
    "fluid={name: own, viscosity: 1e-3, density: 1.2}",
)
BESIDE_A_FLUID = "effects={gravity: auto, pressure_distribution: on, others: off}"

CASES: tuple[Case, ...] = (
    Case(
        "19a",
        "1.1 times Euler's load, slightly imperfect",
        "the stable, bent branch",
        (*compressed(1.1), INEXTENSIBLE, FINE),
        lambda run: tip(run, 1e-4, x=0.509533799298, phi=0.866452363899),
    ),
    Case(
        "19b",
        "8.9 times Euler's load",
        "the tip turns by 176 degrees",
        (*compressed(8.9), INEXTENSIBLE, FINE),
        lambda run: tip(run, 1e-4, phi=3.0676611267),
    ),
    Case(
        "19c",
        "a perfect column above Euler's load",
        "no stable equilibrium nearby",
        (*compressed(1.1, 0.0), INEXTENSIBLE),
        ending="refused",
        says=("no stable equilibrium", "% of the loads"),
    ),
    Case(
        "20",
        "the paper's column just above Euler's load",
        "extension keeps it straight",
        compressed(1.015, 0.0),
        lambda run: tip(run, 1e-12, x=0.0, phi=0.0),
    ),
    Case(
        "21a",
        "snap-through at 1.5 times Euler's load, without inertia",
        "the fold is reported, to 1e-4",
        (
            *bent((0, 0.5), (1, -0.5)),
            f"loads.tip_force.z={-1.5 * CRITICAL!r}",
            INEXTENSIBLE,
            STATIC,
            EXACT,
            "run={duration: 1 s, output_interval: 0.02 s}",
        ),
        lambda run: fold(run, 0.5, -1.0, -0.403760611117087),
        ending="failed",
        says=("no stable equilibrium", "snap", "effects.inertia"),
    ),
    Case(
        "21b",
        "the same at twice Euler's load",
        "the fold is reported, to 1e-4",
        (
            *bent((0, 0.5), (1, -1.5)),
            f"loads.tip_force.z={-2.0 * CRITICAL!r}",
            INEXTENSIBLE,
            STATIC,
            EXACT,
            "run={duration: 1 s, output_interval: 0.02 s}",
        ),
        lambda run: fold(run, 0.5, -2.0, -1.01455729445420),
        ending="failed",
        says=("snap",),
    ),
    Case(
        "21c",
        "the snap itself",
        "with inertia, the run follows it to the mirrored shape",
        (
            *bent((0, 2), (4, -2)),
            f"loads.tip_force.z={-1.5 * CRITICAL!r}",
            IN_MOTION,
            "run={duration: 8 s, output_interval: 0.05 s}",
        ),
        lambda run: [*tip(run, 2 * as_stated(run), x=-run.tip[0, 0] / L, z=run.tip[0, 1] / L)],
    ),
    *(
        Case(
            f"19{letter}",
            f"{load:.4g} times Euler's load: {slope} degrees at the tip",
            "the elastica, including the imperfection",
            (*compressed(load, ASIDE), INEXTENSIBLE, FINE),
            as_column(load),
        )
        for letter, slope, load in zip("defghi", SLOPES, BUCKLED, strict=True)
    ),
    *(
        Case(
            f"20{letter}",
            f"{load:.4g} times its own critical load, extensible",
            "the extensible elastica",
            (
                *compressed(load * elastica.critical(ETA) / elastica.EULER, ASIDE),
                stiffness_ratio(ETA),
                FINE,
            ),
            as_column(load * elastica.critical(ETA) / elastica.EULER, ETA),
        )
        for letter, load in zip("bcd", (BUCKLED[0], BUCKLED[2], BUCKLED[5]), strict=True)
    ),
    Case(
        "21d",
        "the snap at 1.5 times Euler's load with lagging fluid, without inertia",
        "the fold is reported, to 1e-4, for any output interval",
        (*SNAPPING, BESIDE_A_FLUID, FINE, "run={duration: 3 s, output_interval: 0.25 s}"),
        late_fold,
        ending="failed",
        says=("no stable equilibrium", "snap", "effects.inertia"),
    ),
    Case(
        "21e",
        "a slow snap, where inertia may help",
        "the run is repeated with inertia, and snaps",
        (
            *bent((0, 0.5), (60, -2.5)),
            *SNAPPING[-3:],
            "effects={gravity: auto, pressure_distribution: on, inertia: auto, damping: auto, others: off}",
            "run={duration: 60 s, output_interval: 0.5 s}",
        ),
        lambda run: [
            true("it snaps", bool(run.tip[0, 0] > 0.5 * L and run.tip[-1, 0] < -0.5 * L)),
            true("it was done again in motion", bool(run.ladder and run.ladder[0].solved)),
        ],
        converges=False,
    ),
    Case(
        "21f",
        "a perfect column, lengthened by its fluid to its critical load, without inertia",
        "it does not stay straight",
        (
            *columns(16, LENGTHENING, LENGTHENING),
            BESIDE_A_FLUID,
            stiffness_ratio(ETA),
            f"loads.tip_force.z={-STEADY * CRITICAL!r}",
            "fluid={name: own, viscosity: 1e-3, density: 1.2}",
            "run={duration: 2 s, output_interval: 0.1 s}",
        ),
        too_long,
        ending="failed",
        says=("no stable equilibrium", "effects.inertia"),
    ),
)
