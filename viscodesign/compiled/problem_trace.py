"""The code that makes a problem's numbers, run once on numbers that carry formulas."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import casadi as ca
import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.compiled.conditions import Tape
from viscodesign.compiled.free_keys import SceneKeys
from viscodesign.compiled.scene_fields import parts_in
from viscodesign.compiled.traced import formula_of, free_numbers, known, matrix_of, value_of
from viscodesign.effects.base import Effect
from viscodesign.errors import Fault, SpecError
from viscodesign.estimate.joined_quantities import quantities_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formulation import settle
from viscodesign.model.rod import Body
from viscodesign.model.several_rods import several_bodies
from viscodesign.model.structure import structure_of
from viscodesign.model.system import System
from viscodesign.model.unknowns import Sizes
from viscodesign.scene.common_period import no_period
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import SpecPart, faults_of
from viscodesign.simulation.build_problem import (
    Settings,
    assemble,
    corners_of,
    pieces_between,
    resolvable_body,
    rod_of,
    sizes_of,
    stops_of,
)
from viscodesign.solve.problem import SAME_TIME
from viscodesign.storage.distinct import distinct

SX = ca.SX

UNTRACEABLE = (TypeError, AttributeError, NotImplementedError)
"""What formulas raise that need plain numbers."""
INPUT, SCENE = "the input", "the scene"
"""What is traced, in words."""
CORNERS = "the input, two corners of which meet there,"
LAWS = "a law of the fluid or of the bellows' walls"


@dataclass(frozen=True)
class FrozenParts:
    """What a scene's free numbers do not change."""

    effects: list[type[Effect]]
    edges_per_section: int
    stated: Body
    resolved: Body
    """The same with every stiffness capped that the accuracy cannot tell from infinite."""
    sizes: Sizes

    @classmethod
    def of(
        cls, quantities: SceneQuantities, effects: Sequence[Effect], settings: Settings
    ) -> FrozenParts:
        """Those of a scene."""
        return cls(
            [type(effect) for effect in effects],
            settings.edges_per_section,
            quantities.body,
            resolvable_body(quantities),
            sizes_of(quantities),
        )

    def body_of(self, quantities: SceneQuantities) -> Body:
        """The body of a scene with other numbers, as the equations have it."""
        bodies = self.stated, self.resolved, quantities.body
        if not self.stated.members:
            return _resolved_like(*bodies)
        each = zip(*(own.members for own in bodies), strict=True)
        return several_bodies([_resolved_like(*own) for own in each])


def _resolved_like(stated: Body, resolved: Body, body: Body) -> Body:
    """A body with other numbers; those that were capped in ``resolved`` are capped as they were."""
    varied = body.varied
    if varied is not None and stated.varied and resolved.varied:
        ends = stated.varied, resolved.varied, varied
        varied = replace(
            varied,
            bending_stiffness=_where_kept(*(own.bending_stiffness for own in ends)),
            extension_stiffness=_where_kept(*(own.extension_stiffness for own in ends)),
        )
    stiffness = (own.extension_stiffness for own in (stated, resolved, body))
    return replace(body, extension_stiffness=_where_kept(*stiffness), varied=varied)


def _where_kept(stated: Any, resolved: Any, own: Any) -> Any:
    """Numbers of their own where they were not capped, else the caps."""
    if not isinstance(own, np.ndarray):
        return own if stated == resolved else resolved
    return np.where(stated == resolved, own, resolved)


