"""Output times."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from tests.unit.scene.round_trip import comes_back
from viscodesign.errors import SpecError


def times(run: str) -> np.ndarray:
    return leg(f"run={{{run}}}").run.output_times_array()


def test_an_interval_that_divides_the_duration() -> None:
    assert times("duration: 8 s, output_interval: 20 ms") == pytest.approx(np.arange(401) * 0.02)


def test_an_interval_that_does_not_divide_the_duration() -> None:
    assert times("duration: 1 s, output_interval: 0.3 s") == pytest.approx([0, 0.3, 0.6, 0.9, 1.0])


@pytest.mark.parametrize("interval", [0.1, 0.07, 1 / 3, 1e-3])
def test_the_last_time_is_exactly_the_duration(interval: float) -> None:
    found = times(f"duration: 0.7, output_interval: {interval!r}")
    assert found[0] == 0.0
    assert found[-1] == 0.7
    assert (np.diff(found) > 0.5e-9 * interval).all()


def test_given_times_are_kept() -> None:
    assert times("duration: 2 s, output_times: [1 ms, 0.5, 2 s]").tolist() == [0.001, 0.5, 2.0]


def test_a_run_shorter_than_the_default_interval_has_two_outputs() -> None:
    assert times("duration: 1 ns").tolist() == [0.0, 1e-9]


def test_the_default_interval() -> None:
    assert leg("run={duration: 1 s}").run.output_interval == 0.02
    assert leg("run={duration: 1 s}").run.start == "equilibrium"


@pytest.mark.parametrize(
    ("run", "faults"),
    [
        ("output_times: []", ["run.duration: missing; simulated time, such as '20 ms'"]),
        ("duration: 0", ["run.duration: must be above 0 s; got 0"]),
        ("duration: 1, output_times: []", ["run.output_times: the list is empty"]),
        (
            "duration: 1, output_interval: 2",
            ["run.output_interval: must be at most the duration 1 s; got 2 s"],
        ),
        ("duration: 1e6 s", ["run.output_interval: 5e+07 outputs; at most 10000000"]),
        (
            "duration: 8, output_interval: 1, output_times: [1]",
            ["run.output_times: given together with output_interval; they are mutually exclusive"],
        ),
        (
            "duration: 8, output_times: [1, 1.00000000001]",
            ["run.output_times: times 1 and 2, 1.0 s and 1.00000000001 s, coincide"],
        ),
    ],
)
def test_faults(run: str, faults: list[str]) -> None:
    with pytest.raises(SpecError) as caught:
        leg(f"run={{{run}}}")
    found = [str(fault) for fault in caught.value.faults]
    assert len(found) == len(faults)
    for words, fault in zip(faults, found, strict=True):
        assert words in fault


def test_times_that_can_be_told_apart_are_kept() -> None:
    assert len(times("duration: 8 s, output_times: [1, 1.000000001, 1.000000002]")) == 3


@pytest.mark.parametrize("nothing", ["null", "~", ""])
def test_a_key_without_a_value_excludes_nothing(nothing: str) -> None:
    found = times(f"duration: 8 s, output_interval: {nothing}, output_times: [1, 2]")
    assert found.tolist() == [1.0, 2.0]


def test_an_override_replaces_the_other_choice_of_the_file() -> None:
    assert leg("run.output_times=[1, 2]").run.output_times == (1.0, 2.0)
    both = ("run={duration: 8 s, output_times: [1, 2]}", "run.output_interval=1 s")
    assert leg(*both).run.output_times is None
    with pytest.raises(SpecError, match="mutually exclusive"):
        leg("run.output_times=[1, 2]", "run.output_interval=1 s")


def test_a_resolved_spec_has_one_choice() -> None:
    assert "output_interval" not in comes_back(leg("run.output_times=[1, 2]"))
    assert "output_times" not in comes_back(leg())
