"""Make the coupled reference: python benchmarks/peers/make_coupled_reference.py

viscodesign's tip, refined in space and time until it stands still, beside the tip of the
script of coupled_scipy.py, which shares nothing with it: another discretisation of the
rod, of second order, another state (pressures, not volumes) and another integrator. The
script's tips at two meshes are extrapolated, which leaves an error of fourth order.
Takes a few minutes, most of it the script's.
"""

from __future__ import annotations

import os

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import coupled
import coupled_scipy
import coupled_viscodesign
import numpy as np

FINE = {"edges_per_section": 16, "tolerance": 1e-8}
COARSER = [
    {"edges_per_section": 4, "tolerance": 1e-8},
    {"edges_per_section": 8, "tolerance": 1e-8},
    {"edges_per_section": 16, "tolerance": 1e-7},
]
SCRIPT = [{"edges": edges, "rtol": 1e-7} for edges in (16, 32, 64)]
OTHERS_ALLOWED = 2e-5
"""Distance from the extrapolated script, over the length."""


def main() -> None:
    """Solve, compare, store."""
    (case,) = coupled.CASES
    solver = coupled_viscodesign.Rosenbrock(case)
    tip = solver.prepare(FINE)()
    for setting in COARSER:
        print(f"{setting}: {apart(tip, solver.prepare(setting)()):.1e} from the reference")
    idas = coupled_viscodesign.Idas(case).prepare(FINE)()
    print(f"IDAS at the same setting: {apart(tip, idas):.1e}")
    script = coupled_scipy.Bdf(case)
    tips = [script.prepare(setting)() for setting in SCRIPT]
    for setting, other in zip(SCRIPT, tips, strict=True):
        print(f"script at {setting}: {apart(tip, other):.1e}")
    extrapolated = (4 * tips[-1] - tips[-2]) / 3
    distance = apart(tip, extrapolated)
    print(f"script, last two extrapolated: {distance:.1e}")
    assert distance < OTHERS_ALLOWED
    np.savez_compressed(coupled.DATA, leg_8s=tip, leg_8s_script=extrapolated)


def apart(one: np.ndarray, other: np.ndarray) -> float:
    """Largest distance of two paths over the length."""
    return float(np.max(np.hypot(*(one - other).T))) / coupled.LENGTH


if __name__ == "__main__":
    main()
