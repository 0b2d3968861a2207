"""Every number of a spec, a thousand times too large and too small: `check` tells, or need not."""

from __future__ import annotations

import copy
import re
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tests.scenes import ROOT
from tests.unit.checks.every_key import Spec, specs
from viscodesign import load
from viscodesign.checks.refusals import refuse_beyond_numbers
from viscodesign.checks.scene_warnings import scene_notices
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities

LEVEL = "one level or part of several, whose sum is as large as before"
AT_ONCE = "at once is a usual time"
WEIGHED = "a small load is weighed like any effect, and neglected where it is one"
ANY_ANGLE = "any angle below a turn is one"
NEED_NOT = {
    "accuracy": "an error of 5e-6 of the length may be asked for; the cost tells",
    "run.duration": "a long run is what it says; its outputs are counted",
    "bellows.area_per_force": "measured ones are 0.1 to 0.2 of what the work of pressures gives",
    "bellows.changes.R1.area_per_force": "likewise",
    "network.tube_wall.youngs_modulus": "tubes are made of steel, too",
    "loads.gravity.tilt": ANY_ANGLE,
    "input.phase": ANY_ANGLE,
    "loads.ground.normal": ANY_ANGLE,
    "loads.tip_force.x": WEIGHED,
    "loads.tip_force.z": WEIGHED,
    "loads.payload": WEIGHED,
    "input.start": LEVEL,
    "input.mean": LEVEL,
    "input.high": LEVEL,
    "input.low": LEVEL,
    "input.cosine[0]": LEVEL,
    "input.sine[0]": LEVEL,
    "input.time": AT_ONCE,
    "pump.gear_play": "gears may have no play",
    "fluid.vapour_pressure": "oils have next to none",
    "fluid.fraction": "a solution may be dilute",
}
"""Keys with a factor of a thousand that is not told, and why."""
MILLION = {
    "loads.gravity.tilt", "loads.ground.normal", "loads.tip_force.x", "loads.tip_force.z", "loads.payload", "pump.gear_play",
    "input.start", "input.mean", "input.phase", "input.high", "input.low", "input.cosine[0]",
    "input.sine[0]", "input.time", "fluid.vapour_pressure", "fluid.fraction",
}  # fmt: skip
"""Those of them for which a factor of a million is not told either."""
WITHOUT_UNIT = {"spec", "bellows.count", "run.max_steps", "run.shape_every", "pump.home", "pump.servo_id", "pump.feeds"}  # fmt: skip
"""Integers, which have no prefix to slip."""
NOT_GIVEN = {
    "bellows.curve.rows",
    "bellows.changes.R1.curve.rows",
    "run.output_times",
    "input.measured.noise",
    "input.measured.largest",
}

Change = Callable[[float], Spec]


def numbers(spec: Spec) -> Iterator[tuple[str, Change]]:
    """Every number of a spec, or column of its rows, by its key, and the spec with it scaled."""
    for path, column in _places(spec):
        name = ".".join(map(str, path)) + ("" if column is None else f"[{column}]")
        yield name, lambda factor, p=path, c=column: _scaled(spec, p, c, factor)


def _places(here: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[tuple[Any, ...], int | None]]:
    if isinstance(here, dict):
        for name, value in here.items():
            yield from _places(value, (*path, name))
    elif isinstance(here, list) and isinstance(here[0], dict):
        yield from _places(here[0], (*path, 0))
    elif isinstance(here, list):
        yield from ((path, k) for k in range(len(here[0]) if isinstance(here[0], list) else 1))
    elif isinstance(here, float):
        yield path, None


def _scaled(spec: Spec, path: tuple[Any, ...], column: int | None, factor: float) -> Spec:
    changed = copy.deepcopy(spec)
    here: Any = changed
    for part in path[:-1]:
        here = here[part]
    value = here[path[-1]]
    if column is None:
        here[path[-1]] = value * factor
    elif isinstance(value[0], list):
        for row in value:
            row[column] *= factor
    else:
        here[path[-1]] = [number * factor for number in value]
    return changed


def told(spec: Spec) -> set[str]:
    """Codes of all that `check` says of a spec before it weighs effects."""
    try:
        quantities = SceneQuantities(load(spec))
        refuse_beyond_numbers(quantities)
    except SpecError:
        return {"refused"}
    return {notice.code for notice in scene_notices(quantities, frozenset())}


def silent(factors: tuple[float, float]) -> set[str]:
    found: set[str] = set()
    seen: set[str] = set()
    for spec in specs():
        before, kind = told(spec), spec["input"]["kind"]
        assert before <= {"not_reciprocal"}, f"a sound spec with a {kind} is warned about: {before}"
        for key, change in numbers(spec):
            name = f"{kind}.{key}" if key.startswith("input.") else key
            if name not in seen:
                seen.add(name)
                if any(not told(change(factor)) - before for factor in factors):
                    found.add(key)
    return found


def test_a_number_a_thousand_times_off_is_told_unless_there_is_a_reason() -> None:
    assert silent((1e3, 1e-3)) == set(NEED_NOT)


def test_a_number_a_million_times_off_is_told_unless_there_is_a_reason() -> None:
    assert silent((1e6, 1e-6)) == MILLION


@pytest.fixture(scope="module")
def documented() -> set[str]:
    """Keys of the page of all keys that hold a quantity."""
    rows = re.findall(
        r"^\| `([^`]+)` \| [^|]* \| `[^`]+` \|", (ROOT / "docs" / "keys.md").read_text(), re.M
    )
    alone = {re.sub(r"\[0\]", ".0", key) for key in rows}
    # Those of robots have a test of their own.
    return {key for key in alone if not key.startswith(("robot.", "inputs.B."))}


def test_every_key_with_a_unit_is_tried(documented: set[str]) -> None:
    tried = {key for spec in specs() for key, _ in numbers(spec)}
    assert len(documented) > 60
    assert documented - tried - NOT_GIVEN - WITHOUT_UNIT == set()
