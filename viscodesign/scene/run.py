"""`run:` how long, what to write down, and how it starts."""

from __future__ import annotations

import itertools
from typing import Any, Literal

import numpy as np
from pydantic import Field, model_validator

from viscodesign.scene.section import Part, refuse_at
from viscodesign.units import Time

MOST_OUTPUTS = 10_000_000
MOST_LISTED = 1_000_000
MOST_SHAPES = 20_000
"""Whole shapes after the first that are written down if the spec does not say how many."""
USUAL_INTERVAL = 0.02
"""[s]"""


def _usual_interval(given: dict[str, Any]) -> float:
    return min(USUAL_INTERVAL, float(given["duration"]))


class Run(Part):
    """Duration, output times and start of a simulation."""

    duration: Time = Field(gt=0, description="Simulated time")
    output_interval: Time = Field(
        default_factory=_usual_interval,
        gt=0,
        description="Time between two outputs; 20 ms if not given, or the duration if shorter",
    )
    output_times: tuple[Time, ...] | None = Field(
        None, description="Instead of an interval: the output times, ascending"
    )
    max_steps: int = Field(
        1_000_000,
        ge=100,
        description="Steps after which a run is given up, those of its verification included",
    )
    shape_every: int | None = Field(
        None,
        ge=1,
        description="Outputs from one whole shape in shape.csv to the next; if not given 1, or "
        f"what makes at most {MOST_SHAPES} of them",
    )
    start: Literal["equilibrium", "rest"] = Field(
        "equilibrium",
        description="equilibrium under the first pressures and loads, or straight and at rest",
    )

    @model_validator(mode="after")
    def _times_fit(self) -> Run:
        if self.output_times is not None:
            self._check_times(self.output_times)
        elif self.output_interval > self.duration:
            raise refuse_at(
                "output_interval",
                f"{self.output_interval:g} s is longer than the duration of {self.duration:g} s",
            )
        elif self.duration / self.output_interval > MOST_OUTPUTS:
            raise refuse_at(
                "output_interval",
                f"{self.duration / self.output_interval:.3g} outputs; at most {MOST_OUTPUTS} are "
                f"allowed. Use an interval of {self.duration / MOST_OUTPUTS:.3g} s or more",
            )
        return self

    def _check_times(self, times: tuple[float, ...]) -> None:
        if not times:
            raise refuse_at("output_times", "the list is empty; at least one time is needed")
        if len(times) > MOST_LISTED:
            raise refuse_at(
                "output_times",
                f"{len(times)} times; at most {MOST_LISTED}. Use output_interval for more",
            )
        for k, (before, after) in enumerate(itertools.pairwise(times)):
            if after <= before:
                raise refuse_at(
                    "output_times",
                    f"time {k + 2} ({after:g} s) does not follow {before:g} s; times must ascend",
                )
        if times[0] < 0 or times[-1] > self.duration:
            raise refuse_at(
                "output_times",
                f"{times[0]:g} s to {times[-1]:g} s; allowed are times from 0 to the duration of "
                f"{self.duration:g} s",
            )

    @property
    def outputs(self) -> int:
        """How many output times there are, or one more."""
        if self.output_times is not None:
            return len(self.output_times)
        return int(self.duration / self.output_interval * (1 + 1e-12)) + 1

    @property
    def shapes_apart(self) -> int:
        """Outputs from one whole shape to the next."""
        return self.shape_every or max(1, -(-(self.outputs - 1) // MOST_SHAPES))

    def output_times_array(self) -> np.ndarray:
        """Output times (T,) [s]; by interval they start at 0 and end at the duration."""
        if self.output_times is not None:
            return np.array(self.output_times)
        count = int(self.duration / self.output_interval * (1 + 1e-12))
        times = self.output_interval * np.arange(count + 1)
        if self.duration - times[-1] > 1e-9 * self.output_interval:
            times = np.append(times, self.duration)
        times[-1] = self.duration
        return times
