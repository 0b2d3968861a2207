"""`bellows.changes:` what single bellows have otherwise than all others."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from pydantic import Field

from viscodesign.errors import did_you_mean
from viscodesign.model.graph import bellow_names
from viscodesign.scene.bellow_curve import BellowCurve
from viscodesign.scene.member_changes import clashes
from viscodesign.scene.spec_part import KeyFault, SpecPart
from viscodesign.units import (
    Angle,
    AreaPerForce,
    AreaPerMoment,
    AreaPerPressure,
    Fraction,
    Length,
)


class BellowChange(SpecPart):
    """What single bellows have in the place of the numbers of all."""

    height: Length | None = Field(None, gt=0, description="Instead of bellows.height")
    width: Length | None = Field(None, gt=0, description="Instead of bellows.width")
    length: Length | None = Field(None, gt=0, description="Instead of bellows.length")
    area_per_pressure: AreaPerPressure | None = Field(
        None, gt=0, description="Instead of bellows.area_per_pressure"
    )
    angle_per_pressure: Angle | None = Field(
        None,
        description="Instead of bellows.angle_per_pressure: turn of the section by this bellow",
    )
    extension_per_pressure: Length | None = Field(
        None,
        description="Instead of bellows.extension_per_pressure: lengthening of the section by "
        "this bellow",
    )
    area_per_force: AreaPerForce | None = Field(
        None, description="Instead of bellows.area_per_force"
    )
    area_per_moment: AreaPerMoment | None = Field(
        None, description="Instead of bellows.area_per_moment"
    )
    collapse_fraction: Fraction | None = Field(
        None, ge=0, lt=1, description="Instead of bellows.collapse_fraction"
    )
    curve: BellowCurve | None = Field(
        None, description="Instead of bellows.curve, which all other bellows then need"
    )


def bellows_named(key: str) -> list[str]:
    """The bellows that a key such as R3, R1-R4, 3 or 1-4 names; empty where it names none."""
    found = re.fullmatch(r"([RL]?)(\d+)(?:-([RL]?)(\d+))?", key)
    if found is None or (found[4] and found[1] != found[3]):
        return []
    first, last = int(found[2]), int(found[4] or found[2])
    numbers = range(first, last + 1) if first else ()
    return [f"{side}{j}" for side in found[1] or "RL" for j in numbers]


def bellow_change_faults(changes: Mapping[str, BellowChange], count: int) -> Iterator[KeyFault]:
    """Bellows that an actuator of ``count`` sections does not have, and clashes."""
    known = set(bellow_names(count))
    for key in changes:
        names = bellows_named(key)
        if not names or not known.issuperset(names):
            yield KeyFault((key,), _no_such_bellow(key, known, count))
    yield from clashes(changes, bellows_named)


def _no_such_bellow(key: str, known: set[str], count: int) -> str:
    hint = did_you_mean(key.upper(), sorted(known))
    return (
        f"no such bellow{hint or ';'} the actuator has R1 to R{count} and L1 to L{count}. "
        "Write one, such as 'R1', a range, such as 'R1-R2', or '1' for both bellows of section 1"
    )
