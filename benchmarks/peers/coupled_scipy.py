"""The coupled problem as a plain SciPy script: method of lines and solve_ivp.

What a competent graduate student writes who needs this one actuator: the rod as a chain
of nodes, equations vectorised with numpy over all columns that a numerical Jacobian asks
for, and SciPy's stiff solvers. BDF and Radau make that Jacobian themselves; LSODA would
make it column by column, fifteen times slower, and is handed one. No exact Jacobian, no
symbols, no files. Run it with one BLAS thread (OPENBLAS_NUM_THREADS=1): matrices of this
size are several times slower with more.

Unknowns, in this order: node positions x, z and velocities u, w (n each), and the
bellows' gauge pressures p along the chain, R1..R8, L8..L1 (16).

Rod: edges are chords of arcs, edge k from node k-1 to node k of reference length h,

    stretch  lambda_k = L_k / (h sinc(kappa_p h/2)),    N = EA (lambda - 1 - zeta)
    turn_k = angle from edge k to edge k+1,             M = EI (turn - rest)/h

at the clamp half an edge turns. Kelvin-Voigt damping adds t_v EA and t_v EI times the
rates of stretch and of turn. Nodes carry m h, the tip half of it.

Network: what flows into a bellow fills its volume V = V_0 + C p + b N + R c M, N and M
being the means of its section, R = +1 left, -1 right. In N and M the intrinsic strains
follow the pressures and the rest follows the motion, so that

    K dp/dt = inflow - b EA (rate of mean stretch) - R c EI (rate of mean curvature)

with one constant matrix K, inverted once.
"""

from __future__ import annotations

import math
from abc import ABC
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
from coupled import DURATION, LENGTH, TIMES, CoupledCase
from scipy.integrate import solve_ivp

BELLOWS, SECTIONS = 16, 8
SECTION = LENGTH / SECTIONS
HEIGHT, WIDTH = 0.030, 0.020
MODULUS = 1.8e6
EA = 0.53 * MODULUS * HEIGHT * WIDTH
EI = 0.55 * MODULUS * WIDTH * HEIGHT**3 / 12
MASS = 950.0 * 0.47 * HEIGHT * WIDTH
"""Per length [kg/m]."""
DAMPING = 1e-3
"""Kelvin-Voigt time t_v [s]."""
BELLOW_LENGTH = 0.018
COMPLIANCE = BELLOW_LENGTH * 3.413e-9
PER_FORCE, PER_MOMENT = BELLOW_LENGTH * 3.0e-7, BELLOW_LENGTH * 1.2e-6
"""Volume per force b [m3/N] and per moment c [m3/(N m)]."""
CURVATURE = 10.266 / MODULUS / SECTION
STRETCH = 0.047 / MODULUS / SECTION
"""Intrinsic curvature per pressure difference [1/(m Pa)], stretch per pressure sum [1/Pa]."""
RESISTANCE = 8 * 1.79e-5 * 0.0375 / (math.pi * 3.25e-4**4)
PROBE = 1e-7
"""Of an unknown's size, by which it is moved for a difference."""
LADDER = [
    (16, 1e-3), (16, 1e-4), (32, 1e-4), (32, 1e-5), (64, 1e-5), (64, 1e-6), (128, 1e-6),
]  # fmt: skip
"""Edges and relative tolerance, refined together."""


def inlet_pressure(t: float) -> float:
    """The published pulse, gauge [Pa]."""
    fall, rise = math.tanh(6 / 0.875 * (t - 0.5)), math.tanh(6 / 0.875 * (t - 4.0))
    return 40_410.0 + 141_300.0 / 2 * (rise - fall)


