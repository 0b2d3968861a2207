"""The tip by a linear network and a row of arcs: slow flow, no load, in a millisecond.

It ranks graphs and starts for the search on the scene's own model, and tells which way round the
tip of a graph goes. Bellows store volume in proportion to pressure, C p' = -G p + g u, with G the
conductances of the tubes and u the inlet's pressure; each section is an arc. Slopes are those of
the equations; over a run, where tubes change, they are sampled as coarsely as the motion is.
"""

from __future__ import annotations

import math

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.estimate.modal_response import first_order
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.inverse.arc_rod import ArcRod
from viscodesign.inverse.tree_graph import INLET, TreeGraph
from viscodesign.physics import tube as tube_laws
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.inputs.harmonics import HarmonicsInput
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import KeyPath

PHASES = 64
"""Samples of a period."""
MAX_QUICK_TIMES = 241
"""Samples of a run with free timing."""
POWERS = {"length": 1, "tube_length": 1, "radius": -4, "tube_radius": -4, "viscosity": 1}
"""With which a resistance goes with a number."""
SHARED_SIZES = {("network", "tube_length"): "length", ("network", "tube_radius"): "radius"}
"""Sizes that tubes without their own have, by their places."""
INPUT_STEP = 1e-6
"""Step of differences by a number of the input, as a part of its range or its size."""


