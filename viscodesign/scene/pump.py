"""`pump:` one of the kinds in `pumps/`, chosen by `kind`; without one a servo's."""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from operator import or_
from typing import Annotated, Any

from pydantic import BeforeValidator, Field

from viscodesign.plugins import members
from viscodesign.scene.pumps import __name__ as pumps_package
from viscodesign.scene.pumps.base import PumpSpec

PUMP_KINDS: dict[str, type[PumpSpec]] = members(pumps_package, PumpSpec)
DEFAULT_KIND = next(iter(PUMP_KINDS))


def _with_kind(given: Any) -> Any:
    unsaid = isinstance(given, Mapping) and "kind" not in given
    return {"kind": DEFAULT_KIND, **given} if unsaid else given


AnyPump: Any = Annotated[
    Annotated[reduce(or_, PUMP_KINDS.values()), Field(discriminator="kind")],
    BeforeValidator(_with_kind),
]
