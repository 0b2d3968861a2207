"""Measure everything about speed anew, one after the other, and write its pages.

    python benchmarks/all.py                 # on a machine that does nothing else
    python benchmarks/all.py growth peers    # some of them

Each takes less than ten minutes there. Old results of what is measured are replaced; where a
benchmark fails, the others run all the same. Peers need `pip install exudyn fonsim`.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).parent
BENCHMARKS: dict[str, tuple[str, ...]] = {
    "leg_profile": ("leg_profile.py",),
    "derivatives": ("derivatives.py",),
    "uncertainty_cost": ("uncertainty_cost.py",),
    "growth": ("growth.py", "--again"),
    "peers": (
        "peers/race.py",
        *("--case", "network_water", "leg_8s", "cycle_fast", "cycle_slow", "release"),
        *("--contestant", "coupled_viscodesign:Rosenbrock", "coupled_viscodesign:Called"),
        *("coupled_scipy:Bdf", "network_viscodesign:Rosenbrock", "network_viscodesign:Called"),
        *("network_scipy:Bdf", "network_scipy:Lsoda", "network_fonsim"),
        *("rod_viscodesign:Rosenbrock", "rod_viscodesign:Called", "rod_exudyn"),
    ),
}
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "PYTHONPATH": str(HERE.parent)}


def main() -> None:
    """Run them; the exit code says whether all went well."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("names", nargs="*", choices=[*BENCHMARKS, []], metavar="NAME")
    names = parser.parse_args().names or list(BENCHMARKS)
    failed = [name for name in names if not succeeds(name)]
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")


def succeeds(name: str) -> bool:
    """Run one of them."""
    script, *options = BENCHMARKS[name]
    began = time.perf_counter()
    command = [sys.executable, str(HERE / script), *options]
    done = subprocess.run(command, env=os.environ | ONE_THREAD)
    print(f"{name}: {(time.perf_counter() - began) / 60:.1f} minutes", flush=True)
    return done.returncode == 0


if __name__ == "__main__":
    main()
