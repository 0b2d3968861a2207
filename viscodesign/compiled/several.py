"""Several actuators as a function of free numbers: a function for each scene that they are."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.checks.check_several import error_of
from viscodesign.compiled.batch import COMPLETE, Batch, Outputs
from viscodesign.compiled.function import CompiledFunction, Judgement
from viscodesign.compiled.given_values import Values, listed_rows, names_of, values_in_order
from viscodesign.compiled.keyed_function import KeyedFunction
from viscodesign.compiled.several_keys import PartKeys, ScenePart, SeveralKeys, may_matter, parts_of
from viscodesign.errors import Fault, SpecError, did_you_mean, not_among
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.channels import channel
from viscodesign.scene.fluid_links import owner_of
from viscodesign.scene.several_scene import SeveralScene


@dataclass(frozen=True, eq=False)
class _Function:
    """The function of one scene among several."""

    part: ScenePart
    solve: CompiledFunction
    numbers: np.ndarray
    """Places of its free numbers among all (n,)."""


@dataclass(frozen=True)
class _Place:
    """Where an output is found."""

    function: _Function
    name: str
    """Under which its function has it."""


class CompiledActuators(KeyedFunction[SeveralKeys]):
    """Outputs of several actuators as a function of free numbers [SI], with derivatives.

    Effects, meshes, tolerances and output times are those of the scenes that it was made of. Equal
    actuators, and those that share fluid, are solved together, and only those are solved whose
    outputs are asked for. Safe in threads, and picklable: a copy compiles the same spec again.
    """

    def __init__(
        self,
        scene: SeveralScene,
        free: Sequence[str],
        outputs: Sequence[str],
        tolerance: float | None = None,
        edges_per_section: int | None = None,
    ) -> None:
        free, self.outputs = names_of("free", free), names_of("outputs", outputs)
        self._made_of = scene, free, self.outputs, tolerance, edges_per_section
        self._keys = SeveralKeys(scene, free)
        parts = parts_of(self._keys)
        wanted = [_wanted(name, scene, parts) for name in self.outputs]
        made = {
            part: self._function(part, [own for each, own in wanted if each is part])
            for part in dict.fromkeys(part for part, _ in wanted)
        }
        self._functions = tuple(made.values())
        places = (_Place(made[part], own) for part, own in wanted)
        self._places = dict(zip(self.outputs, places, strict=True))
        if faults := self._unused():
            raise SpecError(faults)

    def _function(self, part: ScenePart, outputs: Sequence[str]) -> _Function:
        spec, *_, tolerance, edges = self._made_of
        numbers = self._keys.numbers
        places = [k for k, own in enumerate(numbers) if may_matter(spec, part, own.path)]
        places = places or list(range(len(numbers)))
        keys = PartKeys(spec, part, [numbers[k].name for k in places])
        names = list(dict.fromkeys(outputs))
        try:
            solve = CompiledFunction(
                part.scene, keys.given, names, tolerance, edges, keys=keys, keeps_unused=True
            )
        except SpecError as error:
            known = {*self._keys.names, *self._keys.given}
            if all(fault.key in known for fault in error.faults):
                raise
            raise error_of("+".join(part.names), error) from None
        return _Function(part, solve, np.array(places))

    def _unused(self) -> list[Fault]:
        """Numbers that no output depends on."""
        spec, numbers = self._made_of[0], self._keys.numbers
        told: dict[str, Fault] = {}
        used: set[str] = set()
        for own in self._functions:
            unused = {fault.key: fault for fault in own.solve.unused}
            matter = {n.name for n in numbers if may_matter(spec, own.part, n.path)}
            told |= {name: fault for name, fault in unused.items() if name in matter}
            used |= set(own.solve.names) - set(unused)
        left = "cannot be free: none of the outputs depends on it"
        return [told.get(name, Fault(left, name)) for name in self.names if name not in used]

    @property
    def times(self) -> np.ndarray:
        """(T,) output times [s]."""
        return self._functions[0].solve.times

    @property
    def effects(self) -> dict[str, frozenset[str]]:
        """Names of the effects that are included, by actuator that is solved."""
        return {name: own.solve.effects for own in self._functions for name in own.part.names}

    # -- values and derivatives ---------------------------------------------------

    def __call__(self, values: Values | None = None) -> Outputs:
        """Every output at values (f,), by default the spec's own.

        Raises `SpecError` for values that are out of range, `SolveError` where a solution fails.
        """
        given = self._array(values)
        found = {own: own.solve(given[own.numbers]) for own in self._functions}
        return {name: found[p.function][p.name] for name, p in self._places.items()}

    def jacobian(self, values: Values | None = None) -> Outputs:
        """Derivatives of every output (T, f) or (f,), by the free numbers."""
        given = self._array(values)
        found = {own: own.solve.jacobian(given[own.numbers]) for own in self._functions}
        made = {}
        for name, place in self._places.items():
            slopes = found[place.function][place.name]
            made[name] = np.zeros((*slopes.shape[:-1], len(self.names)))
            made[name][..., place.function.numbers] = slopes
        return made

    def vjp(self, values: Values | None, weights: Mapping[str, Any]) -> np.ndarray:
        """Gradient (f,) of the sum of weights times outputs, by one adjoint solution a scene.

        ``weights``: of some or all outputs, shaped like them.
        """
        given, found = self._array(values), np.zeros(len(self.names))
        if unknown := [name for name in weights if name not in self._places]:
            raise SpecError([Fault(not_among(unknown[0], self.outputs), "weights")])
        for own in self._functions:
            each: dict[str, Any] = {}
            for name, weight in weights.items():
                place = self._places[name]
                if place.function is own:
                    each[place.name] = each.get(place.name, 0.0) + np.asarray(weight, dtype=float)
            if each:
                found[own.numbers] += own.solve.vjp(given[own.numbers], each)
        return found

    def batch(self, rows: Iterable[Values] | np.ndarray, workers: int | None = None) -> Batch:
        """Outputs of many rows of values (N, f), in so many threads, one by default.

        A row that is out of range or one of whose solutions fails is NaN in what could not be
        solved, and `Batch.status` says why.
        """
        listed = listed_rows(rows, self.names)
        given = np.array([self._array(values) for values in listed])
        given = given.reshape(len(listed), len(self.names))
        found = {own: own.solve.batch(given[:, own.numbers], workers) for own in self._functions}
        each = zip(*(batch.status for batch in found.values()), strict=True)
        status = [next((s for s in own if s != COMPLETE), COMPLETE) for own in each]
        outputs = {name: found[p.function][p.name] for name, p in self._places.items()}
        return Batch(outputs, status)

    # -- what else can be asked -----------------------------------------------------

    def scene(self, values: Values | None = None) -> SeveralScene:
        """The spec with these values. Raises `SpecError` where they make no valid spec."""
        return self._keys.validated(self._array(values))

    def judge(self, values: Values | None = None) -> dict[str, Judgement]:
        """Weigh all effects again for these values, by actuator that is solved."""
        given = self._array(values)
        each = [(own.part.names, own.solve.judge(given[own.numbers])) for own in self._functions]
        return {name: found for names, found in each for name in names}

    def _array(self, values: Values | None) -> np.ndarray:
        """Values in order (f,)."""
        found = values_in_order(values, self.names, self.values)
        if found.shape != (len(self.names),):
            message = f"expected {len(self.names)} values, one for each free number"
            raise SpecError.plain(f"{message}; got an array of shape {found.shape}")
        return found


def _wanted(
    output: str, spec: SeveralScene, parts: Mapping[str, ScenePart]
) -> tuple[ScenePart, str]:
    """The scene that has an output, and its name there."""
    actuator = owner_of(output, parts)
    if actuator is None:
        between = _between(spec, parts)
        if output not in between:
            known = [f"{name}.tip_x_m" for name in parts]
            hint = did_you_mean(output, [*between, *known])
            own = ", ".join([*known[:2], *between])
            message = f"'{output}' is not an output of several actuators{hint}; such as {own}"
            raise SpecError([Fault(message, "outputs")])
        return between[output], output
    part, own = parts[actuator], output.removeprefix(f"{actuator}.")
    if part.group is None:
        return part, own
    return part, _at_inlets(spec, actuator).get(own, output)


def _between(spec: SeveralScene, parts: Mapping[str, ScenePart]) -> dict[str, ScenePart]:
    """Columns of what belongs to no actuator, and the scenes that have them."""
    found: dict[str, ScenePart] = {}
    for group in spec.groups:
        columns = [
            *(channel(q).column(n) for n in group.inputs for q in ("inlet_pressure", "inflow")),
            *(channel("junction_pressure").column(n) for n in group.junctions),
            *(channel("flow").column(tube.name) for tube in group.shared),
        ]
        found |= dict.fromkeys(columns, parts[group.names[0]])
    return found


def _at_inlets(spec: SeveralScene, actuator: str) -> dict[str, str]:
    """Columns of the pressures at the inlets that an actuator has by itself, as its group's."""
    inlets = spec.alone[actuator].inlets
    group = next(own for own in spec.groups if actuator in own.names)
    found = {}
    for inlet, node in inlets.items():
        own = channel("inlet_pressure").column(inlet if len(inlets) > 1 else "")
        owner = owner_of(node, spec.actuators)
        prefix = f"{owner}." if owner is not None else ""
        bare = node.removeprefix(prefix)
        is_bellow = owner is not None and bare[:1] in "RL" and bare[1:].isdigit()
        quantity = "pressure" if is_bellow else "junction_pressure"
        quantity = "inlet_pressure" if node in group.inputs else quantity
        found[own] = prefix + channel(quantity).column(bare)
    return found
