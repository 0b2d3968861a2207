"""Hard cases of the rod: curling, stiffness, release, resonance, coupling, symmetry."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator

import numpy as np

from tests.hard.case import EXACT, Case, Finding, Judge, at_most, relative, true, warned
from tests.hard.rod_words import (
    COUPLED,
    DENSITY,
    EI,
    FINE,
    INEXTENSIBLE,
    PER_PASCAL,
    PULSE,
    SHORT,
    STATIC,
    STILL,
    UNDAMPED,
    L,
    as_stated,
    bent,
    stiffness_ratio,
    tip,
    tip_at,
)
from tests.scenes import chain_order, leg
from tests.validation.rc_network import columns
from tests.validation.test_network import tubes
from viscodesign import Trajectory, simulate


def mirrored(*swapped: str) -> Judge:
    """Swapping the columns, and everything else that has a side, mirrors the motion to round-off."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        yield from _mirror_image(run, 1e-12, *swapped)

    return judge


def nearly_mirrored(run: Trajectory) -> Iterator[Finding]:
    """The same to the stated error: beyond 200 unknowns, systems are solved by Householder QR,
    and CasADi's gives its factor a positive diagonal, for which a mirrored sign is another."""
    yield from _mirror_image(run, 2 * as_stated(run) * L, FINE)


def _mirror_image(run: Trajectory, allowed: float, *swapped: str) -> Iterator[Finding]:
    other = simulate(leg(chain(swapped=True), SHORT, *swapped))
    scale = float(np.max(np.abs(run.tip[:, 0])))
    yield true("it moves sideways", scale > 1e-3)
    for name, column, sign in (("x", 0, 1), ("z", 1, -1)):
        apart = np.max(np.abs(run.tip[:, column] + sign * other.tip[:, column]))
        yield at_most(f"mirrored {name}", float(apart), allowed)
    apart = np.max(np.abs(run.tip[:, 2] + other.tip[:, 2]))
    yield at_most(
        "mirrored phi [rad]", float(apart), allowed if allowed <= 1e-12 else 10 * allowed / L
    )


def chain(*, swapped: bool = False) -> str:
    """The straight chain as a custom graph, down one side and up the other."""
    nodes = ["inlet", *chain_order(8)]
    if swapped:
        nodes[1:] = [node.translate(str.maketrans("RL", "LR")) for node in nodes[1:]]
    return tubes(*(f"{a} {b} 37.5" for a, b in itertools.pairwise(nodes)))


def ten_times_larger(run: Trajectory) -> Iterator[Finding]:
    """The same actuator at another size, with the same dimensionless numbers."""
    scale = 10.0
    other = simulate(
        leg(
            SHORT,
            *(
                f"actuator.{k}={scale * v!r}"
                for k, v in (("length", L), ("height", 0.03), ("width", 0.02))
            ),
            *(
                f"bellows.{k}={scale * v!r}"
                for k, v in (("height", 0.01), ("width", 0.012), ("length", 0.018))
            ),
            f"bellows.area_per_pressure={scale**2 * 3.413e-9!r}",
            f"bellows.extension_per_pressure={scale * 0.047!r}",
            f"bellows.area_per_moment={1.2e-6 / scale!r}",
            f"network.tube_radius={scale * 3.25e-4!r}",
            f"network.tube_length={scale * 0.0375!r}",
            f"actuator.density={950 / scale**2!r}",
        )
    )
    apart = np.max(np.abs(run.tip[:, :2] - other.tip[:, :2] / scale)) / L
    yield at_most("tip apart", float(apart), 1e-9)


def in_other_units(run: Trajectory) -> Iterator[Finding]:
    """The same numbers in other units."""
    other = simulate(
        leg(
            "run={duration: 1000 ms, output_interval: 500 ms}",
            "actuator.length=109 mm",
            "actuator.height=3 cm",
            "actuator.youngs_modulus=1800 kPa",
            "bellows.extension_per_pressure=47 mm",
            "network.tube_radius=325 um",
            "input={kind: double_sigmoid, start: 40410 Pa, drop: 0.1413 MPa, fall_time: 500 ms, "
            "rise_time: 4000 ms, transition: 875 ms}",
        )
    )
    apart = np.max(np.abs(run.tip - other.tip)) / np.max(np.abs(run.tip))
    yield at_most("tip apart", float(apart), 1e-10)


GRAVITIES_100 = "loads.gravity={acceleration: 980.665, tilt: 90 deg}"
FORCED = "loads.tip_force={x: 10 N, z: -5 N}"