class ProblemTrace:
    """All numbers of a problem as formulas in the free numbers, valid near some values.

    Raises `SpecError` for values that a part of the spec refuses, and for free numbers that the
    equations hold as constants; one of `UNTRACEABLE` where a formula needs plain numbers.
    """

    def __init__(
        self, keys: SceneKeys, values: np.ndarray, frozen: FrozenParts, tape: Tape
    ) -> None:
        self.tape = tape
        self.symbols, traced = free_numbers(keys.names, values, tape)
        tape.place = SCENE
        scene = keys.placed(traced)
        _validate_again(scene, keys.scene, ())
        system = self._system(quantities_of(scene), frozen)
        tape.place = LAWS
        settle(system, frozen.sizes)
        self.structure = self._structure(system)
        """Equal for traces of the same equations."""
        numbers = system.numbers()
        self.parameter_names = tuple(numbers)
        self.parameters = ca.vertcat(*map(formula_of, numbers.values()))
        tape.place = INPUT
        stops = stops_of(scene)
        _note_merged(scene, scene.run.duration, tape)
        pieces, initial = pieces_between(scene, stops)
        self.stops, self.pieces = matrix_of(stops), matrix_of(pieces)
        self.initial_piece = matrix_of(initial)
        self.cycle_stops, self.cycle_pieces = SX(0, 1), SX(0, len(initial))
        if scene.run.start == "periodic":
            period = _period(scene, keys.placed(values.tolist()), tape)
            stops = stops_of(scene, period)
            _note_merged(scene, period, tape)
            pieces, _ = pieces_between(scene, stops)
            self.cycle_stops, self.cycle_pieces = matrix_of(stops), matrix_of(pieces)

    def _system(self, quantities: SceneQuantities, frozen: FrozenParts) -> System:
        effects = (self._effect(kind, quantities) for kind in frozen.effects)
        rod = rod_of(quantities.body, frozen.edges_per_section)
        return assemble(quantities, effects, rod, frozen.body_of(quantities))

    def _effect(self, kind: type[Effect], quantities: SceneQuantities) -> Effect:
        self.tape.place = f"the effect {kind.name}"  # until the next one joins
        return kind.of(quantities)

    def _structure(self, system: System) -> object:
        self.tape.is_paused = True
        found = structure_of(system)
        self.tape.is_paused = False
        if self.tape.constants:
            held = {symbol.name() for symbol in ca.symvar(ca.vertcat(*self.tape.constants))}
            raise SpecError([constant_fault(name, LAWS) for name in sorted(held)])
        return found


def traced(keys: SceneKeys, values: np.ndarray, frozen: FrozenParts) -> ProblemTrace:
    """The numbers traced; raises `SpecError` with all keys that some formula needs as constants."""
    tape = Tape()
    try:
        return ProblemTrace(keys, values, frozen, tape)
    except UNTRACEABLE as error:
        if len(keys.given) == 1:
            raise SpecError([constant_fault(keys.given[0], tape.place)]) from error
    faults, half = [], len(keys.given) // 2
    for given in (keys.given[:half], keys.given[half:]):
        own = keys.only(given)
        try:
            traced(own, own.values, frozen)
        except SpecError as error:
            faults += error.faults
    raise SpecError(faults or [Fault("cannot be free together", ", ".join(keys.given))])


def constant_fault(key: str, place: str) -> Fault:
    """That a number stands in formulas as a constant."""
    return Fault(f"cannot be free: {place} holds its value as a constant", key)


def _period(scene: Scene, plain: Scene, tape: Tape) -> Any:
    """The period of all inputs, which meet as those of ``plain`` do, the same scene in numbers."""
    period, own = plain.period, []
    if period is None:
        reason = no_period(plain.inputs)
        raise SpecError.plain(f"run.start: 'periodic' needs inputs that repeat; {reason}")
    for name, source in plain.inputs.items():
        each: Any = scene.inputs[name].period
        if source.period is not None and math.isfinite(source.swing_time()):
            own.append(round(period / source.period) * each)
    for other in own[1:]:
        tape.note_equal(known(own[0]), known(other))
    return own[0]


def _note_merged(scene: Scene, duration: Any, tape: Tape) -> None:
    """Note which corners count as one although their times differ."""
    for one, other in itertools.pairwise(distinct(corners_of(scene, duration))):
        if value_of(other) - value_of(one) <= SAME_TIME * value_of(duration):
            tape.meetings.append((formula_of(one), formula_of(other)))


def _validate_again(part: SpecPart, base: SpecPart, path: tuple[str, ...]) -> None:
    """Run the checks of every changed part, so that what they take for granted is noted.

    Those of the whole scene, between its parts, ask a library for the fluid and are left out.
    """
    for (name, own, _), (_, other, _) in zip(part.keyed_fields(), base.keyed_fields(), strict=True):
        for (key, inner), (_, former) in zip(parts_in(own), parts_in(other), strict=False):
            if inner is not former:
                place = (*path, name, *key)
                _run_checks(inner, place)
                _validate_again(inner, former, place)


def _run_checks(part: SpecPart, path: tuple[str, ...]) -> None:
    """The checks of a part that look at several of its keys together."""
    for check in type(part).__pydantic_decorators__.model_validators.values():
        if check.info.mode == "after":
            try:
                check.func(part)
            except PydanticCustomError as error:
                faults = [Fault(f.message, ".".join((*path, *f.path))) for f in faults_of(error)]
                raise SpecError(faults) from None
