"""From the free numbers of a scene to all numbers of its problem, with exact derivatives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import casadi as ca
import numpy as np
from pydantic import BaseModel

from viscodesign.compiled.free_keys import FreeKeys, parts_in
from viscodesign.compiled.traced import Condition, Tape, formula_of, matrix_of
from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import catalogue
from viscodesign.effects.select import Selection
from viscodesign.errors import Fault, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.chain import Chain
from viscodesign.model.formulation import settle
from viscodesign.model.rod import Body
from viscodesign.model.structure import structure_of
from viscodesign.model.system import System
from viscodesign.model.unknowns import Sizes
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import (
    Settings,
    assemble,
    pieces_between,
    resolvable_body,
    sizes_of,
    stops_of,
)

SX = ca.SX

RESULTS = ("parameters", "pieces", "initial_piece", "stops")


class ProblemNumbers(NamedTuple):
    """All numbers of a problem that follow from the free ones."""

    parameters: np.ndarray
    """(p,), as `Equations.parameter_values`."""
    pieces: np.ndarray
    """(m, c): coefficients of the inlets in every stretch between two stops."""
    initial_piece: np.ndarray
    """(c,): those just before t = 0."""
    stops: np.ndarray
    """(m + 1,): 0, every corner of an input, and the end of the run [s]."""


class SceneNumbers:
    """The numbers of a scene's problem as a function of its free numbers.

    Made once for a scene, the effects chosen for it and a mesh, all of which stay as they are. For
    any values that `check` accepts, the results are those of a problem that `build` makes of the
    scene with these values, except for what is frozen on purpose: effects and mesh, the sizes by
    which unknowns are scaled (parameters ``size.*``), which tubes count as wide, output times, and
    a stiffness along the axis that the scene's accuracy cannot tell from infinite.

    ``function`` is a CasADi function (values (f,)) -> (parameters (p,), pieces (m, c),
    initial_piece (c,), stops (m + 1,)), all dense, to be differentiated in any way; ``derivatives``
    maps values (f,) to the Jacobian of each, sparse: (p, f), (m c, f), (c, f), (m + 1, f), with the
    pieces in column-major order (CasADi's). `at` and `jacobian_at` do the same for arrays.

    Corners move with the numbers of an input. The number of stretches and the order of corners
    stay those of the scene; `check` refuses values that would change them.

    Raises `SpecError` for keys that cannot be free: see `FreeKeys`; where nothing in the equations
    depends on a number; or where its value stands in a formula as a constant.
    """

    def __init__(
        self,
        quantities: SceneQuantities,
        selection: Selection,
        settings: Settings,
        free: Sequence[str],
    ) -> None:
        self.keys = FreeKeys(quantities.scene, free)
        self.names = self.keys.names
        self.values = np.array([number.value for number in self.keys.numbers])
        """(f,) The scene's own numbers [SI]."""
        frozen = _Frozen.of(quantities, selection.effects, settings)
        trace = _traced(self.keys, frozen)
        symbols = trace.symbols
        results = [trace.parameters, trace.pieces, trace.initial, trace.stops]
        self.parameter_names = trace.parameter_names
        self._refuse_unused(symbols, results, selection)
        self._refuse_decided(trace)
        self.function = ca.Function("scene_numbers", [symbols], results, ["values"], [*RESULTS])
        jacobians = [ca.jacobian(ca.vec(result), symbols) for result in results]
        self.derivatives = ca.Function("derivatives", [symbols], jacobians, ["values"], [*RESULTS])
        self._margins, self._margin_slopes = _margins(symbols, trace.tape.conditions)
        self._places = [condition.place for condition in trace.tape.conditions]

    # -- values -------------------------------------------------------------------

    def check(self, values: Sequence[float] | np.ndarray) -> None:
        """Raise `SpecError` for values (f,) with all faults: not finite, out of range, or beyond
        a change of the formulas, such as the order of corners.
        """
        given = np.asarray(values, dtype=float)
        if given.shape != self.values.shape:
            message = f"expected {len(self.values)} values, one for each free number"
            raise SpecError.plain(f"{message}; got an array of shape {given.shape}")
        faults = [n.fault(float(v)) for n, v in zip(self.keys.numbers, given, strict=True)]
        found = [fault for fault in faults if fault is not None]
        if found:
            raise SpecError(found)
        margins = np.asarray(self._margins(given)).ravel()
        if not np.all(margins >= 0.0):
            raise SpecError([self._crossing(int(np.argmin(margins)), given)])

    def at(self, values: np.ndarray) -> ProblemNumbers:
        """The numbers of the problem at values (f,), which are not checked."""
        parameters, pieces, initial, stops = (np.array(part) for part in self.function(values))
        return ProblemNumbers(parameters.ravel(), pieces, initial.ravel(), stops.ravel())

    def jacobian_at(self, values: np.ndarray) -> ProblemNumbers:
        """Their derivatives, each with one more axis of length f."""
        count = len(self.values)
        parameters, pieces, initial, stops = (np.array(p.full()) for p in self.derivatives(values))
        shape = (*self.function.size_out(1), count)
        return ProblemNumbers(parameters, pieces.reshape(shape, order="F"), initial, stops)

    def scene(self, values: Sequence[float] | np.ndarray) -> Scene:
        """The scene with these values, validated like a loaded one."""
        from viscodesign.loading import known_effects
        from viscodesign.scene.reading.read import parse_scene
        from viscodesign.scene.reading.write import resolved_yaml

        placed = self.keys.placed([float(value) for value in values])
        text = resolved_yaml(placed).encode()
        return parse_scene(text, known=known_effects()).with_source(self.keys.scene.source)

    # -- refusals -----------------------------------------------------------------

    def _refuse_unused(self, symbols: SX, results: list[SX], selection: Selection) -> None:
        used = ca.which_depends(ca.veccat(*results), symbols, 1, False)
        unused = [name for name, is_used in zip(self.names, used, strict=True) if not is_used]
        if unused:
            raise SpecError([_unused_fault(name, selection) for name in unused])

    def _refuse_decided(self, trace: _Trace) -> None:
        """Refuse a number that the formulas, or its range, let move to neither side."""
        below = np.array([number.value <= number.bounds.low for number in self.keys.numbers])
        above = np.array([number.value >= number.bounds.high for number in self.keys.numbers])
        places = dict.fromkeys(self.names, "its range")
        for column, slope, condition in self._tight(trace):
            below[column] |= slope > 0.0 or condition.is_equality
            above[column] |= slope < 0.0 or condition.is_equality
            places[self.names[column]] = condition.place
        stuck = [n for n, *ends in zip(self.keys.numbers, below, above, strict=True) if all(ends)]
        if stuck:
            message = "cannot be free at {}: {} has other formulas beside it; give another value"
            given = [(f"{n.value:g}", places[n.name], n.name) for n in stuck]
            raise SpecError([Fault(message.format(v, place), name) for v, place, name in given])

    def _tight(self, trace: _Trace) -> Iterator[tuple[int, float, Condition]]:
        """Free numbers, by their position, whose change in one direction breaks a condition that
        just holds; the slope of its gap.
        """
        conditions = trace.tape.conditions
        gaps = ca.vertcat(SX(0, 1), *(condition.gap for condition in conditions))
        scales = ca.vertcat(SX(0, 1), *(condition.scale for condition in conditions))
        found = ca.Function(
            "slopes", [trace.symbols], [ca.jacobian(gaps, trace.symbols), gaps, scales]
        )
        slopes, *both = found(self.values)
        gap, scale = (np.array(part.full()).ravel() for part in both)
        rows, columns = (
            np.array(indices, dtype=int) for indices in slopes.sparsity().get_triplet()
        )
        moves = np.abs(slopes.nonzeros()) * np.where(self.values, np.abs(self.values), 1.0)[columns]
        is_tight = (np.abs(gap) <= ROUNDING * scale)[rows] & (moves > ROUNDING * scale[rows])
        for k in np.flatnonzero(is_tight):
            yield int(columns[k]), float(slopes.nonzeros()[k]), conditions[rows[k]]

    def _crossing(self, row: int, values: np.ndarray) -> Fault:
        """The fault of values for which a condition of the formulas does not hold."""
        slopes = np.array(self._margin_slopes(values)[row, :].full()).ravel()
        names = [name for name, slope in zip(self.names, slopes, strict=True) if slope]
        given = ", ".join(f"{values[self.names.index(name)]:g}" for name in names)
        if self._places[row] == INPUT:
            what = "a corner of an input passes another corner, the start or the end of the run"
        else:
            what = f"{self._places[row]} has other formulas there"
        message = f"with {given} {what}; compile the scene with values beyond that"
        return Fault(message, ", ".join(names))


ROUNDING = 1e-9
"""Difference of two numbers, over their size, that counts as none."""
UNTRACEABLE = (TypeError, AttributeError, NotImplementedError)
"""What formulas raise that need plain numbers."""
INPUT, SCENE = "the input", "the scene"
LAWS = "a law of the fluid or of the bellows' walls"
"""What is traced, in words."""


@dataclass(frozen=True)
class _Frozen:
    """What a scene's free numbers do not change."""

    effects: list[type[Effect]]
    edges_per_section: int
    body: Body
    """As the equations have it."""
    is_stiff: bool
    """Whether its stiffness along the axis is one that cannot be told from infinite."""
    sizes: Sizes

    @classmethod
    def of(
        cls, quantities: SceneQuantities, effects: Sequence[Effect], settings: Settings
    ) -> _Frozen:
        body = resolvable_body(quantities)
        return cls(
            [type(effect) for effect in effects],
            settings.edges_per_section,
            body,
            body.extension_stiffness != quantities.body.extension_stiffness,
            sizes_of(quantities),
        )

    def body_of(self, quantities: SceneQuantities) -> Body:
        """The body of a scene with other numbers, as the equations have it."""
        if not self.is_stiff:
            return quantities.body
        return replace(quantities.body, extension_stiffness=self.body.extension_stiffness)


def _traced(keys: FreeKeys, frozen: _Frozen) -> _Trace:
    """The numbers traced; raises `SpecError` with all keys that some formula needs as constants."""
    tape = Tape()
    try:
        return _Trace(keys, frozen, tape)
    except UNTRACEABLE as error:
        if len(keys.given) == 1:
            raise SpecError([_constant_fault(keys.given[0], tape.place)]) from error
    faults = []
    for key in keys.given:
        try:
            _traced(FreeKeys(keys.scene, [key]), frozen)
        except SpecError as error:
            faults += error.faults
    raise SpecError(faults or [Fault("cannot be free together", ", ".join(keys.given))])


class _Trace:
    """One run of the code that makes a problem's numbers, on traced numbers."""

    def __init__(self, keys: FreeKeys, frozen: _Frozen, tape: Tape) -> None:
        self.tape = tape
        values = [number.value for number in keys.numbers]
        self.symbols, traced = self.tape.numbers(keys.names, values)
        tape.place = SCENE
        scene = keys.placed(traced)
        _validate_again(scene, keys.scene)
        system = self._system(SceneQuantities(scene), frozen)
        numbers = system.numbers()
        self.parameter_names = tuple(numbers)
        self.parameters = ca.vertcat(*map(formula_of, numbers.values()))
        tape.place = INPUT
        stops = stops_of(scene)
        pieces, initial = pieces_between(scene, stops)
        self.stops, self.pieces = matrix_of(stops), matrix_of(pieces)
        self.initial = matrix_of(initial)

    def _system(self, quantities: SceneQuantities, frozen: _Frozen) -> System:
        effects = (self._effect(kind, quantities) for kind in frozen.effects)
        rod = Chain(quantities.body, frozen.edges_per_section)
        system = assemble(quantities, effects, rod, frozen.body_of(quantities))
        self.tape.place = LAWS
        settle(system, frozen.sizes)
        self._refuse_constants(system)
        return system

    def _refuse_constants(self, system: System) -> None:
        """Refuse numbers that the formulas to be made of a system hold as constants."""
        self.tape.is_paused = True
        structure_of(system)
        self.tape.is_paused = False
        if self.tape.constants:
            held = {symbol.name() for symbol in ca.symvar(ca.vertcat(*self.tape.constants))}
            raise SpecError([_constant_fault(name, LAWS) for name in sorted(held)])

    def _effect(self, kind: type[Effect], quantities: SceneQuantities) -> Effect:
        self.tape.place = f"the effect {kind.name}"  # until the next one joins
        return kind.of(quantities)


def _validate_again(part: BaseModel, base: BaseModel) -> None:
    """Run the checks of every changed part, so that what they take for granted is noted.

    Those of the whole scene, between its parts, ask a library for the fluid and are left out.
    """
    for name in type(part).model_fields:
        pairs = zip(parts_in(getattr(part, name)), parts_in(getattr(base, name)), strict=False)
        for (_, inner), (_, former) in pairs:
            if inner is former:
                continue
            for check in type(inner).__pydantic_decorators__.model_validators.values():
                if check.info.mode == "after":
                    check.func(inner)
            _validate_again(inner, former)


def _margins(symbols: SX, conditions: Sequence[Condition]) -> tuple[ca.Function, ca.Function]:
    """Margins of all conditions (n,), and their derivatives (n, f)."""
    margins = ca.vertcat(SX(0, 1), *(condition.margin for condition in conditions))
    slopes = ca.jacobian(margins, symbols)
    return ca.Function("margins", [symbols], [margins]), ca.Function("slopes", [symbols], [slopes])


def _constant_fault(key: str, place: str) -> Fault:
    return Fault(f"cannot be free: {place} holds its value as a constant", key)


def _unused_fault(name: str, selection: Selection) -> Fault:
    """Why nothing depends on a number, and which neglected effect would."""
    readers = [
        effect.name
        for effect in catalogue().values()
        if effect.name not in selection.active and name in effect.keys
    ]
    hint = f"; {' and '.join(readers)} would, but is not included" if readers else ""
    return Fault(f"cannot be free: nothing in this scene's equations depends on it{hint}", name)
