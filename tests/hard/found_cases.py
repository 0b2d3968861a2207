"""Hard cases that random scenes found; see `tests/fuzz`."""

from __future__ import annotations

from tests.hard.case import Case

CASES: tuple[Case, ...] = (
    Case(
        "F1",
        "steps without end, few allowed",
        "fails soon, and says that its work is done",
        (
            "input={kind: sine, amplitude: 20 kPa, frequency: 0.3 Hz}",
            "run={duration: 26000 s, output_interval: 1000 s, start: rest, max_steps: 1000}",
        ),
        ending="failed",
        says=("the limit of 1000 steps was reached", "run.max_steps"),
    ),
    Case(
        "F2",
        "a network beyond double precision, slower than any number tells",
        "refused by the tubes' names",
        (
            "network={layout: straight, tube_radius: 0.3 mm, tube_length: 40 mm, changes: {R1-R2: {radius: 1 um}, inlet-R1: {radius: 100 mm}}}",
        ),
        ending="refused",
        says=("tube R1-R2", "inlet-R1"),
    ),
    Case(
        "F3",
        "a rod that would turn a hundred times around",
        "refused by the turn, not built for minutes",
        ("bellows.angle_per_pressure=9403", "effects.others=auto"),
        ending="refused",
        says=("bellows.angle_per_pressure", "rad"),
    ),
    Case(
        "F4",
        "a sample of the input just before its corner",
        "complete",
        (
            "input={kind: table, rows: [[0, 0], [0.1, 1e4], [0.1000000001, -1e4], [0.2, 0]]}",
            "run={duration: 0.3 s, output_times: [0.09999999999, 0.1, 0.2]}",
            "effects=auto",
            "accuracy=2 %",
        ),
        converges=False,
    ),
    Case(
        "F5",
        "a weight of 80,000 EI/l2, few steps allowed",
        "the way to its equilibrium has a limit, too",
        (
            "loads.gravity={tilt: 5.7}",
            "actuator.density=1e9",
            "bellows.count=4",
            "effects={gravity: on, others: off}",
            "run={duration: 0.5 s, output_interval: 0.1 s, max_steps: 400}",
        ),
        ending="refused",
        says=("the limit of 400 steps was reached", "of the loads", "run.max_steps"),
    ),
)
