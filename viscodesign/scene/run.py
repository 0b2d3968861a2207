"""`run:` duration, outputs and initial state."""

from __future__ import annotations

import itertools
from typing import Any, Literal

import numpy as np
from pydantic import Field, model_validator

from viscodesign.scene.integer import Integer
from viscodesign.scene.spec_part import SpecPart, invalid_at
from viscodesign.units import Time

MAX_OUTPUTS = 10_000_000
MAX_OUTPUT_TIMES = 1_000_000
MAX_SHAPES = 20_000
"""Shapes after the first that are written unless `shape_every` is given."""
OUTPUT_KEYS = ("output_interval", "output_times")
"""Keys that are mutually exclusive."""
TIME_SPACING_REL_MIN = 1e-11
"""Smallest spacing of output times relative to the duration: closer ones are one row of a table."""
DEFAULT_OUTPUT_INTERVAL = 0.02
"""[s]"""


def _default_interval(given: dict[str, Any]) -> float:
    return min(DEFAULT_OUTPUT_INTERVAL, float(given["duration"]))


class RunSettings(SpecPart):
    """Duration, output times and initial state of a simulation."""

    duration: Time = Field(gt=0, description="Simulated time")
    output_interval: Time = Field(
        default_factory=_default_interval,
        gt=0,
        description="Time between outputs; default: 20 ms, or the duration if shorter",
    )
    output_times: tuple[Time, ...] | None = Field(
        None, description="Instead of an interval: increasing output times"
    )
    max_steps: Integer = Field(
        1_000_000,
        ge=100,
        description="Maximum number of time steps of a run, including its verification",
    )
    shape_every: Integer | None = Field(
        None,
        ge=1,
        description="Write every n-th output to shape.csv; default: 1, or "
        f"more for at most {MAX_SHAPES} shapes",
    )
    start: Literal["equilibrium", "rest", "periodic"] = Field(
        "equilibrium",
        description="equilibrium under the initial pressures and loads, straight and at rest, or "
        "on the limit cycle of periodic inputs",
    )

    @model_validator(mode="before")
    @classmethod
    def _one_choice_of_outputs(cls, given: Any) -> Any:
        """Either an interval or times; a key without a value is not given."""
        if not isinstance(given, dict):
            return given
        keys = [key for key in OUTPUT_KEYS if given.get(key) is not None]
        if len(keys) == len(OUTPUT_KEYS):
            raise invalid_at(
                "output_times",
                "given together with output_interval; they are mutually exclusive, remove one",
            )
        return {key: value for key, value in given.items() if key in keys or key not in OUTPUT_KEYS}

    @model_validator(mode="after")
    def _check_outputs(self) -> RunSettings:
        if self.output_times is not None:
            self._check_times(self.output_times)
        elif self.output_interval > self.duration:
            raise invalid_at(
                "output_interval",
                f"must be at most the duration {self.duration:g} s; got {self.output_interval:g} s",
            )
        elif self.duration / self.output_interval > MAX_OUTPUTS:
            raise invalid_at(
                "output_interval",
                f"{self.duration / self.output_interval:.3g} outputs; at most {MAX_OUTPUTS} are "
                f"allowed. Use an interval of {self.duration / MAX_OUTPUTS:.3g} s or more",
            )
        return self

    def _check_times(self, times: tuple[float, ...]) -> None:
        if not times:
            raise invalid_at("output_times", "the list is empty; give at least one time")
        if len(times) > MAX_OUTPUT_TIMES:
            raise invalid_at(
                "output_times",
                f"{len(times)} times; at most {MAX_OUTPUT_TIMES} are allowed. Use output_interval",
            )
        for k, (before, after) in enumerate(itertools.pairwise(times)):
            if after <= before:
                raise invalid_at(
                    "output_times",
                    f"times must increase; time {k + 2} is {after:g} s after {before:g} s",
                )
        least = TIME_SPACING_REL_MIN * self.duration
        for k, (before, after) in enumerate(itertools.pairwise(times)):
            if after - before < least:
                raise invalid_at(
                    "output_times",
                    f"times {k + 1} and {k + 2}, {before!r} s and {after!r} s, coincide: they are "
                    f"{after - before:.2g} s apart; at least {least:.2g} s is needed, "
                    f"{TIME_SPACING_REL_MIN:g} of the duration. Remove one of them",
                )
        if times[0] < 0 or times[-1] > self.duration:
            raise invalid_at(
                "output_times",
                f"must be from 0 to the duration of {self.duration:g} s; got {times[0]:g} s to "
                f"{times[-1]:g} s",
            )

    def unwritten(self) -> tuple[str, ...]:
        """The output interval, if output times override it."""
        return () if self.output_times is None else ("output_interval",)

    @property
    def outputs(self) -> int:
        """Number of output times, or one more."""
        if self.output_times is not None:
            return len(self.output_times)
        return int(self.duration / self.output_interval * (1 + 1e-12)) + 1

    @property
    def shape_stride(self) -> int:
        """Write every n-th shape."""
        return self.shape_every or max(1, -(-(self.outputs - 1) // MAX_SHAPES))

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
