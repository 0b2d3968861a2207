"""Faults that no part of a spec shows alone: where its parts do not agree.

Each check takes what it compares; a part that is at fault itself is absent, and what
needs it waits until it is put right.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from pydantic_core import PydanticCustomError

from viscodesign.scene.fluid import Fluid
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.network import Network
from viscodesign.scene.pump import Pump
from viscodesign.scene.section import Complaint, complaints_of, did_you_mean

MOST_PERIODS = 250_000
SINGLE_INLET = "inlet"
PUMP_PARTS = {
    "servo_id": "servo",
    "sensor": "pressure sensor",
    "limit_switches": "limit switches",
}
"""Keys of the pump that may be given by inlet."""

Fields = Mapping[tuple[str, str | None], Any]
"""Valid fields by the names of their class and of themselves."""


def disagreements(valid: Fields) -> Iterator[Complaint]:
    """What is wrong between the fields that are right by themselves."""
    yield from _fluid(valid)
    yield from _inputs(valid)


def _inputs(valid: Fields) -> Iterator[Complaint]:
    """What hangs on the inlets: their names and periods, the network, the servos."""
    if ("Scene", "input") not in valid or ("Scene", "several_inputs") not in valid:
        return
    single, several = valid["Scene", "input"], valid["Scene", "several_inputs"]
    yield from _choice_of_inputs(single, several)
    if (single is None) == (several is None) or several == {}:
        return
    inputs: Mapping[str, Input] = several if several is not None else {SINGLE_INLET: single}
    yield from _inlet_names(inputs)
    if ("Run", "duration") in valid:
        yield from _periods(inputs, valid["Run", "duration"], several is None)
    if ("Scene", "network") in valid and ("Bellows", "count") in valid:
        yield from _graph(valid["Scene", "network"], valid["Bellows", "count"], inputs)
    if ("Scene", "fluid_choice") in valid:
        yield from _barrels(valid["Scene", "fluid_choice"], inputs, several is None)
    if ("Scene", "pump") in valid:
        yield from _pump_parts(valid["Scene", "pump"], inputs)


def _fluid(valid: Fields) -> Iterator[Complaint]:
    """A named fluid whose properties are not known at the scene's temperature and pressure."""
    names = ("fluid_choice", "temperature", "ambient_pressure")
    if any(("Scene", name) not in valid for name in names):
        return
    fluid: Fluid = valid["Scene", "fluid_choice"]
    try:
        fluid.properties(valid["Scene", "temperature"], valid["Scene", "ambient_pressure"])
    except PydanticCustomError as error:
        for found in complaints_of(error):
            is_own = found.path != ("temperature",)
            yield found._replace(path=("fluid", *found.path)) if is_own else found


def _choice_of_inputs(single: Any, several: Any) -> Iterator[Complaint]:
    if single is not None and several is not None:
        yield Complaint(("input",), "given together with 'inputs'; give one of them")
    if single is None and several is None:
        yield Complaint(("input",), "missing; give 'input', or 'inputs' for several inlets")
    if several is not None and not several:
        yield Complaint(("inputs",), "empty; at least one inlet needs an input")


def _inlet_names(inputs: Mapping[str, Input]) -> Iterator[Complaint]:
    for name in inputs:
        if re.fullmatch(r"[RLrl]\d+", name):
            yield Complaint(("inputs", name), "an inlet cannot be called like a bellow")
        elif not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", name):
            yield Complaint(
                ("inputs", name),
                "no name for an inlet; use letters, digits and '_', a letter first",
            )


def _periods(inputs: Mapping[str, Input], duration: float, is_single: bool) -> Iterator[Complaint]:
    for name, source in inputs.items():
        if source.period is not None and duration / source.period > MOST_PERIODS:
            yield Complaint(
                ("input",) if is_single else ("inputs", name),
                f"{duration / source.period:.3g} periods in {duration:g} s; at most "
                f"{MOST_PERIODS} are allowed. Use a run.duration of "
                f"{MOST_PERIODS * source.period:.3g} s or less; a cycle that repeats itself is "
                "known long before",
            )


def _graph(network: Network, count: int, inputs: Mapping[str, Input]) -> Iterator[Complaint]:
    try:
        network.graph(count, tuple(inputs))
    except PydanticCustomError as error:
        yield from (c._replace(path=("network", *c.path)) for c in complaints_of(error))


def _barrels(fluid: Fluid, inputs: Mapping[str, Input], is_single: bool) -> Iterator[Complaint]:
    """A plunger needs a fluid that yields: its stiffness makes the pressure."""
    yields = fluid.gas_constant or fluid.bulk_modulus
    own = fluid.viscosity is not None
    for name, source in inputs.items():
        if not source.gives_pressure and not yields and (own or not fluid.library_knows_stiffness):
            yield Complaint(
                ("input",) if is_single else ("inputs", name),
                f"a syringe drives {fluid.name}, whose stiffness is not known; state viscosity, "
                "density and gas_constant or bulk_modulus under fluid",
            )


def _pump_parts(pump: Pump | None, inputs: Mapping[str, Input]) -> Iterator[Complaint]:
    """What the pump has for each inlet: for every one, and for no other."""
    for key, what in PUMP_PARTS.items():
        parts = getattr(pump, key, None)
        if not isinstance(parts, Mapping):
            continue
        known = ", ".join(inputs)
        for name in parts:
            if name not in inputs:
                message = f"no such inlet{did_you_mean(name, inputs)}; the inlets are {known}"
                yield Complaint(("pump", key, name), message)
        for name in inputs:
            if name not in parts:
                yield Complaint(("pump", key), f"the inlet '{name}' has no {what}")
