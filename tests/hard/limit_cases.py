"""Hard cases of widely separated timescales: each limit is approached smoothly."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tests.hard.case import EXACT, Case, Finding, Judge, at_most
from tests.hard.network_cases import CHAIN, custom, fluid
from tests.hard.rod_words import FINE, PULSE, L, same_without
from tests.scenes import leg
from viscodesign import Trajectory, simulate


def grows(
    limit: tuple[str, ...], words: Callable[[float], tuple[str, ...]], *others: float
) -> Judge:
    """The distance to a limit is proportional to the parameter that leads there.

    ``limit``: what differs there; ``words``: what makes a run so far from it, and ``others``:
    how far runs are beside the case's own, which stands at 1.
    """

    def judge(run: Trajectory) -> Iterator[Finding]:
        end = simulate(leg(*limit))
        near = [(1.0, run), *((far, simulate(leg(*words(far)))) for far in others)]
        apart = [float(np.max(np.hypot(*(r.tip[:, :2] - end.tip[:, :2]).T))) for _, r in near]
        for (far, _), distance in zip(near[1:], apart[1:], strict=True):
            power = np.log(distance / apart[0]) / np.log(far)
            yield Finding(f"power of the distance at {far:g}", float(power), 1.0, 0.05)

    return judge


THIN = fluid(2e-5)
TWO_SECONDS = "run={duration: 2 s, output_interval: 0.05 s}"
ONE_WAY = "effects={pressure_distribution: on, others: off}"


def massive(factor: float) -> tuple[str, ...]:
    """An undamped rod of some times the paper's mass under the pulse of thin air."""
    effects = "effects={pressure_distribution: on, inertia: on, others: off}"
    return effects, THIN, TWO_SECONDS, FINE, f"actuator.density={950 * factor!r}"


def thin(factor: float) -> tuple[str, ...]:
    """A fluid so thin that the network is nearly uniform."""
    return ONE_WAY, fluid(1e-7 * factor), TWO_SECONDS, EXACT


def thick(factor: float) -> tuple[str, ...]:
    """A fluid so thick that hardly anything flows."""
    return ONE_WAY, fluid(1e5 / factor), TWO_SECONDS, EXACT


def alternate(factor: float) -> str:
    """Every second tube longer than the others by this factor."""
    ends = zip(["inlet", *CHAIN], CHAIN, strict=False)
    return custom(*(f"{a} {b} {1 if k % 2 else factor}" for k, (a, b) in enumerate(ends)))


CASES: tuple[Case, ...] = (
    Case(
        "24a",
        "a rod without mass, inertia on",
        "as without inertia",
        (
            "actuator.density=1e-9",
            "effects={inertia: on, damping: on, pressure_distribution: on, others: off}",
            PULSE,
        ),
        same_without("effects={pressure_distribution: on, damping: on, others: off}", PULSE),
    ),
    Case(
        "24b",
        "a thousand times the mass",
        "complete",
        (
            "actuator.density=9.5e5",
            "effects={inertia: on, damping: on, pressure_distribution: on, feedback: on, others: off}",
            PULSE,
        ),
    ),
    Case(
        "2a",
        "1e12 times the mass",
        "the rod does not move during the pulse",
        (
            "actuator.density=9.5e14",
            "effects={inertia: on, damping: on, pressure_distribution: on, others: off}",
            PULSE,
        ),
        lambda run: [
            at_most("sideways, in lengths", float(np.max(np.abs(run.tip[:, 0]))) / L, 1e-6)
        ],
    ),
    *(
        Case(
            f"37{letter}",
            f"viscosity {mu} Pa s, two-way coupled",
            "complete",
            (f"fluid={{name: own, viscosity: {mu}, density: 1.2}}", PULSE),
            judge,
        )
        for letter, mu, judge in (
            (
                "a",
                "1e-12",
                same_without(
                    "fluid={name: own, viscosity: 1e-12, density: 1.2}",
                    "effects={feedback: on, inertia: on, damping: on, others: off}",
                    PULSE,
                ),
            ),
            ("b", "1e-9", lambda run: ()),
            ("c", "1e-6", lambda run: ()),
            ("d", "1e-3", lambda run: ()),
            ("f", "1", lambda run: ()),
            (
                "e",
                "1e6",
                lambda run: [
                    at_most("sideways, in lengths", float(np.ptp(run.tip[:, 0])) / L, 1e-4)
                ],
            ),
        )
    ),
    *(
        Case(
            f"38{letter}",
            f"one tube {factor:g} times as long, coupled",
            "complete",
            (f"network.changes={{R3-R4: {{length: {0.0375 * factor!r}}}}}", PULSE),
        )
        for letter, factor in (("a", 1e6), ("b", 1e-6))
    ),
    Case(
        "2b",
        "the paper's mass, a sixteenth and a 256th of it, undamped",
        "the distance to a rod without mass is O(m), hence O(tau2)",
        massive(1.0),
        grows((ONE_WAY, THIN, TWO_SECONDS, FINE), massive, 1 / 16, 1 / 256),
        converges=False,
    ),
    Case(
        "2c",
        "viscosity 1e-7 Pa s and less",
        "the distance to one pressure is O(mu)",
        thin(1.0),
        grows(("effects={others: off}", TWO_SECONDS, EXACT), thin, 0.1, 0.01),
    ),
    Case(
        "2d",
        "viscosity 1e5 Pa s and more",
        "the distance to sealed bellows is O(1/mu)",
        thick(1.0),
        grows((ONE_WAY, fluid(1e10), TWO_SECONDS, EXACT), thick, 0.1, 0.01),
    ),
    *(
        Case(
            f"38{letter}",
            f"every second tube {factor:g} times as long, coupled",
            "complete",
            (alternate(factor), PULSE),
        )
        for letter, factor in (("c", 1e6), ("d", 1e-6))
    ),
)