CASES: tuple[Case, ...] = (
    Case(
        "22a",
        "curled once around",
        "the tip returns to the clamp",
        (*bent((0, 2 * np.pi), (1, 2 * np.pi)), "effects={others: off}", SHORT),
        lambda run: [*tip(run, 1e-9, x=0.0, z=0.0, phi=2 * np.pi)],
        converges=False,
    ),
    Case(
        "22b",
        "curled ten times around",
        "angles are not wrapped",
        (*bent((0, 20 * np.pi), (1, 20 * np.pi)), "effects={others: off}", SHORT),
        lambda run: [
            *tip(run, 1e-9, x=0.0, z=0.0),
            *tip(run, 1e-6, phi=62.83185307),
            warned(run, "self_contact"),
        ],
        converges=False,
    ),
    Case(
        "22c",
        "curling from once to ten times around",
        "at every full turn the tip is at the clamp",
        (
            *bent((0, 2 * np.pi), (9, 20 * np.pi)),
            "effects={others: off}",
            "run={duration: 9 s, output_interval: 1 s}",
        ),
        lambda run: [
            at_most("tip off, in lengths", float(np.max(np.abs(run.tip[:, :2]))) / L, 1e-9),
            at_most(
                "turns off",
                float(np.max(np.abs(run.tip[:, 2] / (2 * np.pi) - np.arange(1, 11)))),
                1e-9,
            ),
        ],
        converges=False,
    ),
    *(
        Case(
            f"23{letter}",
            f"EA L2/EI = {eta:g} under 5 EI/L2 sideways",
            "no locking",
            (
                STILL,
                STATIC,
                SHORT,
                FINE,
                stiffness_ratio(eta),
                f"loads.tip_force.x={5 * EI / L**2!r}",
            ),
            lambda run, wanted=wanted: tip(run, 1e-4, x=wanted),
            converges=eta not in (10, 1e12),
        )
        for letter, eta, wanted in (
            ("a", 10, 1.091062093014),
            ("b", 100, 0.7495047555127),
            ("c", 1e3, 0.7173357848508),
            ("d", 1e6, 0.7137951),
            ("e", 1e12, 0.7137915236154),
        )
    ),
    Case(
        "25a",
        "100 periods of an undamped rod released under its weight",
        "energy drifts by less than 1e-3",
        (
            STILL,
            UNDAMPED,
            FINE,
            DENSITY,
            "loads.gravity={tilt: 90 deg}",
            "run={duration: 5.2 s, output_interval: 0.02 s, start: rest}",
        ),
        lambda run: [at_most("energy drift", run.invariants.energy_imbalance_rel or np.nan, 1e-3)],
        converges=False,
    ),
    Case(
        "26a",
        "released suddenly under its weight",
        "the vibration about the sag, to 3 digits",
        (
            STILL,
            UNDAMPED,
            FINE,
            DENSITY,
            "loads.gravity={tilt: 90 deg}",
            "run={duration: 0.2 s, output_times: [0, 0.05, 0.1, 0.2], start: rest}",
        ),
        lambda run: [
            f
            for t, x in ((0.05, 3.6619e-5), (0.1, 1.429489e-4), (0.2, 5.282063e-4))
            for f in tip_at(run, t, 2e-6, x=x)
        ],
    ),
    Case(
        "26b",
        "released suddenly under 100 times its weight",
        "a large swing, to 3 digits",
        (
            STILL,
            UNDAMPED,
            FINE,
            DENSITY,
            GRAVITIES_100,
            "run={duration: 0.1 s, output_times: [0, 0.05, 0.1], start: rest}",
        ),
        lambda run: [*tip_at(run, 0.1, 1e-4, x=0.094462, z=0.045535)],
    ),
    Case(
        "27",
        "driven at its first frequency",
        "linear growth, no numerical damping",
        (
            *columns(
                16,
                *(
                    f"{{kind: sine, amplitude: {1e-3 * L / PER_PASCAL / 2!r}, frequency: {120.43299052857 / 2 / np.pi!r}, phase: {phase}}}"
                    for phase in (0.0, np.pi)
                ),
            ),
            UNDAMPED,
            DENSITY,
            INEXTENSIBLE,
            "accuracy=0.001 %",
            "run={duration: 1 s, output_interval: 2 ms}",
        ),
        lambda run: tip_at(run, 1.0, 1.6e-7, x=-1.55049693804e-4),
        converges=False,
    ),
    Case(
        "28a",
        "self-excited: non-reciprocal coefficients, loaded, undamped",
        "the growth is reported",
        (
            STILL,
            COUPLED,
            DENSITY,
            FORCED,
            FINE,
            "fluid={name: thin air, viscosity: 2e-5, density: 1.2}",
            "run={duration: 0.1 s, output_interval: 0.01 s}",
        ),
        lambda run: [*rates(run, 0.1639, 594.65)],
    ),
    Case(
        "28b",
        "the same with damping",
        "nothing grows",
        (
            STILL,
            COUPLED.replace("inertia: on", "inertia: on, damping: on"),
            DENSITY,
            FORCED,
            "run={duration: 0.1 s, output_interval: 0.01 s}",
        ),
        lambda run: [true("no warning 'self_excited'", not warned(run, "self_excited").holds)],
    ),
    Case(
        "29a",
        "negative compliance in bending",
        "refused with its value",
        (COUPLED, "bellows.area_per_moment=9.16e-5"),
        ending="refused",
        says=("area_per_moment", "negative", "compliance"),
    ),
    Case(
        "29b",
        "negative compliance in extension",
        "refused with its value",
        (COUPLED, "bellows.area_per_force=1.557e-6"),
        ending="refused",
        says=("area_per_force", "negative", "compliance"),
    ),
    Case(
        "29c",
        "reciprocal coefficients from the angle",
        "refused with -1.513e-10 m3/Pa",
        (COUPLED, f"bellows.area_per_moment={10.266 / 1.8e6 / 0.018!r}"),
        ending="refused",
        says=("-1.513e-10",),
    ),
    Case(
        "29d",
        "just inside the limit in bending",
        "solved",
        (
            COUPLED.replace("inertia: on", "inertia: on, damping: on"),
            "bellows.area_per_moment=9.0e-5",
            PULSE,
        ),
    ),
    Case(
        "30",
        "a coupling of the wrong sign",
        "a warning",
        (
            COUPLED,
            "bellows.area_per_moment=-1.2e-6",
            "run={duration: 0.5 s, output_interval: 0.05 s}",
        ),
        lambda run: [warned(run, "not_passive")],
    ),
    Case(
        "31",
        "a strong coupling both ways, loaded",
        "solved as one system",
        (
            COUPLED.replace("inertia: on", "inertia: on, damping: on"),
            "bellows.area_per_force=1.2e-6",
            "bellows.area_per_moment=7.2e-5",
            "loads.tip_force={x: 0.2 N, z: 0.5 N}",
            PULSE,
        ),
    ),
    Case(
        "32",
        "a force on sealed bellows",
        "the pressure jumps, and nothing flows",
        (
            STILL,
            "network={layout: custom, tube_length: 40 mm, tube_radius: 0.325 mm, tubes: [{from: inlet, to: R1}, {from: inlet, to: L1}]}",
            "effects={feedback: on, pressure_distribution: on, others: off}",
            "loads.tip_force.z=1",
            SHORT,
            EXACT,
        ),
        lambda run: [
            relative("p L8", run.pressure[-1, run.bellows.index("L8")], -87.899208907, 1e-6)
        ],
    ),
    Case(
        "33",
        "columns swapped",
        "the motion is mirrored to round-off",
        (chain(), SHORT),
        mirrored(),
    ),
    Case(
        "33b",
        "columns swapped, of more than 200 unknowns",
        "the motion is mirrored to the stated error",
        (chain(), SHORT, FINE),
        nearly_mirrored,
        converges=False,
    ),
    Case(
        "33c",
        "columns swapped, gravity from the other side",
        "the motion is mirrored to round-off",
        (chain(), SHORT, "loads.gravity={tilt: 30 deg}"),
        mirrored("loads.gravity={tilt: -30 deg}"),
    ),
    Case("34", "ten times the size", "the same relative to its length", (SHORT,), ten_times_larger),
    Case(
        "34b",
        "written in mm, kPa and ms",
        "the same to round-off",
        (SHORT,),
        in_other_units,
    ),
    Case(
        "36",
        "a tip force against gravity",
        "the loads cancel",
        (
            STILL,
            STATIC,
            SHORT,
            "loads.gravity={tilt: 180 deg}",
            "loads.tip_force={x: 0.01 N, z: 0.3 N}",
        ),
    ),
)


def rates(run: Trajectory, growth: float, frequency: float) -> Iterator[Finding]:
    """Growth rate and frequency in the warning of a self-excited start."""
    said = [n.message for n in run.warnings if n.code == "self_excited"]
    numbers = re.search(r"at (\S+) 1/s and (\S+) rad/s", said[0]) if said else None
    found = [float(n) for n in numbers.groups()] if numbers else [np.nan, np.nan]
    yield relative("growth", found[0], growth, 0.01)
    yield relative("frequency", found[1], frequency, 0.01)
