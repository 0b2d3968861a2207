"""How wrong are fitted numbers where the model is? Recordings of scenes that the spec is not.

    PYTHONPATH=. python benchmarks/mismatch_trials.py     # half a minute; rewrites its report

Each trial solves a scene that differs from the spec in a length, or has effects that the spec turns
off, adds noise, and fits the spec to that. The limits in `calibration/description.py` are chosen
by what comes of it.
"""

from __future__ import annotations

import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from tests.recordings import columns_of, small_scene, written
from viscodesign import fit
from viscodesign.calibration.description import DESCRIBED_UP_TO
from viscodesign.results.fit_result import Fit, FittedNumber
from viscodesign.scene.scene import Scene

REPORT = Path(__file__).parent / "results" / "mismatch_trials.md"
TRUTH = {
    "bellows.area_per_pressure": 4.0e-9,
    "bellows.angle_per_pressure": 9.3,
    "bellows.extension_per_pressure": 0.0515,
    "fluid.viscosity": 8.5e-5,
}
LENGTHS = (1.0, 1.01, 1.015, 1.02, 1.025, 1.03, 1.04, 1.05, 1.07)
"""Of the actuator, over that of the spec."""
BULK_MODULI = (3e8, 1e8, 3e7)
"""[Pa]"""
PAYLOADS = (0.02, 0.05, 0.1, 0.3)
"""[kg]"""


def main() -> None:
    """Run all trials, and write the report."""
    text = "\n".join([*HEAD, *rows(small_scene()), ""])
    REPORT.write_text(text, encoding="utf-8")
    print(text)


HEAD = (
    "# How wrong are fitted numbers where the model is?",
    "",
    "Recordings of a leg of four bellows (`tests/recordings.py`) that differs from the spec, "
    "fitted by four numbers. Error: the largest of the four, as found over true, and the half"
    " width of that number's interval; misses: intervals that do not hold the truth, of which"
    " 5 % are chance; mean square: of what is left of the worst group of channels, over that "
    f"of its noise, told from {DESCRIBED_UP_TO:g} on. Made by `benchmarks/mismatch_trials.py`.",
    "",
    "| what the spec has not | mean square | status | largest error | half width | misses |",
    "| --- | --- | --- | --- | --- | --- |",
)


def trials(spec: Scene) -> Iterator[tuple[str, Mapping[str, Any]]]:
    """What differs, in words, and as changes of the spec."""
    for ratio in LENGTHS:
        yield (
            f"length {100 * (ratio - 1):.3g} % more",
            {"actuator.length": spec.actuator.length * ratio},
        )
    every = {"effects.others": "auto"}
    for modulus in BULK_MODULI:
        words = f"all effects, bulk modulus {modulus / 1e6:g} MPa"
        yield words, {**every, "fluid.bulk_modulus": modulus}
    for payload in PAYLOADS:
        load = {"loads.payload": payload, "loads.gravity.acceleration": 9.81}
        yield f"all effects, payload {1e3 * payload:g} g", {**every, **load}


def rows(spec: Scene) -> Iterator[str]:
    """A row of the table for each trial."""
    with tempfile.TemporaryDirectory() as folder:
        for seed, (words, changes) in enumerate(trials(spec)):
            columns = columns_of(spec.replace(changes), TRUTH, seed=seed)
            found = fit(spec, written(columns, Path(folder) / "data.csv"), next_experiment=False)
            yield _row(words, found)


def _row(words: str, found: Fit) -> str:
    worst = max(found.numbers, key=_error)
    half = worst.half_width
    squares = f"{found.mismatch.mean_square:.3g}" if found.mismatch else "-"
    width = "open" if half is None else f"{100 * half:.2g} %"
    misses = sum(not _holds(own) for own in found.numbers)
    error = 100 * _error(worst)
    return f"| {words} | {squares} | {found.status} | {error:.3g} % | {width} | {misses} |"


def _error(number: FittedNumber) -> float:
    """Of a number, relative to the true one."""
    return abs(number.value / TRUTH[number.key] - 1)


def _holds(number: FittedNumber) -> bool:
    truth = TRUTH[number.key]
    above = number.low is None or number.low <= truth
    return above and (number.high is None or truth <= number.high)


if __name__ == "__main__":
    main()
