"""Faults between parts of a spec that are valid by themselves.

Each check takes the fields that it compares; checks of an invalid field are left out.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.errors import did_you_mean
from viscodesign.scene.common_period import no_period
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.network import Network
from viscodesign.scene.pressure_levels import bare_levels
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.sections import section_faults
from viscodesign.scene.spec_part import KeyFault, KeyPath, faults_of

MAX_PERIODS = 250_000
MAX_ROWS_OF_CYCLES = 1_000_000
"""Rows of a repeated table times its periods in a run."""
SINGLE_INLET = "inlet"

Fields = Mapping[tuple[str, str | None], Any]
"""Valid fields by (class name, field name)."""


def cross_check(valid: Fields) -> Iterator[KeyFault]:
    """All faults between the valid fields."""
    yield from _fluid(valid)
    yield from _sections(valid)
    yield from _inputs(valid)


def _sections(valid: Fields) -> Iterator[KeyFault]:
    changes, count = valid.get(("Scene", "section_changes")), valid.get(("Bellows", "count"))
    for fault in section_faults(changes, count // 2) if changes and count else ():
        yield fault._replace(path=("sections", *fault.path))


def _inputs(valid: Fields) -> Iterator[KeyFault]:
    """Everything that depends on the inlets: names, periods, network, servos."""
    if ("Scene", "input") not in valid or ("Scene", "several_inputs") not in valid:
        return
    single, several = valid["Scene", "input"], valid["Scene", "several_inputs"]
    yield from _choice_of_inputs(single, several)
    if (single is None) == (several is None) or several == {}:
        return
    inputs: Mapping[str, Input] = several if several is not None else {SINGLE_INLET: single}
    yield from _inlet_names(inputs)
    if ("RunSettings", "duration") in valid:
        yield from _periods(inputs, valid["RunSettings", "duration"], several is None)
    if valid.get(("RunSettings", "start")) == "periodic" and (reason := no_period(inputs)):
        yield KeyFault(("run", "start"), f"'periodic' needs inputs that repeat; {reason}")
    if ("Scene", "network") in valid and ("Bellows", "count") in valid:
        yield from _graph(valid["Scene", "network"], valid["Bellows", "count"], inputs)
    if ("Scene", "fluid_choice") in valid:
        yield from _syringe_fluids(valid["Scene", "fluid_choice"], inputs, several is None)
    if ("Scene", "pump") in valid:
        yield from _pump_parts(valid["Scene", "pump"], inputs)
        if valid["Scene", "pump"] is not None and ("Scene", "ambient_pressure") in valid:
            yield from _pump_levels(inputs, valid["Scene", "ambient_pressure"], several is None)


def _fluid(valid: Fields) -> Iterator[KeyFault]:
    """A named fluid whose properties are unknown at the scene's temperature and pressure."""
    names = ("fluid_choice", "temperature", "ambient_pressure")
    if any(("Scene", name) not in valid for name in names):
        return
    fluid: Fluid = valid["Scene", "fluid_choice"]
    try:
        fluid.properties(valid["Scene", "temperature"], valid["Scene", "ambient_pressure"])
    except PydanticCustomError as error:
        for found in faults_of(error):
            is_own = found.path not in (("temperature",), ("ambient_pressure",))
            yield found._replace(path=("fluid", *found.path)) if is_own else found


def _choice_of_inputs(single: Any, several: Any) -> Iterator[KeyFault]:
    if single is not None and several is not None:
        yield KeyFault(("input",), "given together with 'inputs'; give only one of them")
    if single is None and several is None:
        yield KeyFault(("input",), "missing; give 'input', or 'inputs' for several inlets")
    if several is not None and not several:
        yield KeyFault(("inputs",), "empty; at least one inlet needs an input")


def _inlet_names(inputs: Mapping[str, Input]) -> Iterator[KeyFault]:
    for name in inputs:
        if re.fullmatch(r"[RLrl]\d+", name):
            yield KeyFault(("inputs", name), "an inlet cannot have the name of a bellow")
        elif not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name):
            yield KeyFault(
                ("inputs", name),
                "not a valid inlet name; use letters, digits and '_', starting with a letter",
            )


