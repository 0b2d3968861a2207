"""Metamorphic tests: a second run of an equivalent scene must agree with the first."""

from __future__ import annotations

import copy
import itertools
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

import numpy as np

from tests.fuzz.invariants import Verdict, check_scene
from tests.fuzz.scenes import Draft
from viscodesign import Trajectory
from viscodesign.model.graph import crossed_order, straight_order

Spec = dict[str, Any]
ROUND_OFF = 1e-9
"""Fraction of the length, added to the stated errors of two compared runs."""
ENDS_APART = "the twin ends otherwise"


@dataclass(frozen=True)
class Pair:
    """Two runs at their common output times."""

    one: Trajectory
    other: Trajectory

    @property
    def both(self) -> tuple[np.ndarray, np.ndarray]:
        """Rows of both runs at the same times."""
        near = [int(np.argmin(np.abs(self.one.time - t))) for t in self.other.time]
        rows = [
            (k, j)
            for j, k in enumerate(near)
            if abs(self.one.time[k] - self.other.time[j]) <= 1e-12 * self.one.time[-1]
        ]
        return np.array([k for k, _ in rows], int), np.array([j for _, j in rows], int)

    def distance(self, sign: float = 1.0) -> float:
        """Largest distance of the tips [m]; ``sign`` -1 mirrors one of them."""
        k, j = self.both
        if not len(k):
            return 0.0
        x = self.one.tip[k, 0] - sign * self.other.tip[j, 0]
        z = self.one.tip[k, 1] - self.other.tip[j, 1]
        return float(np.hypot(x, z).max())

    @property
    def stated(self) -> float:
        """Sum of the stated errors of both runs [m]."""
        errors = (r.accuracy.estimated_tip_error_m or 0.0 for r in (self.one, self.other))
        return sum(errors) + ROUND_OFF * self.one.length


Twin = Callable[[Random, Spec], Spec | None]
"""Makes an equivalent spec from a copy of the first one; None if there is none."""


def mirrored(rng: Random, spec: Spec) -> Spec:
    """Swap the columns and mirror all loads."""
    swap = str.maketrans("RL", "LR")
    sections, network = spec["bellows"]["count"] // 2, spec["network"]
    if network["layout"] != "custom":
        order = straight_order if network["layout"] == "straight" else crossed_order
        nodes = ["inlet", *order(sections)]
        own = network.pop("changes", {})
        network["tubes"] = [
            {"from": a, "to": b, **own.get(f"{a}-{b}", {})} for a, b in itertools.pairwise(nodes)
        ]
        network["layout"] = "custom"
    for tube in network["tubes"]:
        for end in ("from", "to"):
            tube[end] = tube[end].translate(swap)
    loads = spec["loads"]
    if loads["gravity"] != "off":
        loads["gravity"]["tilt"] *= -1
    if "tip_force" in loads:
        loads["tip_force"]["x"] *= -1
    return spec


def other_output_times(rng: Random, spec: Spec) -> Spec:
    """Keep some of the output times and add others."""
    run = spec["run"]
    duration = run["duration"]
    if "output_times" in run:
        times = [*run["output_times"], duration * rng.random()]
    else:
        count = round(duration / run["output_interval"])
        kept = [rng.randint(0, count) * run["output_interval"] for _ in range(3)]
        times = [*kept, duration * rng.random(), duration]
    del run["output_times" if "output_times" in run else "output_interval"]
    run["output_times"] = sorted({min(t, duration) for t in times})
    return spec


def reordered_tubes(rng: Random, spec: Spec) -> Spec | None:
    """Reorder the tubes and swap their ends."""
    if spec["network"]["layout"] != "custom":
        return None
    tubes = spec["network"]["tubes"]
    for tube in tubes:
        if rng.random() < 0.5:
            tube["from"], tube["to"] = tube["to"], tube["from"]
    rng.shuffle(tubes)
    return spec


def finer(rng: Random, spec: Spec) -> Spec:
    """A tenth of the accuracy."""
    spec["accuracy"] /= 10
    spec["run"]["max_steps"] *= 4
    return spec


TWINS: dict[str, Twin] = {
    "mirror": mirrored,
    "times": other_output_times,
    "order": reordered_tubes,
    "finer": finer,
}


def compared(name: str, rng: Random, draft: Draft, first: Verdict) -> Verdict:
    """The first verdict with the differences to the second run."""
    spec = TWINS[name](rng, copy.deepcopy(draft.spec))
    if spec is None or first.problems:
        return first
    with tempfile.TemporaryDirectory() as folder:
        second = check_scene(replace(draft, spec=spec), Path(folder))
    found = tuple(f"{name}: {c}" for c in [*second.problems, *_differences(name, first, second)])
    numbers = {**first.numbers, f"{name} compared": 1.0}
    if name == "finer" and _both_complete(first, second):
        numbers["error over stated"] = _error_over_stated(first, second)
    return replace(first, problems=found, numbers=numbers)


def _both_complete(first: Verdict, second: Verdict) -> bool:
    return first.ending == second.ending == "complete"


def _differences(name: str, first: Verdict, second: Verdict) -> Iterator[str]:
    if not _both_complete(first, second):
        same = first.ending.partition(":")[0] == second.ending.partition(":")[0]
        # Other times or an order of its own may take a few steps more than are allowed.
        is_out_of_work = any("the limit of" in v.ending for v in (first, second))
        if not same and not is_out_of_work and name != "finer":
            yield f"{ENDS_APART}, {second.ending}, and not {first.ending}"
        return
    if first.run is None or second.run is None:
        return
    pair = Pair(first.run, second.run)
    distance = pair.distance(-1.0 if name == "mirror" else 1.0)
    allowed = pair.stated
    if name == "finer":
        # The estimate may be off by a little; the accuracy asked for has to be kept.
        allowed += first.run.accuracy.requested_m - (
            first.run.accuracy.estimated_tip_error_m or 0.0
        )
    if distance > allowed:
        length = first.run.length
        yield f"tip distance {distance / length:.3g} lengths, {allowed / length:.3g} allowed"


def _error_over_stated(first: Verdict, second: Verdict) -> float:
    assert first.run is not None
    assert second.run is not None
    stated = first.run.accuracy.estimated_tip_error_m or 1.0
    return Pair(first.run, second.run).distance() / stated