class QuickMotion:
    """The tip of one tree as a function of a scene's free numbers: a `TipModel`.

    ``keys``: of a scene whose tubes are in the order of those of the tree,
    as a custom layout without feed line.
    """

    def __init__(self, keys: FreeKeys, graph: TreeGraph, times: np.ndarray | None = None) -> None:
        self._keys, self._names = keys, keys.names
        scene = keys.scene
        quantities = SceneQuantities(scene)
        self._rod, self._stored = ArcRod.of(quantities), quantities.bellow.compliance
        self._is_periodic = scene.run.start == "periodic"
        self._times = times
        ends = np.array(graph.edges)
        count = scene.bellows.count
        self._drops = np.zeros((len(ends), count))
        inner = ends[:, 0] != INLET
        self._drops[np.arange(len(ends)), ends[:, 1]] = 1.0
        self._drops[np.flatnonzero(inner), ends[inner, 0]] = -1.0
        self._fed = np.where(inner, 0.0, 1.0)
        self._inputs = [k for k, name in enumerate(self._names) if name.startswith("input.")]
        self._kept: tuple[bytes, np.ndarray, np.ndarray] | None = None

    def tip(self, values: np.ndarray) -> np.ndarray:
        """(T, 2) [m]"""
        return self._rod.tip(self._pressures(values)[0])

    def slopes(self, values: np.ndarray) -> np.ndarray:
        """(T, 2, f)"""
        pressure, slopes = self._pressures(values, with_slopes=True)
        found: np.ndarray = np.einsum("tcb,tbf->tcf", self._rod.slopes(pressure), slopes)
        return found

    def network(self, values: np.ndarray) -> tuple[np.ndarray, np.ndarray, float]:
        """G (B, B), g (B,) and the compliance of a bellow."""
        scene = self._keys.placed([float(value) for value in values])
        return *self._network(self._resistances(scene, values)[0]), self._stored

    def _network(self, resistance: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """G (B, B) and g (B,) for resistances (Q,)."""
        conductance = 1 / resistance
        matrix = (self._drops.T * conductance) @ self._drops
        return matrix, self._drops.T @ (conductance * self._fed)

    def _pressures(
        self, values: np.ndarray, *, with_slopes: bool = False
    ) -> tuple[np.ndarray, np.ndarray]:
        """(T, B) and (T, B, f) [Pa]"""
        scene = self._keys.placed([float(value) for value in values])
        resistance, by_number = self._resistances(scene, values)
        matrix, feed = self._network(resistance)
        solve = self._cycle if self._is_periodic else self._run
        return solve(
            scene, values, matrix, feed, -by_number / resistance[:, None] ** 2, with_slopes
        )

    def _resistances(self, scene: Scene, values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(Q,) of the tubes, and slopes (Q, f)."""
        tubes = scene.graph.tubes
        mu = scene.fluid.viscosity
        found = np.array([tube_laws.hydraulic_resistance(mu, t.length, t.radius) for t in tubes])
        slopes = np.zeros((len(found), len(values)))
        entries = scene.network.tubes or ()
        for k, number in enumerate(self._keys.numbers):
            power = POWERS.get(number.path[-1], 0)
            if number.path[:2] == ("network", "tubes"):
                own = [int(number.path[2])]
            elif number.path in SHARED_SIZES:
                key = SHARED_SIZES[number.path]
                own = [q for q, entry in enumerate(entries) if getattr(entry, key) is None]
            else:
                own = list(range(len(tubes))) if number.path == ("fluid", "viscosity") else []
            slopes[own, k] = power * found[own] / values[k]
        return found, slopes

    def _inlet(self, scene: Scene, times: np.ndarray) -> np.ndarray:
        (source,) = scene.inputs.values()
        return scene.gauge_pressure + source.values(times)

    def _inlet_slopes(self, values: np.ndarray, shares: np.ndarray, end: float) -> np.ndarray:
        """(T, f) of the inlet's pressure, by differences at shares of the run or the period."""
        found = np.zeros((len(shares), len(values)))
        (scene_input,) = self._keys.scene.inputs.values()
        for k, name in enumerate(self._names):
            if k not in self._inputs and name != "gauge_pressure":
                continue
            known = self._harmonic_slope(self._keys.numbers[k].path, scene_input, shares, end)
            if known is not None:
                found[:, k] = known
                continue
            step = INPUT_STEP * max(abs(values[k]), 1.0)
            ends = []
            for sign in (1, -1):
                moved = values.copy()
                moved[k] += sign * step
                scene = self._keys.placed([float(value) for value in moved])
                (source,) = scene.inputs.values()
                span = (source.period or end) if self._is_periodic else end
                ends.append(self._inlet(scene, shares * span))
            found[:, k] = (ends[0] - ends[1]) / (2 * step)
        return found

    def _harmonic_slope(
        self, path: KeyPath, source: Input, shares: np.ndarray, end: float
    ) -> np.ndarray | None:
        """(T,) Of a sum of harmonics by one of its numbers; None where differences have to do."""
        if not isinstance(source, HarmonicsInput):
            return None
        if path == ("input", "mean"):
            return np.ones(len(shares))
        if path == ("input", "period") and self._is_periodic:
            return np.zeros(len(shares))
        if path[0] != "input" or path[1] not in ("cosine", "sine"):
            return None
        rounds = shares if self._is_periodic else shares * end / source.period
        turns = 2 * math.pi * (int(path[2]) + 1) * rounds
        return np.cos(turns) if path[1] == "cosine" else np.sin(turns)

    # -- limit cycles, harmonic by harmonic ------------------------------------------

    def _cycle(
        self,
        scene: Scene,
        values: np.ndarray,
        matrix: np.ndarray,
        feed: np.ndarray,
        by_number: np.ndarray,
        with_slopes: bool,
    ) -> tuple[np.ndarray, np.ndarray]:
        (source,) = scene.inputs.values()
        period = float(source.period or scene.run.duration)
        shares = np.arange(PHASES) / PHASES
        drive = np.fft.rfft(self._inlet(scene, shares * period))
        rates = 2j * math.pi * np.arange(len(drive)) / period * self._stored
        inverse = np.linalg.inv(matrix[None] + rates[:, None, None] * np.eye(len(matrix)))
        found = (inverse @ feed) * drive[:, None]
        pressure = np.fft.irfft(found, PHASES, axis=0)
        if not with_slopes:
            return self._at_times(pressure, period), np.zeros(0)
        drops = found @ self._drops.T - drive[:, None] * self._fed
        forced = -(self._drops.T @ (drops[:, :, None] * by_number))
        for k, name in enumerate(self._names):
            if name in ("input.period", "input.frequency"):
                change = -1 / period if name == "input.period" else period
                forced[:, :, k] -= rates[:, None] * found * change
        moved = np.fft.rfft(self._inlet_slopes(values, shares, period), axis=0)
        forced += feed[None, :, None] * moved[:, None, :]
        slopes = np.fft.irfft(inverse @ forced, PHASES, axis=0)
        return self._at_times(pressure, period), self._at_times(slopes, period)

    def _at_times(self, rows: np.ndarray, period: float) -> np.ndarray:
        """Rows (PHASES, ...) of a period at given times, or as they are."""
        if self._times is None:
            return rows
        places = (self._times / period % 1.0) * PHASES
        before = places.astype(int) % PHASES
        share = (places % 1.0).reshape(-1, *(1,) * (rows.ndim - 1))
        found: np.ndarray = (1 - share) * rows[before] + share * rows[(before + 1) % PHASES]
        return found

    # -- runs, mode by mode --------------------------------------------------------

    def _run(
        self,
        scene: Scene,
        values: np.ndarray,
        matrix: np.ndarray,
        feed: np.ndarray,
        by_number: np.ndarray,
        with_slopes: bool,
    ) -> tuple[np.ndarray, np.ndarray]:
        times = self._run_times(scene)
        drive = self._inlet(scene, times)
        rate, modes = np.linalg.eigh(matrix)
        begins = drive[0] if scene.run.start == "equilibrium" else scene.gauge_pressure
        pressure = self._followed(rate, modes, times, drive[:, None] * feed, begins)
        if not with_slopes:
            return pressure, np.zeros(0)
        drops = pressure @ self._drops.T - drive[:, None] * self._fed
        forced = -(self._drops.T @ (drops[:, :, None] * by_number))
        moved = self._inlet_slopes(values, times / times[-1], float(times[-1]))
        forced += feed[None, :, None] * moved[:, None, :]
        starts = moved[0] if scene.run.start == "equilibrium" else np.zeros(len(values))
        slopes = [
            self._followed(rate, modes, times, forced[:, :, k], starts[k])
            for k in range(len(values))
        ]
        return pressure, np.stack(slopes, axis=2)

    def _run_times(self, scene: Scene) -> np.ndarray:
        if self._times is not None:
            return self._times
        own = scene.run.output_times_array()
        return own if len(own) <= MAX_QUICK_TIMES else np.linspace(own[0], own[-1], MAX_QUICK_TIMES)

    def _followed(
        self,
        rate: np.ndarray,
        modes: np.ndarray,
        times: np.ndarray,
        forced: np.ndarray,
        begins: float,
    ) -> np.ndarray:
        """Solutions (T, B) of C y' = -G y + forced (T, B), from one level of all bellows."""
        start = modes.T @ np.full(len(modes), begins)
        drive = (forced @ modes / self._stored).T
        return np.asarray((modes @ first_order(-rate / self._stored, times, drive, start)).T)