def _periods(inputs: Mapping[str, Input], duration: float, is_single: bool) -> Iterator[KeyFault]:
    for name, source in inputs.items():
        if source.period is not None and duration / source.period > MAX_PERIODS:
            yield KeyFault(
                ("input",) if is_single else ("inputs", name),
                f"{duration / source.period:.3g} periods in {duration:g} s; at most "
                f"{MAX_PERIODS} are allowed. Use a run.duration of "
                f"{MAX_PERIODS * source.period:.3g} s or less; the response is periodic long "
                "before that",
            )
        elif isinstance(source, TableInput) and source.repeat:
            yield from _cycles(source, duration, ("input",) if is_single else ("inputs", name))


def _cycles(source: TableInput, duration: float, place: KeyPath) -> Iterator[KeyFault]:
    """A repeated table with too many rows in all periods together."""
    rows, periods = len(source.rows or ()), math.ceil(duration / (source.period or duration))
    if rows * periods > MAX_ROWS_OF_CYCLES:
        longest = MAX_ROWS_OF_CYCLES // rows * (source.period or duration)
        yield KeyFault(
            (*place, "repeat"),
            f"{rows} rows in each of {periods} periods are {rows * periods} rows; at most "
            f"{MAX_ROWS_OF_CYCLES} are allowed. Use a run.duration of {longest:.3g} s or less",
        )


def _graph(network: Network, count: int, inputs: Mapping[str, Input]) -> Iterator[KeyFault]:
    try:
        network.graph(count, tuple(inputs))
    except PydanticCustomError as error:
        yield from (c._replace(path=("network", *c.path)) for c in faults_of(error))


def _syringe_fluids(
    fluid: Fluid, inputs: Mapping[str, Input], is_single: bool
) -> Iterator[KeyFault]:
    """A syringe needs a compressible fluid, whose stiffness determines the pressure."""
    is_compressible = fluid.gas_constant or fluid.bulk_modulus
    own = fluid.viscosity is not None
    for name, source in inputs.items():
        if (
            not source.gives_pressure
            and not is_compressible
            and (own or not fluid.library_knows_stiffness)
        ):
            yield KeyFault(
                ("input",) if is_single else ("inputs", name),
                f"a syringe needs the stiffness of {fluid.name}, which is unknown; give viscosity, "
                "density and gas_constant or bulk_modulus under 'fluid'",
            )


def _pump_parts(pump: PumpSpec | None, inputs: Mapping[str, Input]) -> Iterator[KeyFault]:
    """Parts of the pump per inlet: one for each inlet and no others."""
    for key, description in (pump.parts_per_inlet if pump else {}).items():
        parts = getattr(pump, key)
        if not isinstance(parts, Mapping):
            continue
        known = ", ".join(inputs)
        for name in parts:
            if name not in inputs:
                message = f"no such inlet{did_you_mean(name, inputs)}; the inlets are {known}"
                yield KeyFault(("pump", key, name), message)
        for name in inputs:
            if name not in parts:
                yield KeyFault(("pump", key), f"the inlet '{name}' has no {description}")


def _pump_levels(
    inputs: Mapping[str, Input], ambient: float, is_single: bool
) -> Iterator[KeyFault]:
    """Levels for a pump that may be meant as gauge or as absolute."""
    for name, source in inputs.items():
        place = ("input",) if is_single else ("inputs", name)
        above_ambient = [(key, level) for key, level in bare_levels(source) if level > ambient]
        for key, level in above_ambient:
            kpa, above = f"{level / 1e3:g} kPa", f"{(level - ambient) / 1e3:.4g} kPa"
            yield KeyFault(
                (*place, key),
                f"{kpa} exceeds the ambient pressure of {ambient / 1e3:g} kPa: for the pump it "
                f"may be gauge or absolute; write '{kpa} gauge', or '{kpa} abs' ({above} gauge)",
            )
