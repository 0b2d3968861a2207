"""Two networks against a circuit simulator: bellows are capacitors, tubes resistors."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import Scene, simulate
from viscodesign.estimate.scene_quantities import SceneQuantities

SHARE_OF_SWING = 1e-5
STEP_S = 1e-4

pytestmark = pytest.mark.skipif(
    shutil.which("ngspice") is None, reason="ngspice is not installed (Debian package ngspice)"
)


def netlist(scene: Scene, source: str, times: np.ndarray) -> str:
    """Volts are pascals above the start; a farad is 1e-6 m3/Pa, so numbers stay handy."""
    quantities = SceneQuantities(scene)
    lines = ["bellows as capacitors, tubes as resistors", f"B1 inlet 0 V={source}"]
    for k, tube in enumerate(quantities.graph.tubes):
        lines.append(
            f"R{k} {tube.start} {tube.end} {float(quantities.resistances[tube.name]) * 1e-6!r}"
        )
    for k, bellow in enumerate(quantities.graph.bellows):
        lines.append(f"C{k} {bellow} 0 {quantities.bellow.compliance * 1e6!r} IC=0")
    shown = " ".join(f"v({name})" for name in quantities.graph.bellows)
    lines += [
        ".options reltol=1e-7 abstol=1e-15 vntol=1e-7 method=gear maxord=4",
        ".control",
        "set wr_singlescale",
        "set numdgt=12",
        f"tran {STEP_S} {float(times[-1])!r} 0 {STEP_S} uic",
        "linearize",
        f"wrdata out.txt {shown}",
        "quit",
        ".endc",
        ".end",
    ]
    return "\n".join(lines) + "\n"


def run_ngspice(scene: Scene, source: str, times: np.ndarray, folder: Path) -> np.ndarray:
    """Pressures above the start (T, B) at the given times."""
    (folder / "net.cir").write_text(netlist(scene, source, times))
    subprocess.run(["ngspice", "-b", "net.cir"], cwd=folder, check=True, capture_output=True)
    table = np.loadtxt(folder / "out.txt")
    return np.column_stack([np.interp(times, table[:, 0], c) for c in table[:, 1:].T])


@pytest.mark.parametrize("config", ["leg_16_straight_air", "branched_tree"])
def test_network_against_a_circuit_simulator(config: str, tmp_path: Path) -> None:
    scene = leg(
        "input={kind: double_sigmoid, start: 0 kPa, drop: 20 kPa, fall_time: 1 s, "
        "rise_time: 2.5 s, transition: 0.6 s}",
        "effects={pressure_distribution: on, others: off}",
        "run={duration: 4 s, output_interval: 0.1 s}",
        "gauge_pressure=0",
        "loads={gravity: off}",
        "accuracy=0.001 %",
        config=config,
    )
    found = simulate(scene)
    fall, rise = (f"(1+tanh(10*(time-{t})))/2" for t in (1.0, 2.5))
    # The tail of the sigmoid at t = 0 is subtracted, so that the circuit starts at rest.
    tail = 0.5 * (1 + np.tanh(-10.0)) - 0.5 * (1 + np.tanh(-25.0))
    start = float(found.pressure[0, 0])
    source = f"-20000*{fall}+20000*{rise}+20000*{float(tail)!r}"
    pressure = run_ngspice(scene, source, found.time, tmp_path) + start
    assert np.ptp(pressure) > 1e4
    assert np.max(np.abs(found.pressure - pressure)) <= SHARE_OF_SWING * np.ptp(pressure)
