"""From designs to their metrics: by a compiled function where that pays, else by `simulate`."""

from __future__ import annotations

import math
import time as clock
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from viscodesign.checks.contact import has_contact
from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.function import CompiledFunction
from viscodesign.errors import SpecError, ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.sweep_table import COMPLETE, DesignResult
from viscodesign.scene.scene import Scene
from viscodesign.simulation.simulate import simulate
from viscodesign.storage.cached_property import cached_property
from viscodesign.studies.all_effects import compiled_metrics
from viscodesign.studies.designs import Design
from viscodesign.studies.swept_keys import SweptKey, changed

COMPILED_FROM = 24
"""Designs of the same equations from which a compiled function is made: that takes about as long
as so many of them take by `simulate`."""

Row = tuple[int, Design]
"""The number of a design in its table, and its values."""
Settings = tuple[Any, ...]
"""Values of the keys that make other equations."""


class DesignSolver:
    """Metrics of designs of one scene.

    ``counts``: designs with each combination of settings that make other equations. What is made
    for a combination is kept for the designs that follow; a copy in another process makes it
    again. A design depends on no other, and on its place in the table neither.
    """

    def __init__(
        self, scene: Scene, keys: Sequence[SweptKey], counts: Mapping[Settings, int]
    ) -> None:
        self.scene, self.keys, self._counts = scene, tuple(keys), dict(counts)
        self._solvers: dict[Settings, NumberSolver] = {}

    def __reduce__(self) -> tuple[Any, ...]:
        return DesignSolver, (self.scene, self.keys, self._counts)

    @classmethod
    def of(cls, scene: Scene, keys: Sequence[SweptKey], designs: Iterable[Design]) -> DesignSolver:
        """For these designs."""
        return cls(scene, keys, Counter(settings_of(keys, design) for design in designs))

    def settings_of(self, design: Design) -> Settings:
        """Its values of the keys that make other equations."""
        return settings_of(self.keys, design)

    def is_compiled(self, settings: Settings) -> bool:
        """Whether a compiled function solves the designs with these settings."""
        is_any_free = any(key.is_free for key in self.keys)
        return is_any_free and self._counts[settings] >= COMPILED_FROM

    def prepare(self) -> None:
        """Make the function that solves all designs, where there is but one."""
        for settings in self._counts if len(self._counts) == 1 else ():
            self._solver(settings).prepare()

    def solve(self, rows: Sequence[Row], within_s: float = math.inf) -> list[DesignResult]:
        """Results of rows in order, the first at least, and as many as begin within a time [s]."""
        until, found = clock.perf_counter() + within_s, []
        for number, design in rows:
            found.append(self._solved(number, design))
            if clock.perf_counter() >= until:
                break
        return found

    def _solved(self, number: int, design: Design) -> DesignResult:
        try:
            solver = self._solver(self.settings_of(design))
            return solver.result(number, numbers_of(self.keys, design))
        except ViscodesignError as error:
            return DesignResult.failed(number, str(error))
        except Exception as error:  # one design must not end the others
            return DesignResult.failed(number, f"internal error: {type(error).__name__}: {error}")

    def scene_of(self, design: Design) -> Scene:
        """The scene of a design, checked. Raises `SpecError` where it is none."""
        return self._solver(self.settings_of(design)).scene_of(numbers_of(self.keys, design))

    def _solver(self, settings: Settings) -> NumberSolver:
        if settings not in self._solvers:
            self._solvers[settings] = self._made(settings)
        return self._solvers[settings]

    def _made(self, settings: Settings) -> NumberSolver:
        own = [key for key in self.keys if not key.is_free]
        scene = changed(self.scene, dict(zip(own, settings, strict=True)))
        free = [key.name for key in self.keys if key.is_free]
        compiled = self.is_compiled(settings) and not has_contact(SceneQuantities(scene))
        return NumberSolver(scene, free, compiled=compiled)


def settings_of(keys: Sequence[SweptKey], design: Design) -> Settings:
    """A design's values of the keys that make other equations."""
    return tuple(value for key, value in zip(keys, design, strict=True) if not key.is_free)


def numbers_of(keys: Sequence[SweptKey], design: Design) -> list[float]:
    """A design's free numbers."""
    return [value for key, value in zip(keys, design, strict=True) if key.is_free]


class NumberSolver:
    """Metrics of one scene with other numbers; ``compiled`` where that is possible."""

    def __init__(self, scene: Scene, free: Sequence[str], *, compiled: bool) -> None:
        self._scene, self._is_compiled = scene, compiled
        self._keys = FreeKeys(scene, free) if free else None

    @cached_property
    def _function(self) -> CompiledFunction | None:
        if self._keys is None or not self._is_compiled:
            return None
        return compiled_metrics(self._keys)

    def prepare(self) -> None:
        """Make the compiled function."""
        _ = self._function

    def result(self, number: int, values: Sequence[float]) -> DesignResult:
        """The result of a design. Raises `SpecError` for values that are out of range."""
        if self._keys is None:
            return simulated(number, self.scene_of(values))
        faults = [n.fault(v) for n, v in zip(self._keys.numbers, values, strict=True)]
        if found := [fault for fault in faults if fault is not None]:
            raise SpecError(found)
        if self._function is not None:
            solved = self._function.batch([values])
            if solved.status == [COMPLETE]:
                metrics = [float(solved[name][0]) for name in METRIC_NAMES]
                return DesignResult(number, COMPLETE, self._function.effects, metrics)
        # It goes further where a compiled function gives up.
        return simulated(number, self.scene_of(values))

    def scene_of(self, values: Sequence[float]) -> Scene:
        """The scene with these numbers, checked."""
        return self._scene if self._keys is None else self._keys.validated(values)


def simulated(number: int, scene: Scene) -> DesignResult:
    """The result of a scene by `simulate`, at its accuracy and with no error estimate."""
    run = simulate(scene, verify=False)
    if run.status != COMPLETE:
        return DesignResult.failed(number, run.failure or run.status)
    effects = frozenset(verdict.name for verdict in run.effects if verdict.taken)
    return DesignResult(number, COMPLETE, effects, [run.metrics[name] for name in METRIC_NAMES])