class Leg:
    """The leg with ``edges`` edges: constants, and the rate of its unknowns."""

    def __init__(self, edges: int) -> None:
        self.n, self.h = edges, LENGTH / edges
        per_section = edges // SECTIONS
        self.section = np.repeat(np.arange(SECTIONS), per_section)
        # Length that each turn stands for, and what of it lies in each section.
        self.tributary = np.full((edges, 1), self.h)
        self.tributary[0] = self.h / 2
        self.shares = np.zeros((SECTIONS, edges))
        for k in range(edges):
            self.shares[self.section[k], k] += self.h / 2
            if k > 0:
                self.shares[self.section[k - 1], k] += self.h / 2
        self.shares /= SECTION
        self.rest = SECTION * self.shares.T
        """Rest turn of each node per curvature of each section (n, S) [m]."""
        self.mass = np.full((edges, 1), MASS * self.h)
        self.mass[-1] /= 2
        self.means = np.zeros((SECTIONS, edges))
        self.means[self.section, np.arange(edges)] = 1 / per_section
        j = np.arange(SECTIONS)
        self.right, self.left = j, BELLOWS - 1 - j
        self.inverse = np.linalg.inv(self._storage())

    def _storage(self) -> np.ndarray:
        """K (16, 16) [m3/Pa]: volume per pressure with the shape of the rod held."""
        total, difference = np.zeros((2, SECTIONS, BELLOWS))
        for j in range(SECTIONS):
            total[j, [self.left[j], self.right[j]]] = STRETCH
            difference[j, self.left[j]], difference[j, self.right[j]] = CURVATURE, -CURVATURE
        force = -EA * total
        moment = -EI * self.shares @ (self.rest / self.tributary) @ difference
        return COMPLIANCE * np.eye(BELLOWS) + self._fed_back(force, moment)

    def _fed_back(self, force: np.ndarray, moment: np.ndarray) -> np.ndarray:
        """Volumes (16, k) [m3] that the sections' forces [N] and moments [N m] make."""
        volume = np.empty((BELLOWS, force.shape[1]))
        volume[self.right] = PER_FORCE * force - PER_MOMENT * moment
        volume[self.left] = PER_FORCE * force + PER_MOMENT * moment
        return volume

    def start(self) -> np.ndarray:
        """At rest under the first pressure: straight and stretched."""
        pressure = inlet_pressure(0.0)
        z = (1 + 2 * STRETCH * pressure) * self.h * np.arange(1, self.n + 1)
        still = np.zeros(self.n)
        return np.concatenate([still, z, still, still, np.full(BELLOWS, pressure)])

    def sizes(self) -> np.ndarray:
        """What is large for each unknown, for the absolute tolerance."""
        length, speed = np.full(2 * self.n, LENGTH), np.full(2 * self.n, 1.0)
        return np.concatenate([length, speed, np.full(BELLOWS, 1e5)])

    def jacobian(self, t: float, y: np.ndarray) -> np.ndarray:
        """Central differences, all columns at once."""
        width = PROBE * self.sizes()
        ahead, behind = y[:, None] + np.diag(width), y[:, None] - np.diag(width)
        return (self.rate(t, ahead) - self.rate(t, behind)) / (2 * width)

    def rate(self, t: float, y: np.ndarray) -> np.ndarray:
        """Rates of the unknowns (4 n + 16,) or of many columns of them."""
        columns = y.reshape(len(y), -1)
        x, z, u, w = columns[: 4 * self.n].reshape(4, self.n, -1)
        p = columns[4 * self.n :]
        ex, ez, eu, ew = (np.diff(v, axis=0, prepend=0.0) for v in (x, z, u, w))
        length = np.hypot(ex, ez)
        tx, tz = ex / length, ez / length
        turns = _turns(ex, ez)
        # Rates of length and angle; along a turning edge the normal is (tz, -tx).
        lengthening = tx * eu + tz * ew
        turning = np.diff((tz * eu - tx * ew) / length, axis=0, prepend=0.0)
        sum_, difference = p[self.left] + p[self.right], p[self.left] - p[self.right]
        chord = self.h * np.sinc(CURVATURE * difference * self.h / (2 * math.pi))[self.section]
        strain = length / chord - 1 - STRETCH * sum_[self.section]
        tension = EA * (strain + DAMPING * lengthening / self.h) * self.h / chord
        moment = EI / self.tributary * (turns - CURVATURE * self.rest @ difference)
        moment += EI / self.tributary * DAMPING * turning
        shear = -np.diff(moment, axis=0, append=0.0) / length
        fx, fz = tension * tx + shear * tz, tension * tz - shear * tx
        out = np.empty_like(columns)
        out[: 2 * self.n] = columns[2 * self.n : 4 * self.n]
        out[2 * self.n : 3 * self.n] = np.diff(fx, axis=0, append=0.0) / self.mass
        out[3 * self.n : 4 * self.n] = np.diff(fz, axis=0, append=0.0) / self.mass
        stretching = EA * self.means @ lengthening / self.h
        curving = EI * self.shares @ (turning / self.tributary)
        filling = _inflow(t, p) - self._fed_back(stretching, curving)
        out[4 * self.n :] = self.inverse @ filling
        return out.reshape(y.shape)


def _turns(ex: np.ndarray, ez: np.ndarray) -> np.ndarray:
    """Turn at nodes 0..n-1 [rad], the clamp's from +z."""
    before_x = np.vstack([np.zeros_like(ex[:1]), ex[:-1]])
    before_z = np.vstack([np.ones_like(ez[:1]), ez[:-1]])
    return np.arctan2(ex * before_z - ez * before_x, ex * before_x + ez * before_z)


def _inflow(t: float, p: np.ndarray) -> np.ndarray:
    """Flow into each bellow along the chain (16, k) [m3/s]."""
    inlet = np.full((1, p.shape[1]), inlet_pressure(t))
    flow = -np.diff(np.vstack([inlet, p]), axis=0) / RESISTANCE
    return -np.diff(flow, axis=0, append=0.0)


class Script(ABC):
    """One method of solve_ivp."""

    name: ClassVar[str]
    method: ClassVar[str]

    def __init__(self, case: CoupledCase) -> None:
        del case  # there is one

    def settings(self) -> list[dict[str, Any]]:
        """Edges and tolerances, coarse to fine."""
        return [{"edges": edges, "rtol": rtol} for edges, rtol in LADDER]

    def options(self, leg: Leg) -> dict[str, Any]:
        """How solve_ivp comes by its Jacobian."""
        del leg
        return {"vectorized": True}

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Matrices and start."""
        leg = Leg(setting["edges"])
        start, atol = leg.start(), setting["rtol"] * leg.sizes()
        options = self.options(leg)

        def run() -> np.ndarray:
            found = solve_ivp(
                leg.rate,
                (0.0, DURATION),
                start,
                method=self.method,
                t_eval=TIMES,
                rtol=setting["rtol"],
                atol=atol,
                **options,
            )
            if not found.success:
                raise RuntimeError(found.message)
            return np.asarray(found.y[[leg.n - 1, 2 * leg.n - 1]].T)

        return run


class Bdf(Script):
    """Variable-order BDF."""

    name = "script, BDF"
    method = "BDF"


class Radau(Script):
    """Radau IIA of order 5."""

    name = "script, Radau"
    method = "Radau"


class Lsoda(Script):
    """LSODA in Fortran."""

    name = "script, LSODA"
    method = "LSODA"

    def options(self, leg: Leg) -> dict[str, Any]:
        return {"jac": leg.jacobian}
